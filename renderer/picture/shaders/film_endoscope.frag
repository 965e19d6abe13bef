#version 450 core
#define ENDOSCOPE
#include "film.glsl"

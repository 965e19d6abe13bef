#version 450 core
#define ENDOSCOPE
#include "metal.glsl"

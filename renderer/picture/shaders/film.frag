#version 450 core
#include "film.glsl"

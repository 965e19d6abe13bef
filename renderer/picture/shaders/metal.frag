#version 450 core
#include "metal.glsl"

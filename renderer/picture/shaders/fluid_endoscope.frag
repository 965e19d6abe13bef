#version 450 core
#define ENDOSCOPE
#include "fluid.glsl"

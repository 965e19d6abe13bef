#version 450 core
#define FRAME_FROM_VERTICES
#include "fluid.glsl"

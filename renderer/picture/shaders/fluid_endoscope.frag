#version 450 core
#define FRAME_FROM_VERTICES
#define ENDOSCOPE
#include "fluid.glsl"

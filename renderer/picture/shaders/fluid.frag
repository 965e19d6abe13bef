#version 450 core
#include "fluid.glsl"

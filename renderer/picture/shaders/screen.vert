#version 450 core
#include "screen.glsl"

void main() { cover_screen(); }

#version 450 core

// Depth alone, seen from the key light.

layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 light_matrix;

void main() { gl_Position = light_matrix * vec4(position, 1.0); }

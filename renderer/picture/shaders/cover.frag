#version 450 core

// How much of the light a piece of the scene takes from the floor: all of the key light (green), and of the light from all
// around (red) the more, the nearer it is.

layout(location = 0) in float height;
layout(location = 0) out vec2 cover;

void main() { cover = vec2(exp(-7.0 * max(height, 0.0)), 1.0); }

#version 450 core

// How much of the sky a piece of the scene takes from the floor below it: the nearer, the more.

layout(location = 0) in float height;
layout(location = 0) out float cover;

void main() { cover = exp(-7.0 * max(height, 0.0)); }

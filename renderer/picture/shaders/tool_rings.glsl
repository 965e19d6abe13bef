// Read by shaders and by ToolShape.cpp alike.

const float kToolRings = 90.0;  // rings of a handle over the scene's size

#version 450 core
#include "screen.glsl"
#include "look.glsl"

// The whole picture, with the look of the part that is shaded.

layout(std140, binding = 1) uniform Look { LOOK_FIELDS(highp) } look;
out LookOfVertices { LOOK_FIELDS(flat) } passed;

void main() {
  cover_screen();
  passed.flesh = look.flesh;
  passed.blood = look.blood;
  passed.fat = look.fat;
  // Pixels raise it to a power.
  passed.through = vec4(look.through.rgb, log2(max(look.through.w, 1e-6)));
  passed.scatter = look.scatter;
  passed.vessels = look.vessels;
  passed.relief = look.relief;
  passed.pattern = look.pattern;
  passed.tree_middle = look.tree_middle;
  passed.tree_along = look.tree_along;
  passed.tree_across = look.tree_across;
  passed.tree_aside = look.tree_aside;
  passed.lamp_size = look.lamp_size;
}

// The look of a part of the tissue. The fields are explained in LookUniforms.hpp, which fills them. Like those of the
// frame they come to the fragments flat from the vertices.
#define LOOK_FIELDS(how) \
  how vec4 flesh; \
  how vec4 blood; \
  how vec4 fat; \
  how vec4 through; \
  how vec4 scatter; \
  how vec4 vessels; \
  how vec4 relief; \
  how vec4 pattern; \
  how vec4 tree_middle; \
  how vec4 tree_along; \
  how vec4 tree_across; \
  how vec4 tree_aside; \
  how float lamp_size;

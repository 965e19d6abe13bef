// What metal needs to mirror what the picture shows: its colour of the tissue, the line of sight (of length one), and the
// rows of view_projection for the two axes of the screen. Their fourth numbers, the second times the depth on the screen,
// are together 1 / depth in metres. Like the fields of the frame they come to the fragments flat from the vertices.
#define MIRROR_FIELDS(how) \
  how vec4 tissue; \
  how vec4 line_of_sight; \
  how vec4 clip_x; \
  how vec4 clip_y;

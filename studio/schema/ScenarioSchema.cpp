#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

ValueSchema include_value() {
  ValueSchema files = list_value(path_value());
  files.single = true;
  files.example = "[tissue.yaml, camera.yaml]";
  return files;
}

MappingSchema make_scenario() {
  MappingSchema scenario{.name = "scenario", .documentation = "A scenario file as a whole."};
  scenario.keys = {
      {"thinwall", integer_value(1, 1, "1"), true, {}, "version of the format"},
      {"title", text_value(), false, {}, "shown over the video; the file's name when absent"},
      {"include",
       include_value(),
       false,
       {},
       "files whose keys are merged below this file's: the nearest wins, a later file over an earlier one"},
      {"parameters",
       {.kind = ValueKind::kParameters},
       false,
       "{}",
       "names with defaults, used as `${name}` in any value, overridden with `--set name=value`"},
      {"bodies", bodies_schema(), true, {}, "what is deformed, by name"},
      {"tools", tools_schema(), false, "{}", "what touches the bodies, by name"},
      {"timeline", timeline_schema(), false, "[]",
       "what happens: clips that follow one another, or begin at their `start`"},
      {"simulation", simulation_schema(), false, "{}", "how time and equilibrium are computed"},
      {"camera", camera_schema(), false, "{}", "from where the picture is taken"},
      {"cameras", cameras_schema(), false, "{}", "more cameras, by name"},
      {"cuts", cuts_schema(), false, "[]",
       "which cameras are shown when, ascending in time; `camera` before the first"},
      {"comparison",
       comparison_schema(),
       false,
       {},
       "a second take of the same scenario with something changed, shown in the right half of the same pictures"},
      {"lights", lights_schema(), false, "{}", "what lights the scene"},
      {"look", look_schema(), false, "{}", "appearance of tissue, background and overlays"},
      {"teaching", teaching_schema(), false, "{}", "labels, arrows, cards, freezes and slow motion of the recording"},
      {"record", record_schema(), false, "{}", "size and kind of the recording"},
      {"golden", golden_schema(), false, "[]", "moments whose pictures are compared with approved ones"},
      {"expect", expectations_schema(), false, "[]", "what must come out of a run"},
  };
  return scenario;
}

}  // namespace

const MappingSchema& scenario_schema() {
  static const MappingSchema scenario = make_scenario();
  return scenario;
}

ValueSchema simulation_schema() {
  const ValueSchema gravity = usually(vector_value(kAcceleration, {}, "[0, 0, -9.81 m/s^2]"), kUsualGravity);
  MappingSchema simulation{.name = "simulation", .documentation = "How time and equilibrium are computed."};
  simulation.keys = {
      {"analysis", word_value({"dynamic", "quasi_static"}), false, "dynamic",
       "with inertia, or a sequence of equilibria without it"},
      {"time_step", quantity_value(kTime, {.minimum = 0, .maximum = 1, .minimum_excluded = true}, "5 ms"), false,
       "5 ms", "time between two states"},
      {"gravity", gravity, false, "[0, 0, 0]",
       "acceleration of free fall; the fluid's pressure then grows downwards by density times it"},
      {"step_error",
       quantity_value(kLength, {.minimum = 1e-9}, "0.01 mm"),
       false,
       {},
       "allowed error of a time step in dynamics, which is divided to keep it; not judged when absent"},
      {"tolerance", quantity_value(kDimensionless, {.minimum = 1e-12, .maximum = 1e-3}, "1e-4"), false, "1e-9",
       "residual force over the largest force at which an equilibrium is found; a looser one takes fewer iterations, "
       "and books of energy close to it only"},
  };
  return mapping_value({simulation});
}

}  // namespace thinwall

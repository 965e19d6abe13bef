#include "renderer/image/PictureCorner.hpp"
#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

const std::string kAngleWords = "vertical angle of view";
const std::string kOwnAngleWords =
    kAngleWords + "; without `position` a narrower one only moves the camera back: `push_in` shows less";

ValueSchema angle_value() {
  const double half_turn = parse_quantity("180 deg").value;
  return quantity_value(
      kAngle, {.minimum = 0, .maximum = half_turn, .minimum_excluded = true, .maximum_excluded = true}, "30 deg");
}

ValueSchema elevation_value() {
  return quantity_value(kAngle, {.minimum = 0, .maximum = parse_quantity("89 deg").value}, "45 deg");
}

ValueSchema place_value() {
  return vector_value(kLength, {}, "[80 mm, -60 mm, 50 mm]");
}

KeySchema ease_key() {
  return {"ease", word_value({"linear", "smooth"}), false, "smooth",
          "at constant speed, or starting and ending at rest"};
}

KeySchema time_key(const std::string& key, const std::string& example, const std::string& documentation) {
  return {key, quantity_value(kTime, kFromZero, example), true, {}, documentation};
}

ValueSchema keyframes_value() {
  MappingSchema keyframe{.name = "keyframe",
                         .documentation = "Where a camera is at a time; what is absent is the camera's own."};
  keyframe.keys = {
      time_key("at", "1.5 s", "when"),
      {"position", place_value(), false, {}, "where the camera stands"},
      {"target", place_value(), false, {}, "what it looks at"},
      {"up", direction_value(), false, {}, "what is up in the picture; not along the line of sight"},
      {"field_of_view", angle_value(), false, {}, kAngleWords},
      {"ease", word_value({"linear", "smooth"}), false, "smooth",
       "the way to here from the keyframe before: at constant speed, or starting and ending at rest"},
  };
  return list_value(mapping_value({keyframe}));
}

ValueSchema follow_value() {
  MappingSchema follow{.name = "follow", .documentation = "Keeps a tool's tip in the middle of the picture."};
  follow.keys = {
      {"tool", name_value(), false, {}, "which tool; may be left out when there is one only"},
      {"smooth", quantity_value(kTime, kFromZero, "0.4 s"), false, "0.4 s",
       "how soft the camera is: it lags behind a steady tool by this time"},
      {"how", word_value({"travel", "pan"}), false, "travel",
       "`travel` goes along with the tool at the distance from the target; `pan` stays in place and turns"},
  };
  return mapping_value({follow});
}

ValueSchema lens_value() {
  const Range range{.minimum = -10, .maximum = 10};
  MappingSchema lens{.name = "lens",
                     .documentation =
                         "Distortion with OpenCV's coefficients: of the radial polynomial 1 + k1 r^2 + k2 "
                         "r^4 + k3 r^6, and tangential ones. The field of view is that of the picture; a lens that "
                         "folds the picture over before its border is an error, which tells how wide it may be."};
  for (const char* key : {"k1", "k2", "p1", "p2", "k3"}) {
    lens.keys.push_back(
        {key, quantity_value(kDimensionless, range, "-0.2"), false, "0", key[0] == 'k' ? "radial" : "tangential"});
  }
  return mapping_value({lens});
}

ValueSchema push_in_value() {
  MappingSchema push_in{.name = "push_in", .documentation = "Goes nearer to the target, and stays there."};
  push_in.keys = {
      time_key("from", "1 s", "when it begins"),
      time_key("until", "2 s", "when it ends"),
      {"to",
       quantity_value(kDimensionless, {.minimum = 0.01, .maximum = 100}, "0.5"),
       true,
       {},
       "distance to the target afterwards, as part of that before; above 1 it goes away"},
      ease_key(),
  };
  return list_value(mapping_value({push_in}));
}

std::vector<CaseSchema> camera_kinds() {
  return {
      {"pinhole", "stands in the open", {{"field_of_view", angle_value(), false, "30 deg", kOwnAngleWords}}},
      {"endoscope",
       "in a body: a round picture, darker towards its border",
       {{"field_of_view", angle_value(), false, "60 deg", kOwnAngleWords}}},
  };
}

MappingSchema camera_mapping(const std::string& name, const std::string& documentation) {
  MappingSchema camera{.name = name, .documentation = documentation, .selector = "kind", .cases = camera_kinds()};
  camera.keys = {
      {"kind", word_value({"pinhole", "endoscope"}), false, "pinhole", "how the picture is projected"},
      {"position", place_value(), false, {}, "where the camera stands"},
      {"target", place_value(), false, {}, "what it looks at"},
      {"facing",
       direction_value(),
       false,
       {},
       "the sense in which a camera without `position` looks; when absent, from the side that the tools come from, at "
       "the `elevation` if there is one"},
      {"elevation",
       elevation_value(),
       false,
       {},
       "how steeply a camera without `position` and `facing` looks down: 0 deg from the side, 89 deg from above; when "
       "absent 33 deg, and 55 deg where blades cut from above"},
      {"up",
       direction_value(),
       false,
       {},
       "what is up in the picture; not along the line of sight; against gravity when absent, +z where there is none"},
      {"orbit_speed", quantity_value(kAngularSpeed, {}, "10 deg/s"), false, "0 deg/s",
       "turn around the upward axis through the target, into and out of which it eases within 0.8 s; a camera without "
       "`position` goes back on its way as far as the organs ask for, which stay in the picture"},
      {"exposure", quantity_value(kDimensionless, {.minimum = -10, .maximum = 10}, "0.5"), false, "0",
       "brighter by this power of two"},
      {"keyframes", keyframes_value(), false, "[]",
       "where the camera is at times, ascending; between two it goes round the target on the shorter arc"},
      {"follow", follow_value(), false, {}, "keeps a tool's tip in the middle of the picture"},
      {"lens", lens_value(), false, {}, "how the lens bends rays off the pinhole's; not at all when absent"},
      {"aperture", quantity_value(kLength, {.minimum = 0, .maximum = 0.1}, "0.8 mm"), false, "0 m",
       "across the lens's opening: the wider, the less is in focus before and behind `focus`; all is where it is 0"},
      {"focus",
       quantity_value(kLength, {.minimum = 0.0001, .maximum = 100}, "60 mm"),
       false,
       {},
       "distance along the line of sight at which the picture is sharp; that of the target when absent"},
      {"auto_exposure", boolean_value(), false, "false",
       "exposes for the walls that are seen, as the picture's light and place ask, by at most two powers of two, dark "
       "organs less; `exposure` comes on top"},
      {"noise", quantity_value(kDimensionless, {.minimum = 0, .maximum = 50}, "1.5"), false, "0",
       "noise of the sensor: standard deviation at mid-grey in 8-bit levels; less towards black and white"},
      {"seed", integer_value(0, 999999, "1"), false, "1", "of the noise"},
      {"push_in", push_in_value(), false, "[]", "goes nearer to the target, one time after the other"},
  };
  return camera;
}

}  // namespace

ValueSchema camera_schema() {
  return mapping_value({camera_mapping("camera",
                                       "What is absent is chosen so that the bodies fill the picture; where "
                                       "they grow out of it, a camera without `position` goes back. Its "
                                       "moves are applied one after the other: keyframes, follow, push-in, "
                                       "orbit.")});
}

ValueSchema cameras_schema() {
  MappingSchema camera = camera_mapping("named camera", "As `camera`. Lamps in the open stay where `camera` has them.");
  camera.keys.push_back({"lamp",
                         quantity_value(kDimensionless, {.minimum = 0, .maximum = 100}, "1"),
                         false,
                         {},
                         "lamp beside its lens, in place of key and fill light; when absent that of `lights`, if given "
                         "there, else 1 with the kind `endoscope` and 0 with others"});
  return named_value(std::move(camera));
}

ValueSchema cuts_schema() {
  MappingSchema cut{.name = "cut", .documentation = "What is shown from a time on."};
  cut.keys = {
      time_key("at", "1.5 s", "from when"),
      {"camera", name_value(), false, "main", "which of `cameras`; `main` is `camera` itself"},
      {"beside", name_value(), false, {}, "the camera of the right half, `camera` having the left"},
      {"inset", name_value(), false, {}, "the camera of a small picture in a corner"},
      {"corner",
       word_value({kCornerWords.begin(), kCornerWords.end()}),
       false,
       {},
       "where the small picture is; when absent `upper_right`, or where that would cover what clips do or labels point "
       "at, the corner in which it covers least of that"},
  };
  return list_value(mapping_value({cut}));
}

}  // namespace thinwall

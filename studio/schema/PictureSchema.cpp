#include "renderer/image/PictureCorner.hpp"
#include "renderer/look/DataView.hpp"
#include "renderer/look/FluidLooks.hpp"
#include "renderer/look/Ground.hpp"
#include "renderer/look/OrganLooks.hpp"
#include "renderer/overlay/OverlayChoice.hpp"
#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

ValueSchema color_value() {
  return vector_value(kDimensionless, kFromZeroToOne, "[0.7, 0.3, 0.3]");
}

KeySchema strength_key(const std::string& key, const std::string& documentation) {
  return {key, quantity_value(kDimensionless, {.minimum = 0, .maximum = 100}, "1"), false, "1", documentation};
}

KeySchema shown_key(const OverlayRow& row) {
  const char* fallback = OverlayChoice{}.*row.is_shown ? "true" : "false";
  return {std::string(row.key), boolean_value(), false, fallback, std::string(row.documentation)};
}

Dimension dimension_of(std::string_view unit) {
  if (unit == "Pa") return kPressure;
  return unit == "m" ? kLength : kDimensionless;
}

MappingSchema data_schema() {
  MappingSchema data{.name = "data",
                     .documentation =
                         "A quantity in colours (viridis) with a legend. The ends of the colours are needed by "
                         "`run`, `still` and `golden`; `render` takes those that are absent from the whole "
                         "take, rounded; what little of the wall bears, and what is held fast, may lie beyond."};
  data.selector = "shows";
  std::vector<std::string> words;
  for (const DataQuantityRow& row : data_quantities()) {
    const Dimension dimension = dimension_of(row.unit);
    const std::string example = dimension == kPressure ? "20 kPa" : dimension == kLength ? "2 mm" : "0.2";
    const ValueSchema end = quantity_value(dimension, {}, example);
    words.emplace_back(row.word);
    data.cases.push_back({words.back(),
                          std::string(row.documentation),
                          {{"from", end, false, {}, "what the darkest colour stands for"},
                           {"to", end, false, {}, "what the lightest colour stands for"}}});
  }
  std::vector<std::string> scales;
  for (const auto& [word, scale] : kDataScales) scales.emplace_back(word);
  data.keys = {
      {"shows", word_value(words), true, {}, "which quantity"},
      {"scale", word_value(scales), false, "linear",
       "linear: colours go evenly with the quantity; root: with the square root of its place between the ends, "
       "which shows the low end where few reach the high one"},
      {"legend",
       word_value({kCornerWords.begin(), kCornerWords.end()}),
       false,
       {},
       "where the legend stands, `upper_left` beside a `comparison` as `lower_left`, whose captions are above; when "
       "absent `upper_right`, or where that would cover what clips do or labels point at, the corner in which it "
       "covers least of that"}};
  return data;
}

}  // namespace

ValueSchema comparison_schema() {
  ValueSchema captions = list_value(text_value(), 2);
  captions.maximum_items = 2;
  captions.example = "[\"Wall ${thickness} thick\", \"Wall ${thickness} thick\"]";
  MappingSchema comparison{.name = "comparison",
                           .documentation =
                               "Both takes are simulated and shown side by side at the same time, until the first "
                               "ends; goldens and expectations are the first take's."};
  comparison.keys = {
      {"set",
       {.kind = ValueKind::kChanges},
       true,
       {},
       "what the second take has different: parameters by their names, or values by their paths, "
       "`bodies.organ.wall.thickness: 3 mm`, `timeline[1].palpate.depth: 6 mm`"},
      {"captions",
       captions,
       true,
       {},
       "what is written over the left and the right half; a parameter in a caption has the value of its own take"},
  };
  return mapping_value({comparison});
}

ValueSchema lights_schema() {
  MappingSchema lights{.name = "lights", .documentation = "Strengths are relative to a well-lit picture."};
  lights.keys = {
      strength_key("key", "key light, which casts the shadow"),
      strength_key("fill", "fill light"),
      strength_key("environment", "light from all around"),
      {"key_direction",
       direction_value(),
       false,
       {},
       "from the scene to the key light; chosen with the camera when absent"},
      {"endoscope",
       quantity_value(kDimensionless, {.minimum = 0, .maximum = 100}, "1"),
       false,
       {},
       "lamp beside the lens, in place of key and fill light; its light falls with the square of the distance and "
       "makes the "
       "middle of the scene well lit. When absent, 1 with a camera of the kind `endoscope`, else 0"},
  };
  return mapping_value({lights});
}

MappingSchema tissue_schema() {
  MappingSchema tissue{.name = "tissue look", .documentation = "How the wall of a body looks."};
  std::vector<std::string> organs;
  std::string kinds = "what kind of tissue it is";
  for (const OrganLook& organ : organ_looks()) {
    organs.emplace_back(organ.organ);
    kinds += (organs.size() == 1 ? ": `" : "; `") + organs.back() + "`, " + std::string(organ.documentation);
  }
  kinds += ". When absent, the one whose name is part of the body's name or its mesh file's, else `tissue`";
  std::vector<std::string> fluids;
  std::string known_fluids = "what fills it";
  for (const NamedFluid& fluid : fluid_looks()) {
    fluids.emplace_back(fluid.fluid);
    known_fluids += (fluids.size() == 1 ? ": `" : "; `") + fluids.back() + "`, " + std::string(fluid.documentation);
  }
  tissue.keys = {
      {"organ", word_value(organs), false, {}, kinds},
      {"color", color_value(), false, {}, "sRGB colour of the tissue, each part from 0 to 1; the organ's when absent"},
      {"roughness",
       quantity_value(kDimensionless, kFromZeroToOne, "0.45"),
       false,
       {},
       "of the tissue below the wet layer; the organ's when absent"},
      {"wetness",
       quantity_value(kDimensionless, kFromZeroToOne, "0.7"),
       false,
       {},
       "strength of the wet layer; the organ's when absent"},
      {"contents",
       word_value(fluids),
       false,
       {},
       known_fluids +
           ". Seen where the body is open, up to the level that `fluid_volume_m3` gives; the organ's when absent"},
      {"bleeding",
       quantity_value(kDimensionless, kFromZeroToOne, "1"),
       false,
       {},
       "how freely the wall bleeds where it is cut or punctured; the organ's when absent"},
  };
  return tissue;
}

ValueSchema look_schema() {
  MappingSchema overlays{.name = "overlays", .documentation = "What is written over the picture."};
  for (const OverlayRow& row : kOverlayRows) overlays.keys.push_back(shown_key(row));
  std::vector<std::string> grounds;
  for (const auto& [word, ground] : kGrounds) grounds.emplace_back(word);
  MappingSchema look{.name = "look", .documentation = "Appearance."};
  look.keys = {
      {"background", color_value(), false, "[0.055, 0.065, 0.08]", "sRGB colour, each part from 0 to 1"},
      {"ground",
       word_value(grounds),
       false,
       {},
       "what lies below the bodies, at their lowest z, or across gravity where that pulls more sideways than along -z, "
       "but for what an endoscope's lamp lights: `floor`, of a studio, in the tone of the background; `drape`, the "
       "green-blue cloth of an operation, in folds, which a sheet lies on. When absent, `drape` where a body is a "
       "sheet or otherwise open without a cut, and `floor` where none is, with `data` and with `mesh`"},
      {"bodies", named_value(tissue_schema()), false, "{}", "looks by the names of bodies"},
      {"overlays", mapping_value({overlays}), false, "{}", "what is written over the picture"},
      {"data",
       mapping_value({data_schema()}),
       false,
       {},
       "a quantity of the walls in colours, in place of their tissue and of fluids; cuts are orange lines, and scenery "
       "is grey"},
      {"mesh", boolean_value(), false, "false", "draw the edges of the triangles, those of cuts stronger"},
  };
  return mapping_value({look});
}

ValueSchema record_schema() {
  ValueSchema side = integer_value(16, 8192, "1280");
  // Video with halved colour resolution needs even sides.
  side.multiple_of = 2;
  ValueSchema size = list_value(side, 2);
  size.maximum_items = 2;
  size.example = "[1280, 720]";
  MappingSchema record{.name = "record", .documentation = "The recording."};
  record.keys = {
      {"size", size, false, "[1280, 720]", "width and height in pixels, even numbers"},
      {"fps", quantity_value(kDimensionless, {.minimum = 1, .maximum = 240}, "30"), false, "30", "pictures per second"},
      {"video", boolean_value(), false, "true", "whether a video is made"},
      {"tier", word_value({"draft", "record", "final"}), false, "record",
       "draft: without shadow and anti-aliasing; record: with both; final: moreover with finer shadows, and with "
       "highlights, edges and fluids of five samples for each pixel"},
      {"points", recorded_points_schema(), false, "{}",
       "points of walls whose motion is written to points.csv, by name"},
  };
  return mapping_value({record});
}

namespace {

/// The limits of a golden, in the words of `what`.
std::vector<KeySchema> golden_limits() {
  const Range levels{.minimum = 0, .maximum = 255};
  return {
      {"max", quantity_value(kDimensionless, levels, "8"), true, {}, "largest allowed difference, 8-bit levels"},
      {"mean",
       quantity_value(kDimensionless, levels, "0.2"),
       true,
       {},
       "largest allowed mean difference, 8-bit levels"},
      {"drift", quantity_value(kDimensionless, kFromZeroToOne, "0.001"), false, "0.001",
       "largest allowed change of the mean of red, green or blue, as a part of it: what a light, a gain or a hue "
       "changes and rounding does not"},
      {"failing",
       quantity_value(kDimensionless, kFromZeroToOne, "0.001"),
       false,
       {},
       "largest allowed fraction of pixels that fail by `level` and `shift`"},
      {"level", integer_value(0, 255, "2"), false, "0", "8-bit levels by which a pixel may differ without failing"},
      {"shift", integer_value(0, 4, "1"), false, "0", "pixels by which what a pixel shows may lie elsewhere"},
      {"ssim",
       quantity_value(kDimensionless, {.minimum = -1, .maximum = 1}, "0.999"),
       false,
       {},
       "least structural similarity, up to 1"},
      {"flip", quantity_value(kDimensionless, kFromZeroToOne, "0.002"), false, {}, "largest allowed mean of FLIP"},
      {"why", text_value(), true, {}, "the reason for these thresholds"},
  };
}

}  // namespace

ValueSchema golden_schema() {
  MappingSchema moment{.name = "golden", .documentation = "A moment whose picture is compared with an approved one."};
  moment.keys = golden_limits();
  moment.keys.insert(moment.keys.begin(), {"at", quantity_value(kTime, kFromZero, "1.5 s"), true, {}, "when"});
  MappingSchema video{.name = "golden_video",
                      .documentation =
                          "The whole video, compared frame by frame with the approved one before it is "
                          "encoded, and after. The limits hold for the pictures that are kept."};
  video.keys = golden_limits();
  video.keys.insert(
      video.keys.begin(),
      {"video", integer_value(1, 50, "5"), true, {}, "how many of its pictures are kept, from the first to the last"});
  return list_value(mapping_value({moment, video}));
}

}  // namespace thinwall

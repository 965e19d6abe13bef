#include "studio/schema/SchemaSections.hpp"

namespace thinwall {
namespace {

KeySchema body_key() {
  return {"body", name_value(), false, {}, "which body; may be left out when there is one only"};
}

KeySchema point_key() {
  return {"at", vector_value(kLength, {}, "[0, 0, 20 mm]"), true, {}, "near the point on the stress-free surface"};
}

KeySchema length_key(const std::string& documentation) {
  return {"length", quantity_value(kLength, kAboveZero, "15 mm"), false, "15 mm", documentation};
}

/// Keys that everything has which is shown for a while.
std::vector<KeySchema> with_span(std::vector<KeySchema> keys) {
  keys.push_back({"from", quantity_value(kTime, kFromZero, "1 s"), false, "0 s", "from when it is shown"});
  keys.push_back({"until", quantity_value(kTime, kFromZero, "2 s"), false, {}, "until when; to the end when absent"});
  return keys;
}

ValueSchema labels_value() {
  MappingSchema label{.name = "label",
                      .documentation = "A text beside the organ with a line to a point of a wall, which it follows."};
  label.keys = with_span({
      {"text", text_value(), true, {}, "what it says"},
      body_key(),
      point_key(),
      {"side", word_value({"nearest", "left", "right"}), false, "nearest",
       "on which side of the organ; nearest to the point when it is first shown"},
  });
  return list_value(mapping_value({label}));
}

ValueSchema arrows_value() {
  MappingSchema arrow{.name = "arrow", .documentation = "An arrow whose tip stays at a point of a wall."};
  arrow.keys = with_span({
      {"text", text_value(), false, {}, "at its tail"},
      body_key(),
      point_key(),
      {"direction", direction_value(), false, "[0, 0, -1]", "from tail to tip"},
      length_key("how long it is"),
  });
  return list_value(mapping_value({arrow}));
}

ValueSchema highlights_value() {
  MappingSchema highlight{
      .name = "highlight",
      .documentation = "A ring around a part of a wall, which is tinted; it goes with the material."};
  highlight.keys = with_span({
      body_key(),
      {"at", vector_value(kLength, {}, "[0, 0, 20 mm]"), true, {}, "the middle, on the stress-free surface"},
      {"radius", quantity_value(kLength, kAboveZero, "5 mm"), false, "5 mm", "of the ball around it that is marked"},
      {"color", vector_value(kDimensionless, kFromZeroToOne, "[0.4, 0.82, 0.92]"), false, "[0.4, 0.82, 0.92]",
       "sRGB colour, each part from 0 to 1"},
  });
  return list_value(mapping_value({highlight}));
}

ValueSchema force_arrows_value() {
  MappingSchema arrow{.name = "force arrow",
                      .documentation = "What the tissue does to a tool, as an arrow at its tip."};
  arrow.keys = with_span({
      {"tool", name_value(), false, {}, "which tool; may be left out when there is one only"},
      {"full", quantity_value(kForce, kAboveZero, "1 N"), false, "1 N", "the force whose arrow is `length` long"},
      length_key("how long the arrow of the force `full` is"),
  });
  return list_value(mapping_value({arrow}));
}

ValueSchema card_value() {
  MappingSchema card{.name = "card",
                     .documentation =
                         "Words in the middle of a darkened picture: a title card before the first picture "
                         "moves, an end card when all is over."};
  card.keys = {
      {"title", text_value(), true, {}, "in large letters"},
      {"text", text_value(), false, {}, "below, smaller"},
      {"for", quantity_value(kTime, kAboveZero, "3 s"), false, "3 s", "how long it is shown"},
  };
  return mapping_value({card});
}

ValueSchema freezes_value() {
  MappingSchema freeze{.name = "freeze",
                       .documentation = "The video stands still; the simulation and its record do not know of it."};
  freeze.keys = {
      {"at", quantity_value(kTime, kFromZero, "1 s"), true, {}, "when, in the time of the simulation"},
      {"for", quantity_value(kTime, kAboveZero, "2 s"), false, "2 s", "how long"},
  };
  return list_value(mapping_value({freeze}));
}

ValueSchema slow_motion_value() {
  MappingSchema slow{.name = "slow motion",
                     .documentation = "The video shows a span of the simulation slower, or faster."};
  slow.keys = {
      {"from", quantity_value(kTime, kFromZero, "1 s"), true, {}, "when it begins, in the time of the simulation"},
      {"until", quantity_value(kTime, kFromZero, "1.5 s"), true, {}, "when it ends, in the time of the simulation"},
      {"speed",
       quantity_value(kDimensionless, {.minimum = 0.001, .maximum = 100}, "0.25"),
       true,
       {},
       "of the simulation in the video: 0.25 makes four seconds of one"},
  };
  return list_value(mapping_value({slow}));
}

}  // namespace

ValueSchema teaching_schema() {
  MappingSchema teaching{.name = "teaching", .documentation = "What makes a recording a lesson."};
  teaching.keys = {
      {"labels", labels_value(), false, "[]", "texts that point at places of walls"},
      {"arrows", arrows_value(), false, "[]", "arrows that point at places of walls"},
      {"highlights", highlights_value(), false, "[]", "parts of walls that are marked; not in data views"},
      {"force_arrows", force_arrows_value(), false, "[]", "forces at tools"},
      {"title_card", card_value(), false, {}, "words at the beginning"},
      {"end_card", card_value(), false, {}, "words at the end"},
      {"freezes", freezes_value(), false, "[]", "when the video stands still"},
      {"slow_motion", slow_motion_value(), false, "[]", "which spans are shown at another speed, without overlap"},
  };
  return mapping_value({teaching});
}

}  // namespace thinwall

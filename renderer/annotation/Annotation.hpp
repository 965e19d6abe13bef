#pragma once

#include <limits>
#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// When something is shown: from the first to the last time, both included, in seconds of the simulation.
struct ShownSpan {
  double begin = 0;
  double end = std::numeric_limits<double>::infinity();
  bool holds(double time) const { return time >= begin - 1e-9 && time <= end + 1e-9; }
};

enum class LabelSide { kNearest, kLeft, kRight };

/// A text beside the organ with a line to a material point of a wall.
struct LabelDefinition {
  std::string text = {};
  std::string body = {};
  Double3 at = {0, 0, 0};  // metres, near the point on the stress-free surface
  LabelSide side = LabelSide::kNearest;
  ShownSpan span = {};
};

/// An arrow whose tip stays at a material point.
struct ArrowDefinition {
  std::string text = {};  // at its tail; empty: none
  std::string body = {};
  Double3 at = {0, 0, 0};          // metres, near the point on the stress-free surface
  Double3 direction = {0, 0, -1};  // unit, from tail to tip
  double length = 0.015;           // metres
  ShownSpan span = {};
};

/// What the tissue does to a tool, as an arrow from its tip.
struct ForceArrowDefinition {
  std::string tool = {};
  double full = 1;        // newton
  double length = 0.015;  // metres, of the arrow of the force `full`
  ShownSpan span = {};
};

/// What a teacher points out in a picture.
struct AnnotationDefinition {
  std::vector<LabelDefinition> labels = {};
  std::vector<ArrowDefinition> arrows = {};
  std::vector<ForceArrowDefinition> force_arrows = {};
  bool is_empty() const { return labels.empty() && arrows.empty() && force_arrows.empty(); }
};

}  // namespace thinwall

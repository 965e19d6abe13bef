#include "studio/golden/StateLayers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "renderer/ground_truth/GroundTruth.hpp"
#include "renderer/metric/LayerDifference.hpp"

namespace thinwall {
namespace {

// What is worth a word: a tenth of a millimetre, a degree, a tenth of a pixel.
constexpr double kDepthTolerance = 1e-4;
constexpr double kNormalTolerance = 1;
constexpr double kFlowTolerance = 0.1;

std::uint8_t level(double part) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
}

FloatImage depth_layer(const GroundTruth& truth) {
  FloatImage layer{.size = truth.size, .channels = 1, .values = truth.depth};
  for (float& value : layer.values) {
    if (value == 0) value = std::numeric_limits<float>::quiet_NaN();
  }
  return layer;
}

FloatImage normal_layer(const GroundTruth& truth) {
  FloatImage layer{.size = truth.size, .channels = 3, .values = {}};
  for (const auto& normal : truth.normals) layer.values.insert(layer.values.end(), normal.begin(), normal.end());
  return layer;
}

FloatImage part_layer(const GroundTruth& truth) {
  return {.size = truth.size, .channels = 1, .values = {truth.parts.begin(), truth.parts.end()}};
}

/// Near is light, over the range of both.
Image depth_picture(const GroundTruth& truth, double nearest, double farthest) {
  Image image{.size = truth.size, .pixels = {}};
  for (const float depth : truth.depth) {
    const double part = farthest > nearest ? (farthest - depth) / (farthest - nearest) : 1;
    image.pixels.insert(image.pixels.end(), 3, depth == 0 ? std::uint8_t{0} : level(0.15 + 0.85 * part));
  }
  return image;
}

/// Each axis as a colour, as is usual for normals.
Image normal_picture(const GroundTruth& truth) {
  Image image{.size = truth.size, .pixels = {}};
  for (const auto& normal : truth.normals) {
    const bool is_nothing = normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
    for (const float axis : normal) image.pixels.push_back(is_nothing ? std::uint8_t{0} : level(0.5 + 0.5 * axis));
  }
  return image;
}

/// Colours far from each other for numbers near each other.
Image part_picture(const GroundTruth& truth) {
  Image image{.size = truth.size, .pixels = {}};
  for (const std::uint16_t part : truth.parts) {
    for (const unsigned factor : {97U, 57U, 151U}) {
      image.pixels.push_back(part == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(64 + part * factor % 192));
    }
  }
  return image;
}

/// White: the largest motion; dark grey: none; black: nothing is seen.
Image flow_picture(const OpticalFlow& flow, ImageSize size, double largest) {
  Image image{.size = size, .pixels = {}};
  for (std::size_t i = 0; i < flow.flow.size(); ++i) {
    const double length = std::hypot(static_cast<double>(flow.flow[i][0]), static_cast<double>(flow.flow[i][1]));
    const std::uint8_t grey = flow.state[i] == FlowState::kNothing
                                  ? std::uint8_t{0}
                                  : level(0.15 + (largest > 0 ? 0.85 * length / largest : 0));
    image.pixels.insert(image.pixels.end(), 3, grey);
  }
  return image;
}

StateLayer depth(const GroundTruth& golden, const GroundTruth& today) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const GroundTruth* truth : {&golden, &today}) {
    for (const float value : truth->depth) {
      if (value == 0) continue;
      nearest = std::min<double>(nearest, value);
      farthest = std::max<double>(farthest, value);
    }
  }
  const LayerDifference difference =
      compare_layers(depth_layer(golden), depth_layer(today), LayerKind::kDepth, {.difference = kDepthTolerance});
  return {.name = "depth",
          .verdict = difference.largest == 0 && difference.failing == 0
                         ? "equal"
                         : fmt::format("largest difference {:.3g} mm, mean {:.3g} mm; {} pixels by more than 0.1 mm, "
                                       "edges aside, worst at ({}, {})",
                                       1e3 * difference.largest, 1e3 * difference.mean, difference.failing,
                                       difference.worst[0], difference.worst[1]),
          .golden = depth_picture(golden, nearest, farthest),
          .today = depth_picture(today, nearest, farthest)};
}

StateLayer normals(const GroundTruth& golden, const GroundTruth& today) {
  const LayerDifference difference =
      compare_layers(normal_layer(golden), normal_layer(today), LayerKind::kNormal, {.difference = kNormalTolerance});
  return {.name = "normals",
          .verdict = fmt::format("largest angle {:.3g} degrees, mean {:.3g}; {} pixels by more than a degree",
                                 difference.largest, difference.mean, difference.failing),
          .golden = normal_picture(golden),
          .today = normal_picture(today)};
}

StateLayer parts(const GroundTruth& golden, const GroundTruth& today) {
  const LayerDifference difference = compare_layers(part_layer(golden), part_layer(today), LayerKind::kIds);
  return {.name = "parts",
          .verdict = fmt::format("smallest overlap {:.4f}, of part {:g}; {} pixels show another part",
                                 difference.smallest_overlap, difference.smallest_overlap_id, difference.failing),
          .golden = part_picture(golden),
          .today = part_picture(today)};
}

StateLayer flow(const SeenFrame& golden, const SeenFrame& today, ImageSize size) {
  const OpticalFlow motion = optical_flow(golden.moment(), today.moment());
  double largest = 0, sum = 0;
  std::size_t seen = 0, moved = 0;
  for (std::size_t i = 0; i < motion.flow.size(); ++i) {
    if (!motion.is_known[i]) continue;
    const double length = std::hypot(static_cast<double>(motion.flow[i][0]), static_cast<double>(motion.flow[i][1]));
    largest = std::max(largest, length);
    sum += length;
    ++seen;
    moved += length > kFlowTolerance ? 1 : 0;
  }
  return {.name = "flow",
          .verdict = fmt::format("from the golden's state to today's: largest {:.3g} pixels, mean {:.3g}; {} pixels by "
                                 "more than a tenth",
                                 largest, seen > 0 ? sum / static_cast<double>(seen) : 0, moved),
          .golden = flow_picture(motion, size, largest),
          .today = {}};
}

}  // namespace

std::vector<StateLayer> state_layers(const Snapshot& golden, const Snapshot& today, const Shot& shot, ImageSize size) {
  const SeenFrame before(golden, shot, size);
  const SeenFrame now(today, shot, size);
  const GroundTruth before_truth = ground_truth(before);
  const GroundTruth now_truth = ground_truth(now);
  return {depth(before_truth, now_truth), normals(before_truth, now_truth), parts(before_truth, now_truth),
          flow(before, now, size)};
}

}  // namespace thinwall

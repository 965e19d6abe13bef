#include "renderer/metric/LayerDifference.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>

namespace thinwall {
namespace {

const float* values_at(const FloatImage& image, int x, int y) {
  return &image.values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) +
                        static_cast<std::size_t>(x)) *
                       static_cast<std::size_t>(image.channels)];
}

bool shows_something(const float* values, LayerKind kind) {
  if (kind == LayerKind::kDepth) return std::isfinite(values[0]);
  if (kind == LayerKind::kFlow) return std::isfinite(values[0]) && std::isfinite(values[1]);
  const double length = std::hypot(static_cast<double>(values[0]), values[1], values[2]);
  return std::isfinite(length) && length > 0;
}

/// Between 0 and 180 degrees; by arms and height, which keeps small angles exact.
double angle_between(const float* a, const float* b) {
  const double cross = std::hypot(static_cast<double>(a[1]) * b[2] - static_cast<double>(a[2]) * b[1],
                                  static_cast<double>(a[2]) * b[0] - static_cast<double>(a[0]) * b[2],
                                  static_cast<double>(a[0]) * b[1] - static_cast<double>(a[1]) * b[0]);
  const double dot =
      static_cast<double>(a[0]) * b[0] + static_cast<double>(a[1]) * b[1] + static_cast<double>(a[2]) * b[2];
  return std::atan2(cross, dot) * 180 / std::numbers::pi;
}

double difference_of(const float* a, const float* b, LayerKind kind) {
  if (kind == LayerKind::kDepth) return std::abs(static_cast<double>(a[0]) - b[0]);
  if (kind == LayerKind::kFlow) {
    return std::hypot(static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1]);
  }
  return angle_between(a, b);
}

/// Calls `look` with the place of each pixel within `band` of (x, y), until it says true.
template <typename Look>
bool any_near(const FloatImage& image, int x, int y, int band, Look look) {
  for (int row = std::max(0, y - band); row <= std::min(image.size.height - 1, y + band); ++row) {
    for (int column = std::max(0, x - band); column <= std::min(image.size.width - 1, x + band); ++column) {
      if (look(column, row)) return true;
    }
  }
  return false;
}

/// Whether the depth near a pixel jumps, or ends.
bool is_at_edge(const FloatImage& depth, int x, int y, const LayerTolerance& tolerance) {
  const float here = *values_at(depth, x, y);
  return any_near(depth, x, y, tolerance.edge_band, [&](int column, int row) {
    const float there = *values_at(depth, column, row);
    if (std::isfinite(here) != std::isfinite(there)) return true;
    return std::isfinite(here) && std::abs(static_cast<double>(here) - there) > tolerance.edge_jump;
  });
}

/// Whether `other` has near (x, y) the depth, or the nothing, that `depth` has there.
bool is_found_near(const FloatImage& depth, const FloatImage& other, int x, int y, const LayerTolerance& tolerance) {
  const float wanted = *values_at(depth, x, y);
  return any_near(other, x, y, tolerance.edge_band, [&](int column, int row) {
    const float there = *values_at(other, column, row);
    if (!std::isfinite(wanted) || !std::isfinite(there)) return std::isfinite(wanted) == std::isfinite(there);
    return std::abs(static_cast<double>(wanted) - there) <= tolerance.difference;
  });
}

bool edge_excuses(const FloatImage& first, const FloatImage& second, int x, int y, const LayerTolerance& tolerance) {
  if (tolerance.edge_band <= 0) return false;
  if (!is_at_edge(first, x, y, tolerance) && !is_at_edge(second, x, y, tolerance)) return false;
  return is_found_near(first, second, x, y, tolerance) && is_found_near(second, first, x, y, tolerance);
}

/// What is no number is a part of its own.
float id_of(float value) {
  return std::isfinite(value) ? value : -1.0F;
}

LayerDifference compare_ids(const FloatImage& first, const FloatImage& second) {
  struct Areas {
    std::int64_t both = 0;
    std::int64_t any = 0;
  };
  std::map<float, Areas> areas;
  LayerDifference result;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    const float a = id_of(first.values[i]);
    const float b = id_of(second.values[i]);
    ++result.compared;
    ++areas[a].any;
    if (a == b) {
      ++areas[a].both;
      continue;
    }
    ++areas[b].any;
    if (result.failing++ == 0) {
      const auto width = static_cast<std::size_t>(first.size.width);
      result.worst = {static_cast<int>(i % width), static_cast<int>(i / width)};
    }
  }
  for (const auto& [id, area] : areas) {
    const double overlap = static_cast<double>(area.both) / static_cast<double>(area.any);
    if (overlap >= result.smallest_overlap) continue;
    result.smallest_overlap = overlap;
    result.smallest_overlap_id = static_cast<double>(id);
  }
  return result;
}

}  // namespace

std::string layer_name(LayerKind kind) {
  switch (kind) {
    case LayerKind::kDepth:
      return "depth";
    case LayerKind::kNormal:
      return "normals";
    case LayerKind::kIds:
      return "ids";
    case LayerKind::kFlow:
      return "flow";
  }
  return "";
}

int layer_channels(LayerKind kind) {
  if (kind == LayerKind::kNormal) return 3;
  return kind == LayerKind::kFlow ? 2 : 1;
}

LayerDifference compare_layers(const FloatImage& first, const FloatImage& second, LayerKind kind,
                               const LayerTolerance& tolerance) {
  assert(first.size == second.size && first.channels == layer_channels(kind) && second.channels == first.channels);
  if (kind == LayerKind::kIds) return compare_ids(first, second);
  LayerDifference result;
  double sum = 0;
  for (int y = 0; y < first.size.height; ++y) {
    for (int x = 0; x < first.size.width; ++x) {
      const float* a = values_at(first, x, y);
      const float* b = values_at(second, x, y);
      const bool in_first = shows_something(a, kind);
      const bool in_second = shows_something(b, kind);
      if (!in_first && !in_second) continue;
      const double difference = in_first && in_second ? difference_of(a, b, kind) : 0;
      const bool differs = in_first != in_second || difference > tolerance.difference;
      if (differs && kind == LayerKind::kDepth && edge_excuses(first, second, x, y, tolerance)) continue;
      if (differs) ++result.failing;
      if (in_first != in_second) {
        ++result.only_in_one;
        continue;
      }
      ++result.compared;
      sum += difference;
      if (difference > result.largest) {
        result.largest = difference;
        result.worst = {x, y};
      }
    }
  }
  if (result.compared > 0) result.mean = sum / static_cast<double>(result.compared);
  return result;
}

}  // namespace thinwall

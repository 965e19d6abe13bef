#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "renderer/image/FloatImage.hpp"

namespace thinwall {

/// What the numbers of a layer of ground truth mean, and so how they are compared.
enum class LayerKind {
  kDepth,   // one channel, metres from the camera; not finite where there is nothing
  kNormal,  // three channels, directions; zero where there is nothing
  kIds,     // one channel, whole numbers that name parts
  kFlow,    // two channels, pixels to the right and down; not finite where there is none
};

/// "depth", "normals", "ids", "flow"
std::string layer_name(LayerKind kind);

/// Channels that a layer of this kind has.
int layer_channels(LayerKind kind);

struct LayerTolerance {
  double difference = 0;  // a pixel fails above it: depth in metres, normals in degrees, flow in pixels
  // Depth: pixels this near to a jump of depth in either layer may instead have the depth of a pixel that near.
  int edge_band = 1;
  double edge_jump = 1e-3;  // metres between neighbours that make a jump
};

struct LayerDifference {
  std::int64_t compared = 0;     // pixels that show something in both layers
  std::int64_t only_in_one = 0;  // pixels that show something in one layer only
  std::int64_t failing = 0;      // those, and the ones whose difference is above the tolerance
  double largest = 0;            // metres, degrees or pixels; not for ids
  double mean = 0;               // over `compared`
  double smallest_overlap = 1;   // ids: of all ids, the smallest area of intersection over union
  double smallest_overlap_id = 0;
  std::array<int, 2> worst = {0, 0};  // column and row of the largest difference
};

/// Depth: absolute difference. Normals: angle between directions. Ids: overlap of each id's pixels. Flow: distance
/// between end points. The sizes must be equal, the channels those of the kind.
LayerDifference compare_layers(const FloatImage& first, const FloatImage& second, LayerKind kind,
                               const LayerTolerance& tolerance = {});

}  // namespace thinwall

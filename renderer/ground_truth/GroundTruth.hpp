#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/camera/View.hpp"
#include "renderer/ground_truth/OpticalFlow.hpp"
#include "renderer/ground_truth/Projection.hpp"
#include "renderer/ground_truth/SceneGeometry.hpp"
#include "renderer/ground_truth/SeenPlaces.hpp"

namespace thinwall {

/// A moment as a picture sees it: what ground truth is taken from. Needs no graphics.
class SeenFrame {
 public:
  /// Of a shot's own camera, with the edges that the picture has; what others show beside it or inset counts as
  /// nothing, as does all when a card covers the picture.
  SeenFrame(Snapshot snapshot, const Shot& shot, ImageSize size, DrawnEdges edges = DrawnEdges::kCurvedLips,
            bool is_covered = false);

  const Snapshot& snapshot() const { return snapshot_; }
  const Camera& camera() const { return camera_; }
  const PicturePart& part() const { return part_; }
  const SceneGeometry& geometry() const { return geometry_; }
  const SeenPlaces& seen() const { return seen_; }
  SeenMoment moment() const { return {snapshot_, geometry_, projection_, seen_}; }

 private:
  Snapshot snapshot_;
  PicturePart part_;
  Camera camera_;
  SceneGeometry geometry_;
  Projection projection_;
  SeenPlaces seen_;
};

/// What a pixel shows of a wound.
enum class WoundPart : std::uint8_t {
  kNothing,
  kCutFace,  // the thickness of a wall at a cut
  kInside,   // the inner side of a wall or cap, seen through an opening that cuts have made
  kThrough   // nothing of the scene, seen through an opening within a wall: the bed below cut skin
};

/// What the middle of each pixel shows, (height x width), first row on top; nothing is blended. Where nothing is seen
/// (behind the scene, its floor and the surroundings of an endoscope included) all is zero but for WoundPart::kThrough.
struct GroundTruth {
  ImageSize size;
  std::vector<float> depth;                   // metres along the line of sight
  std::vector<std::array<float, 3>> normals;  // of length one, towards the viewer: x to the right, y down, z away
  std::vector<std::uint16_t> instances;       // 1 + body, then 1 + bodies + tool
  std::vector<std::uint16_t> parts;           // 5 (instance - 1) + 1 + PartKind
  std::vector<float> von_mises;               // pascal, of the triangle; empty where the snapshot holds no stress
  std::vector<float> contact_pressure;        // pascal; empty where the snapshot holds none
  std::vector<WoundPart> wound;
};

GroundTruth ground_truth(const SeenFrame& frame);

/// Kinds of parts of an instance, for the numbers of GroundTruth::parts.
inline constexpr std::uint16_t kPartKinds = 5;

}  // namespace thinwall

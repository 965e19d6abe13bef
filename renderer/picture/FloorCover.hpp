#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/picture/MapRaster.hpp"
#include "renderer/snapshot/Float3.hpp"
#include "renderer/snapshot/Vector.hpp"

namespace thinwall {

/// The part of a floor that a map shows: a square.
struct FloorMap {
  Vector3 center;         // of the scene, metres
  double size = 1;        // of the scene, metres
  double height = 0;      // metres
  double half_width = 1;  // metres
};

/// What a scene takes of a floor's light: all of the key light below what stands in its way, and of the light from all
/// around the more, the nearer it is above. Made by the processor, see for_spans.
class FloorCover {
 public:
  static constexpr int kResolution = 96;  // the blur leaves nothing finer

  FloorCover();

  /// Empties the map. A light at the horizon or below throws no shadow.
  void begin(const FloorMap& map, Vector3 toward_light);

  /// Makes these the vertices that lay() counts.
  template <typename Vertex>
  void stand(std::span<const Vertex> vertices) {
    feet_.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) feet_[i] = foot_of(vertices[i].position);
  }

  /// Lays triangles on the floor. `corners`: (3 x triangles); of what is closed those that face up are left out, for
  /// others lie below them.
  void lay(std::span<const std::uint32_t> corners, bool is_closed);

  /// (2 x width x height): parts, 255 for the whole, of the light from all around and of the key light that are taken,
  /// blurred. Valid until the next call.
  std::span<const std::uint8_t> blurred();

 private:
  // A texel that is covered in part takes a part of the light: with four parts of a texel instead of nine a shadow that
  // moves slowly is seen to jerk.
  static constexpr int kParts = 3;
  static constexpr int kFine = kParts * kResolution;

  /// Where a vertex lies on the map, straight below it and along the key light; the value is its height above the
  /// floor, over the scene's size.
  struct Foot {
    MapCorner below;
    MapCorner along;
  };
  Foot foot_of(const Float3& position) const;

  /// What of the fine map has been covered: rows and columns from the first up to, not with, the last.
  struct Window {
    int first_row = kFine, end_row = 0, first = kFine, end = 0;
    void add(const MapSpan& span);
  };
  void shrink();

  FloorMap map_;
  Vector3 slant_;  // by which a foot goes aside for each metre above the floor
  bool has_shadow_ = false;
  std::vector<Foot> feet_;
  Window covered_;
  std::vector<float> lowest_;           // (kFine x kFine)
  std::vector<std::uint8_t> shadowed_;  // (kFine x kFine)
  std::array<std::vector<float>, 2> planes_;
  std::vector<float> memory_;  // of blur_map
  std::vector<std::uint8_t> pixels_;
};

}  // namespace thinwall

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/ground_truth/SceneGeometry.hpp"
#include "renderer/ground_truth/SeenPlaces.hpp"
#include "renderer/ground_truth/TriangleMatch.hpp"

namespace thinwall {

/// A moment with all that pictures of it are drawn from.
struct SceneMoment {
  const Snapshot& snapshot;
  const SceneGeometry& geometry;
};

/// Finds the matter at places of one moment in another moment of the same take, also across cuts: the stress-free place
/// tells what is the same. Both moments must outlive this.
class MaterialMatch {
 public:
  MaterialMatch(const SceneMoment& from, const SceneMoment& to);
  ~MaterialMatch();
  MaterialMatch(MaterialMatch&&) noexcept;

  /// Nothing where the other moment has no such surface: the face of a cut before the cut.
  std::optional<ScenePlace> find(const ScenePlace& place) const;

 private:
  struct Surface;
  std::optional<ScenePlace> find_on_rim(const ScenePlace& place, const ScenePart& part, const ScenePart& other) const;

  SceneMoment from_;
  SceneMoment to_;
  std::vector<std::uint32_t> other_part_;  // (parts of `from`), kNoIndex where there is none
  std::vector<Surface> surfaces_;          // (surfaces)
};

}  // namespace thinwall

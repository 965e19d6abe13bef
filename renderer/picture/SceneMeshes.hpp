#pragma once

#include <string>
#include <vector>

#include "renderer/picture/SceneExtent.hpp"
#include "renderer/picture/ToolShape.hpp"
#include "renderer/picture/TriangleBuffer.hpp"
#include "renderer/picture/View.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A body's wall or caps within the buffer of all tissue.
struct TissuePart {
  TissueLook look;
  std::size_t first_index = 0;
  std::size_t index_count = 0;
};

/// A snapshot's surfaces and tools on the device, as all passes draw them.
class SceneMeshes {
 public:
  SceneMeshes();
  void upload(const Snapshot& snapshot, const SceneExtent& extent, const LookDefinition& look);

  const TriangleBuffer& tissue() const { return tissue_; }
  const TriangleBuffer& tools() const { return tools_; }
  const std::vector<TissuePart>& parts() const { return parts_; }
  const std::vector<ToolRod>& rods() const { return rods_; }

 private:
  void upload_tissue(const Snapshot& snapshot, const LookDefinition& look);
  void upload_tools(const Snapshot& snapshot, const SceneExtent& extent);

  TriangleBuffer tissue_;
  TriangleBuffer tools_;
  std::vector<TissuePart> parts_;
  std::vector<ToolRod> rods_;
};

}  // namespace thinwall

#include "studio/director/CutCheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/mesh/MeshTopology.hpp"
#include "studio/director/Plan.hpp"
#include "studio/organs/SurfaceOrigin.hpp"
#include "studio/organs/ToldPlaces.hpp"
#include "studio/scenario/InputError.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

bool cuts(const Clip& clip, const std::string& body) {
  const bool is_cut =
      std::holds_alternative<InciseClip>(clip.action) || std::holds_alternative<PierceClip>(clip.action);
  return is_cut && body_of(clip) == body;
}

/// Why a wall cannot be cut, and what helps; empty where it can.
std::string fault_of(const SurfaceMesh& mesh) {
  const MeshTopology topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  const auto place = [&](int vertex) { return place_text(1e3 * mesh.vertices[vertex]); };
  const auto edge = [&](int e) { return place(topology.edges[e][0]) + " to " + place(topology.edges[e][1]); };
  if (const std::vector<int>& crowded = topology.crowded_edges; !crowded.empty()) {
    return fmt::format("{} shared by more than two triangles: {}; take what branches off there out of the mesh",
                       counted(crowded.size(), "edge", "edges"), told_places(crowded, edge, "mm"));
  }
  if (const std::vector<int>& contrary = topology.contrary_edges; !contrary.empty()) {
    return fmt::format("{} between triangles that face opposite ways: {}; turn one side of them over",
                       counted(contrary.size(), "edge", "edges"), told_places(contrary, edge, "mm"));
  }
  if (const std::vector<int>& touching = topology.non_manifold_vertices; !touching.empty()) {
    return fmt::format("{} in which parts of it touch: {}; move them apart there, or have them split by `repair: true`",
                       counted(touching.size(), "vertex", "vertices"), told_places(touching, place, "mm"));
  }
  return "";
}

}  // namespace

void refuse_uncuttable(std::span<const Clip> timeline, const BodyDefinition& body) {
  if (std::ranges::none_of(timeline, [&](const Clip& clip) { return cuts(clip, body.name); })) return;
  const std::string fault = fault_of(body.mesh);
  if (fault.empty()) return;
  std::vector<Diagnostic> mistakes;
  for (const Clip& clip : timeline) {
    if (!cuts(clip, body.name)) continue;
    mistakes.push_back(
        {clip.location, fmt::format("timeline[{}].{}: the wall of body {} cannot be cut, as it has {}", clip.number,
                                    std::holds_alternative<InciseClip>(clip.action) ? "incise" : "pierce",
                                    in_backticks(body.name), fault)});
  }
  throw InputErrors(std::move(mistakes));
}

}  // namespace thinwall

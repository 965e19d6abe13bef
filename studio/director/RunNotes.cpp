#include "studio/director/RunNotes.hpp"

#include <fmt/format.h>

#include "engine/contact/PointRadius.hpp"

namespace thinwall {

std::optional<std::string> free_body_warning(const Body& body, Analysis analysis) {
  const auto free = body.model().rigid_motions.cols();
  if (free == 0 || analysis != Analysis::kQuasiStatic) return std::nullopt;
  return fmt::format(
      "body `{}`: `fixed` leaves {} rigid motion{} free, removed by constraints weighted with the mass, which take up "
      "what the tools push",
      body.model().definition.name, free, free == 1 ? "" : "s");
}

std::string bare_point_note(const ToolDefinition& tool, const SurfaceView& surface, const Attachment& attachment) {
  const double radius =
      effective_point_radius(surface.triangles, surface.position, attachment.vertices, attachment.weights);
  return fmt::format(
      "tool `{}`: a bare point on a membrane; on this mesh it acts like a tip of {:.3g} mm radius, and a finer "
      "mesh lowers its force; a `radius` makes the force independent of the mesh",
      tool.name, 1e3 * radius);
}

std::string kept_way_note(std::size_t number, double begin, const InputErrors& missed) {
  return fmt::format(
      "timeline[{}]: from {:.4g} s the tool goes the way that it had when the run began, as the wall is no longer "
      "where it was: {}",
      number, begin, missed.diagnostics().front().message);
}

}  // namespace thinwall

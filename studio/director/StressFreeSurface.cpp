#include "studio/director/StressFreeSurface.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "studio/organs/BodyBuilder.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

std::variant<MeshFileSource, ShapeSource> quick_source(const BodyScenario& body) {
  auto source = body.surface;
  if (auto* file = std::get_if<MeshFileSource>(&source)) file->edge_length = 0;
  return source;
}

}  // namespace

std::optional<StressFreeSurface> stress_free_surface(const BodyScenario& body) {
  try {
    std::vector<std::string> untold;
    SurfaceMesh mesh = make_surface(quick_source(body), body.location, untold);
    Eigen::VectorXd position = Eigen::Map<const Eigen::VectorXd>(mesh.vertices.front().data(),
                                                                 3 * static_cast<Eigen::Index>(mesh.vertices.size()));
    return StressFreeSurface{std::move(mesh), std::move(position), body.fluid.kind == FluidKind::kNone};
  } catch (const InputErrors&) {
    return std::nullopt;
  }
}

}  // namespace thinwall

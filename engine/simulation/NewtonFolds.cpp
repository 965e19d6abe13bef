// What keeps a shell's triangles from being folded through each other.

#include <algorithm>
#include <cmath>

#include "engine/mesh/MeshTopology.hpp"
#include "engine/shell/HingeAngle.hpp"
#include "engine/simulation/Newton.hpp"

namespace thinwall {
namespace {

/// Growth of the angle between two neighbours, radians, in a solution of a shell without line search that only a step
/// gone astray makes: past any energy it ends up with triangles folded over.
constexpr double kMostFolding = 1.5;

Hinge hinge_at(const std::array<int, 4>& vertices, const Eigen::VectorXd& position) {
  Hinge hinge;
  for (int k = 0; k < 4; ++k) hinge[k] = position.segment<3>(3 * vertices[k]);
  return hinge;
}

}  // namespace

std::vector<std::array<int, 4>> Newton::hinges_of(const BodyModel& model) {
  std::vector<std::array<int, 4>> hinges;
  const MeshEdges mesh = edges_of(model.vertices(), model.surface);
  for (int edge = 0; edge < static_cast<int>(mesh.edges.size()); ++edge) {
    const auto sides = triangles_at(mesh, edge);
    if (sides.size() != 2) continue;
    const auto& own = mesh.triangle_edges[sides[0]];
    const auto side = std::ranges::find(own, edge) - own.begin();
    const Eigen::Vector3i &one = model.surface[sides[0]], &other = model.surface[sides[1]];
    const int p = one[side], q = one[(side + 1) % 3];
    int far = 0;
    while (other[far] == p || other[far] == q) ++far;
    hinges.push_back({p, q, one[(side + 2) % 3], other[far]});
  }
  return hinges;
}

bool Newton::folds_over(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const {
  return std::ranges::any_of(hinges_, [&](const std::array<int, 4>& hinge) {
    const double grown = std::abs(hinge_angle(hinge_at(hinge, after))) - std::abs(hinge_angle(hinge_at(hinge, before)));
    return grown > kMostFolding;
  });
}

double Newton::safe_fraction(const Eigen::VectorXd& position, const Eigen::VectorXd& motion) {
  double fraction = self_contact_.safe_fraction(position, motion);
  for (const std::array<int, 4>& hinge : hinges_) {
    const Hinge from = hinge_at(hinge, position);
    if (!is_folded_back(from)) continue;
    const Hinge way = hinge_at(hinge, motion);
    const auto after = [&](double part) {
      Hinge to;
      for (int k = 0; k < 4; ++k) to[k] = from[k] + part * way[k];
      return to;
    };
    while (fraction > 0 && passes_through(from, after(fraction))) fraction *= 0.5;
  }
  return fraction;
}

}  // namespace thinwall

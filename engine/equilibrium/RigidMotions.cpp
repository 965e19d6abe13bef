#include "engine/equilibrium/RigidMotions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

#include "engine/mesh/UnionFind.hpp"

namespace thinwall {
namespace {

struct MovablePart {
  std::vector<int> vertices;
  Eigen::MatrixXd motions;  // (unknowns x free), zero elsewhere
};

/// The six rigid motions about the centroid, each as displacements of the vertices of the part.
class RigidMotions {
 public:
  RigidMotions(const MovablePart& part, const Eigen::VectorXd& position) : part_(part), position_(position) {
    for (const int v : part.vertices) {
      centroid_ += position.segment<3>(3 * v) / static_cast<double>(part.vertices.size());
    }
    for (const int v : part.vertices) size_ = std::max(size_, (position.segment<3>(3 * v) - centroid_).norm());
  }

  Eigen::Matrix<double, 3, 6> of(int vertex) const {
    const Eigen::Vector3d arm = (position_.segment<3>(3 * vertex) - centroid_) / size_;
    Eigen::Matrix<double, 3, 6> motions;
    for (int axis = 0; axis < 3; ++axis) {
      motions.col(axis) = Eigen::Vector3d::Unit(axis);
      motions.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    }
    return motions;
  }

  Eigen::MatrixXd all() const {
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(position_.size(), 6);
    for (const int v : part_.vertices) motions.middleRows<3>(3 * v) = of(v);
    return motions;
  }

 private:
  const MovablePart& part_;
  const Eigen::VectorXd& position_;
  Eigen::Vector3d centroid_ = Eigen::Vector3d::Zero();
  double size_ = 0;
};

/// Combinations of the rigid motions that move no fixed unknown: the null space of the motions seen by these.
/// `part_of`: (vertices), `number` of this part.
void find_free_motions(const BodyModel& model, const Eigen::VectorXd& position, const std::vector<int>& part_of,
                       int number, MovablePart& part) {
  const RigidMotions motions(part, position);
  Eigen::Matrix<double, 6, 6> seen = Eigen::Matrix<double, 6, 6>::Zero();
  const auto see = [&](int vertex, const auto& is_seen) {
    const Eigen::Matrix<double, 3, 6> rows = motions.of(vertex);
    for (int k = 0; k < 3; ++k) {
      if (is_seen(k)) seen += rows.row(k).transpose() * rows.row(k);
    }
  };
  for (const int v : part.vertices) {
    if (!model.fixed[3 * v] && !model.fixed[3 * v + 1] && !model.fixed[3 * v + 2]) continue;
    see(v, [&](int k) { return model.fixed[3 * v + k] != 0; });
  }
  // A clamped side lets its triangle turn about nothing.
  for (const BendingRest& patch : model.bending) {
    const auto is_clamped = [](const BendingSide& side) { return side.clamped; };
    if (part_of[patch.vertices[0]] != number || std::ranges::none_of(patch.sides, is_clamped)) continue;
    for (int k = 0; k < 3; ++k) see(patch.vertices[k], [](int) { return true; });
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> spectrum(seen);
  int free = 0;
  // Below this a motion counts as free: round-off of the sums is some 1e-13, one fixed unknown alone gives about 1.
  while (free < 6 && spectrum.eigenvalues()[free] < 1e-9) ++free;
  if (free > 0) {
    part.motions = motions.all() * spectrum.eigenvectors().leftCols(free);
  } else {
    part.motions.resize(position.size(), 0);
  }
}

void choose_anchors(const MovablePart& part, const Eigen::VectorXd& position, BodyModel& model) {
  const auto place = [&](int vertex) -> Eigen::Vector3d { return position.segment<3>(3 * vertex); };
  const auto farthest = [&](auto distance) {
    int best = part.vertices.front();
    for (const int v : part.vertices) {
      if (distance(v) > distance(best)) best = v;
    }
    return best;
  };
  const int first = farthest([&](int v) { return (place(v) - place(part.vertices.front())).norm(); });
  const int second = farthest([&](int v) { return (place(v) - place(first)).norm(); });
  const int third = farthest([&](int v) { return (place(v) - place(first)).cross(place(v) - place(second)).norm(); });
  for (const int vertex : {first, second, third}) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!model.fixed[3 * vertex + axis]) model.anchors.push_back(3 * vertex + axis);
    }
  }
}

}  // namespace

std::vector<int> wall_parts(const BodyModel& model) {
  UnionFind joined(static_cast<std::size_t>(model.vertices()));
  for (const Eigen::Vector3i& triangle : model.definition.mesh.triangles) joined.join(triangle);
  std::vector<int> number(static_cast<std::size_t>(model.vertices()), -1), parts(number.size(), 0);
  int count = 0;
  for (const Eigen::Vector3i& triangle : model.definition.mesh.triangles) {
    int& own = number[joined.find(triangle[0])];
    if (own < 0) own = count++;
  }
  for (int v = 0; v < model.vertices(); ++v) parts[v] = std::max(0, number[joined.find(v)]);
  return parts;
}

void hold_rigid_motions(BodyModel& model, const Eigen::VectorXd& position) {
  const std::vector<int> part_of = wall_parts(model);
  std::vector<MovablePart> parts;
  for (int v = 0; v < model.vertices(); ++v) {
    if (part_of[v] >= static_cast<int>(parts.size())) parts.resize(static_cast<std::size_t>(part_of[v]) + 1);
    parts[part_of[v]].vertices.push_back(v);
  }
  model.held_position = position;
  model.anchors.clear();
  Eigen::Index free = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    MovablePart& part = parts[k];
    if (part.vertices.empty()) continue;
    find_free_motions(model, position, part_of, static_cast<int>(k), part);
    if (part.motions.cols() > 0) choose_anchors(part, position, model);
    free += part.motions.cols();
  }
  model.rigid_motions.resize(position.size(), free);
  free = 0;
  for (const MovablePart& part : parts) {
    model.rigid_motions.middleCols(free, part.motions.cols()) = part.motions;
    free += part.motions.cols();
  }
}

}  // namespace thinwall

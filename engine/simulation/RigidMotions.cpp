#include "engine/simulation/RigidMotions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace thinwall {
namespace {

/// Vertices that are one set after each call of `join`.
class JoinedVertices {
 public:
  explicit JoinedVertices(int vertices) : parent_(static_cast<std::size_t>(vertices)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }
  void join(const Eigen::Vector3i& triangle) {
    for (int k = 1; k < 3; ++k) parent_[root(triangle[k])] = root(triangle[0]);
  }

 private:
  std::vector<int> parent_;
};

struct MovablePart {
  std::vector<int> vertices;
  Eigen::MatrixXd motions;  // (unknowns x free), zero elsewhere
};

/// The six rigid motions about the centroid, each as displacements of the vertices of the part.
Eigen::MatrixXd all_rigid_motions(const MovablePart& part, const Eigen::VectorXd& position) {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const int v : part.vertices) {
    centroid += position.segment<3>(3 * v) / static_cast<double>(part.vertices.size());
  }
  double size = 0;
  for (const int v : part.vertices) size = std::max(size, (position.segment<3>(3 * v) - centroid).norm());
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(position.size(), 6);
  for (const int v : part.vertices) {
    const Eigen::Vector3d arm = (position.segment<3>(3 * v) - centroid) / size;
    for (int axis = 0; axis < 3; ++axis) {
      motions.block<3, 1>(3 * v, axis) = Eigen::Vector3d::Unit(axis);
      motions.block<3, 1>(3 * v, 3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    }
  }
  return motions;
}

/// Combinations of the rigid motions that move no fixed unknown: the null space of the motions seen by these.
void find_free_motions(const BodyModel& model, const Eigen::VectorXd& position, MovablePart& part) {
  const Eigen::MatrixXd motions = all_rigid_motions(part, position);
  Eigen::Matrix<double, 6, 6> seen = Eigen::Matrix<double, 6, 6>::Zero();
  for (const int v : part.vertices) {
    for (int k = 3 * v; k < 3 * v + 3; ++k) {
      if (model.fixed[k]) seen += motions.row(k).transpose() * motions.row(k);
    }
  }
  // A clamped side lets its triangle turn about nothing; patches of other parts see no motion.
  for (const BendingRest& patch : model.bending) {
    const auto is_clamped = [](const BendingSide& side) { return side.clamped; };
    if (std::none_of(patch.sides.begin(), patch.sides.end(), is_clamped)) continue;
    for (int k = 0; k < 9; ++k) {
      const auto row = motions.row(3 * patch.vertices[k / 3] + k % 3);
      seen += row.transpose() * row;
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> spectrum(seen);
  int free = 0;
  // Below this a motion counts as free: round-off of the sums is some 1e-13, one fixed unknown alone gives about 1.
  while (free < 6 && spectrum.eigenvalues()[free] < 1e-9) ++free;
  part.motions = motions * spectrum.eigenvectors().leftCols(free);
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
  JoinedVertices joined(model.vertices());
  for (const Eigen::Vector3i& triangle : model.definition.mesh.triangles) joined.join(triangle);
  std::vector<int> number(static_cast<std::size_t>(model.vertices()), -1), parts(number.size(), 0);
  int count = 0;
  for (const Eigen::Vector3i& triangle : model.definition.mesh.triangles) {
    int& own = number[joined.root(triangle[0])];
    if (own < 0) own = count++;
  }
  for (int v = 0; v < model.vertices(); ++v) parts[v] = std::max(0, number[joined.root(v)]);
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
  for (MovablePart& part : parts) {
    if (part.vertices.empty()) continue;
    find_free_motions(model, position, part);
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

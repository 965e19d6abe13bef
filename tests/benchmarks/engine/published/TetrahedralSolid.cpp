#include "tests/benchmarks/engine/published/TetrahedralSolid.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/mesh/Shapes.hpp"

namespace thinwall {
namespace {

constexpr int kMostIterations = 40;
constexpr int kMostHalvings = 12;

double volume_of(const std::vector<Eigen::Vector3d>& vertices, const std::array<int, 4>& corners) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = vertices[corners[k + 1]] - vertices[corners[0]];
  return edges.determinant() / 6;
}

void add_tetrahedron(TetrahedralMesh& mesh, std::array<int, 4> corners) {
  if (volume_of(mesh.vertices, corners) < 0) std::swap(corners[2], corners[3]);
  mesh.tetrahedra.push_back(corners);
}

BlockPattern pattern_of(const TetrahedralMesh& mesh) {
  std::vector<Eigen::Vector3i> faces;
  for (const std::array<int, 4>& t : mesh.tetrahedra) {
    for (const Eigen::Vector3i& face :
         {Eigen::Vector3i(t[0], t[1], t[2]), Eigen::Vector3i(t[0], t[1], t[3]), Eigen::Vector3i(t[0], t[2], t[3])}) {
      faces.push_back(face);
    }
  }
  return make_block_pattern(static_cast<int>(mesh.vertices.size()), faces);
}

}  // namespace

TetrahedralMesh make_half_ball(double radius, int n) {
  const SurfaceMesh surface = make_hemisphere(radius, 4 * n * n);
  const int layers = 2 * n, count = static_cast<int>(surface.vertices.size());
  TetrahedralMesh mesh;
  for (int layer = 1; layer <= layers; ++layer) {
    for (const Eigen::Vector3d& vertex : surface.vertices) {
      mesh.vertices.push_back(vertex * layer / layers);
      mesh.fixed.push_back(vertex.z() < 1e-9 * radius);
    }
  }
  int top = 0;
  for (int v = 0; v < count; ++v) top = surface.vertices[v].z() > surface.vertices[top].z() ? v : top;
  mesh.crown = (layers - 1) * count + top;
  for (int layer = 0; layer + 1 < layers; ++layer) {
    for (Eigen::Vector3i triangle : surface.triangles) {
      // Each side of a prism is divided from the lower number below to the higher above, so that neighbours agree.
      std::sort(triangle.data(), triangle.data() + 3);
      const Eigen::Vector3i below = triangle.array() + layer * count, above = below.array() + count;
      add_tetrahedron(mesh, {below[0], below[1], below[2], above[2]});
      add_tetrahedron(mesh, {below[0], below[1], above[1], above[2]});
      add_tetrahedron(mesh, {below[0], above[0], above[1], above[2]});
    }
  }
  // The innermost half ball is convex: a fan from its crown.
  std::vector<Eigen::Vector3i> shell = surface.triangles;
  shell.insert(shell.end(), surface.cap_triangles.begin(), surface.cap_triangles.end());
  for (const Eigen::Vector3i& triangle : shell) {
    if ((triangle.array() != top).all()) add_tetrahedron(mesh, {top, triangle[0], triangle[1], triangle[2]});
  }
  return mesh;
}

TetrahedralSolid::TetrahedralSolid(TetrahedralMesh mesh, SolidMaterial material)
    : mesh_(std::move(mesh)), material_(material), pattern_(pattern_of(mesh_)), factor_(pattern_) {
  position_.resize(pattern_.unknowns());
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
    position_.segment<3>(static_cast<Eigen::Index>(3 * v)) = mesh_.vertices[v];
    held_.insert(held_.end(), 3, mesh_.fixed[v] || static_cast<int>(v) == mesh_.crown);
  }
  for (const std::array<int, 4>& corners : mesh_.tetrahedra) {
    Element element;
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = mesh_.vertices[corners[k + 1]] - mesh_.vertices[corners[0]];
    element.volume = edges.determinant() / 6;
    element.shape.bottomRows<3>() = edges.inverse();
    element.shape.row(0) = -element.shape.bottomRows<3>().colwise().sum();
    for (int k = 0; k < 12; ++k) element.unknowns[k] = 3 * corners[k / 3] + k % 3;
    element.addresses = dense_addresses<12>(pattern_, element.unknowns);
    elements_.push_back(element);
  }
}

bool TetrahedralSolid::assemble(const Eigen::VectorXd& position) {
  gradient_.setZero(position.size());
  values_.assign(pattern_.nonzeros(), 0);
  largest_force_ = 0;
  for (const Element& element : elements_) {
    Eigen::Matrix<double, 3, 4> corners;
    for (int k = 0; k < 4; ++k) corners.col(k) = position.segment<3>(element.unknowns[3 * k]);
    const Eigen::Matrix3d deformation = corners * element.shape;
    const double stretch = deformation.determinant();
    if (!(stretch > 0)) return false;
    const Eigen::Matrix3d inverse = deformation.inverse();
    const double logarithm = std::log(stretch), across = material_.mu - material_.lambda * logarithm;
    // g_a: gradient of shape function a in space.
    const Eigen::Matrix<double, 4, 3> in_space = element.shape * inverse;
    const Eigen::Matrix3d stress = material_.mu * deformation - across * inverse.transpose();
    const Eigen::Matrix<double, 3, 4> force = element.volume * stress * element.shape.transpose();
    Eigen::Matrix<double, 12, 12> hessian;
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        const Eigen::Vector3d one = in_space.row(a), other = in_space.row(b);
        hessian.block<3, 3>(3 * a, 3 * b) =
            element.volume * (material_.lambda * one * other.transpose() + across * other * one.transpose());
        hessian.block<3, 3>(3 * a, 3 * b).diagonal().array() +=
            element.volume * material_.mu * element.shape.row(a).dot(element.shape.row(b));
      }
    }
    for (int k = 0; k < 12; ++k) gradient_[element.unknowns[k]] += force(k % 3, k / 3);
    largest_force_ = std::max(largest_force_, force.cwiseAbs().maxCoeff());
    add_dense(element.addresses, hessian, values_);
  }
  return true;
}

bool TetrahedralSolid::factorize() {
  held_values_ = values_;
  for (int column = 0; column < pattern_.unknowns(); ++column) {
    for (int k = pattern_.column_begin[column]; k < pattern_.column_begin[column + 1]; ++k) {
      if (held_[column] || held_[pattern_.row[k]]) held_values_[k] = pattern_.row[k] == column ? material_.mu : 0;
    }
  }
  return factor_.factorize(held_values_).has_value();
}

int TetrahedralSolid::press(double height, double tolerance) {
  if (!assemble(position_)) return -1;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    Eigen::VectorXd way = Eigen::VectorXd::Zero(position_.size());
    way[3 * mesh_.crown + 2] = height - position_[3 * mesh_.crown + 2];
    Eigen::VectorXd force;
    multiply(pattern_, values_, way, force);
    Eigen::VectorXd motion = -gradient_ - force;
    double residual = 0;
    for (Eigen::Index k = 0; k < motion.size(); ++k) {
      if (!held_[k]) residual = std::max(residual, std::abs(gradient_[k]));
      if (held_[k]) motion[k] = 0;
    }
    if (way.isZero() && residual <= tolerance * largest_force_) return iteration;
    if (!factorize()) return -1;
    factor_.solve(motion);
    motion += way;
    const Eigen::VectorXd before = position_;
    double part = 1;
    for (int halving = 0; halving < kMostHalvings; ++halving, part *= 0.5) {
      if (assemble(before + part * motion)) break;
    }
    position_ = before + part * motion;
    if (!assemble(position_)) return -1;
  }
  return -1;
}

}  // namespace thinwall

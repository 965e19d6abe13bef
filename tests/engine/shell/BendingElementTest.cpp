#include "engine/shell/BendingElement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/mesh/Shapes.hpp"
#include "engine/shell/BendingPatches.hpp"
#include "engine/shell/HingeAngle.hpp"
#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

constexpr double kTurnLength = 0.3;  // metres, of no meaning: any must do

const Material kPlate = {find_wall_law("st_venant_kirchhoff"), {1.2e6, 0.3}};

struct Wall {
  SurfaceMesh mesh;
  MeshTopology topology;
  std::vector<BendingRest> bending;

  int vertices() const { return static_cast<int>(mesh.vertices.size()); }
  /// Positions without turns.
  Eigen::VectorXd unknowns(const std::vector<Eigen::Vector3d>& positions) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(3 * vertices() + static_cast<Eigen::Index>(topology.edges.size()));
    for (int v = 0; v < vertices(); ++v) all.segment<3>(3 * v) = positions[v];
    return all;
  }
};

Wall wall_of(const SurfaceMesh& mesh, bool clamped = false) {
  Wall wall{
      .mesh = mesh, .topology = topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles), .bending = {}};
  std::vector<MembraneRest> rests;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    rests.push_back(make_membrane_rest({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, 0.1));
  }
  const std::vector<char> held(mesh.vertices.size(), clamped ? 1 : 0);
  wall.bending = make_bending_rests(mesh, wall.topology, rests, std::span(&kPlate, 1), held, kTurnLength);
  return wall;
}

/// A sheet whose inner vertices have been moved about: no two triangles are alike.
SurfaceMesh irregular_sheet(int triangles) {
  SurfaceMesh mesh = make_sheet(2, 2, triangles);
  const double edge = 2 / std::sqrt(0.5 * triangles);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    Eigen::Vector3d& vertex = mesh.vertices[v];
    if (std::abs(vertex.x()) > 0.999 || std::abs(vertex.y()) > 0.999) continue;
    vertex.x() += 0.25 * edge * std::sin(12.9898 * static_cast<double>(v));
    vertex.y() += 0.25 * edge * std::sin(78.233 * static_cast<double>(v) + 1);
  }
  return mesh;
}

HyperDual angle_of(const std::array<DualVector, 4>& hinge) {
  const auto& [p, q, a, b] = hinge;
  const DualVector edge = q - p, one = cross(edge, a - p), other = cross(b - p, edge);
  const HyperDual sine = dot(cross(one, other), edge) / norm(edge), cosine = dot(one, other);
  // The inverse tangent tells no angle beyond a quarter turn.
  const double beyond = cosine.value < 0 ? std::copysign(std::numbers::pi, sine.value) : 0;
  return HyperDual(0) - atan(sine / cosine) - HyperDual(beyond);
}

/// What counts of an angle: beyond `fold` the tangent that goes to infinity at half a turn.
HyperDual counted(const HyperDual& angle, double fold) {
  const double sign = angle.value < 0 ? -1 : 1, rest = 2 / std::numbers::pi * (std::numbers::pi - fold);
  const HyperDual beyond = (HyperDual(sign) * angle - HyperDual(fold)) / HyperDual(rest);
  if (beyond.value < 0) return angle;
  const double tangent = std::tan(beyond.value), slope = 1 + tangent * tangent;
  return HyperDual(sign) *
         (HyperDual(fold) + HyperDual(rest) * HyperDual::chain(beyond, tangent, slope, 2 * tangent * slope));
}

TEST(HingeAngle, IsThatOfThePlanesAndPositiveWhereTheyBendTowardsTheirNormals) {
  for (const double angle : {-3.0, -1.2, 0.0, 0.4, 2.9}) {
    const Hinge hinge = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 2, 0), Eigen::Vector3d(-1, 0.3, 0),
                         Eigen::Vector3d(1.5 * std::cos(angle), 0.7, 1.5 * std::sin(angle))};
    EXPECT_NEAR(hinge_angle(hinge), angle, 1e-14);
  }
}

TEST(HingeAngle, PassesThroughWhereATriangleFoldedBackComesOutOnTheOtherSide) {
  const auto at = [](double angle) {
    return Hinge{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 2, 0), Eigen::Vector3d(-1, 0.3, 0),
                 Eigen::Vector3d(1.5 * std::cos(angle), 0.7, 1.5 * std::sin(angle))};
  };
  EXPECT_TRUE(is_folded_back(at(1.6)) && is_folded_back(at(-3.0)));
  EXPECT_FALSE(is_folded_back(at(1.5)) || is_folded_back(at(-0.2)));
  EXPECT_TRUE(passes_through(at(3.1), at(-3.0)));
  EXPECT_TRUE(passes_through(at(-1.7), at(1.8)));
  EXPECT_FALSE(passes_through(at(3.1), at(2.0)));
  EXPECT_FALSE(passes_through(at(3.1), at(-1.0)));
  EXPECT_FALSE(passes_through(at(0.2), at(-0.2)));
  EXPECT_FALSE(passes_through(at(1.0), at(-3.0)));
}

TEST(HingeAngle, GradientAndHessianAgreeWithExactDerivatives) {
  const Hinge hinge = {Eigen::Vector3d(0.1, 0, 0.3), Eigen::Vector3d(0, 2, -0.2), Eigen::Vector3d(-1, 0.3, 0.4),
                       Eigen::Vector3d(1.5, 0.7, 0.5)};
  const HingeDerivatives derivatives = hinge_derivatives(hinge);
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      std::array<DualVector, 4> moved;
      for (int k = 0; k < 4; ++k) moved[k] = dual(hinge[k]);
      moved[i / 3][i % 3].first = 1;
      moved[j / 3][j % 3].second = 1;
      const HyperDual exact = angle_of(moved);
      EXPECT_NEAR(derivatives.gradient[i], exact.first, 1e-14);
      EXPECT_NEAR(derivatives.hessian(i, j), exact.both, 1e-14);
    }
  }
}

/// Energy of a triangle from its definition.
HyperDual energy_of(const BendingRest& rest, const std::array<DualVector, 6>& x, const std::array<HyperDual, 3>& turns,
                    const BendingMemory& memory) {
  std::array<HyperDual, 3> strain = {0, 0, 0};
  for (int side = 0; side < 3; ++side) {
    const BendingSide& own = rest.sides[side];
    const DualVector &p = x[side], &q = x[(side + 1) % 3];
    DualVector beyond = x[3 + side];
    for (int axis = 0; axis < 3 && own.clamped; ++axis) {
      beyond[axis] = HyperDual(0.5) * (p[axis] + q[axis]) + HyperDual(own.held[axis]);
    }
    HyperDual angle = HyperDual(own.turn_share) * turns[side] - HyperDual(own.rest_angle);
    if (own.share != 0)
      angle = angle + HyperDual(own.share) * counted(angle_of({p, q, x[(side + 2) % 3], beyond}), own.fold);
    for (int k = 0; k < 3; ++k) strain[k] = strain[k] + HyperDual(rest.weights(k, side)) * angle;
  }
  HyperDual total = 0;
  for (int k = 0; k < 3; ++k) {
    total = total + HyperDual(rest.area * memory.overmoment[k]) * strain[k];
    for (int l = 0; l < 3; ++l) {
      total = total + HyperDual(0.5 * rest.area * memory.scale * rest.stiffness(k, l)) * strain[k] * strain[l];
    }
  }
  return total;
}

void expect_exact_derivatives(const BendingRest& rest, const BendingPatch& patch) {
  const BendingMemory memory{.scale = 0.7, .overmoment = {3, -2, 1}};
  const BendingTerms terms = bending_terms(rest, patch, memory);
  double gradient = 0, hessian = 0, scale = terms.hessian.cwiseAbs().maxCoeff();
  for (int i = 0; i < 21; ++i) {
    for (int j = i; j < 21; ++j) {
      std::array<DualVector, 6> moved;
      std::array<HyperDual, 3> turns;
      for (int k = 0; k < 6; ++k) moved[k] = dual(patch.position[k]);
      for (int k = 0; k < 3; ++k) turns[k] = patch.turns[k];
      (i < 18 ? moved[i / 3][i % 3] : turns[i - 18]).first = 1;
      (j < 18 ? moved[j / 3][j % 3] : turns[j - 18]).second = 1;
      const HyperDual exact = energy_of(rest, moved, turns, memory);
      EXPECT_NEAR(terms.energy, exact.value, 1e-12 * std::abs(exact.value));
      gradient = std::max(gradient, std::abs(terms.gradient[i] - exact.first));
      hessian = std::max(hessian, std::abs(terms.hessian(i, j) - exact.both));
      hessian = std::max(hessian, std::abs(terms.hessian(j, i) - exact.both));
    }
  }
  EXPECT_LT(gradient, 1e-12 * scale);
  EXPECT_LT(hessian, 1e-12 * scale);
}

TEST(BendingElement, GradientAndHessianAgreeWithExactDerivatives) {
  for (const bool border : {false, true}) {
    const Wall wall = wall_of(border ? make_sheet(2, 2, 8) : make_sphere(1, 80), border);
    const BendingRest& rest = wall.bending[border ? 0 : 17];
    BendingPatch patch = patch_of(rest, wall.unknowns(wall.mesh.vertices), wall.vertices());
    for (int k = 0; k < 6; ++k) {
      patch.position[k] += 0.1 * Eigen::Vector3d(std::sin(5.0 * rest.vertices[k]), std::cos(3.0 * rest.vertices[k]),
                                                 std::sin(rest.vertices[k] + 1.0));
    }
    patch.turns = {0.1, -0.2, 0.05};
    expect_exact_derivatives(rest, patch);
  }
}

/// Turns what lies beyond a side of a patch about that side.
void fold(BendingPatch& patch, int side, double angle) {
  const Eigen::Vector3d p = patch.position[side], along = (patch.position[(side + 1) % 3] - p).normalized();
  patch.position[3 + side] = p + Eigen::AngleAxisd(angle, along) * (patch.position[3 + side] - p);
}

/// A triangle of a flat sheet with three neighbours, and its patch at rest.
struct Inner {
  BendingRest rest;
  BendingPatch patch;
};
Inner inner_triangle() {
  const Wall wall = wall_of(make_sheet(2, 2, 32));
  const auto found = std::ranges::find_if(wall.bending, [](const BendingRest& rest) {
    return std::ranges::all_of(rest.sides, [](const BendingSide& side) { return side.share > 0; });
  });
  return {*found, patch_of(*found, wall.unknowns(wall.mesh.vertices), wall.vertices())};
}

TEST(BendingElement, GradientAndHessianOfASharpFoldAgreeWithExactDerivatives) {
  for (const double angle : {2.7, -2.7, 3.0}) {
    Inner inner = inner_triangle();
    fold(inner.patch, 1, angle);
    EXPECT_GT(std::abs(side_angles(inner.rest, inner.patch)[1]), 0.5 * 2.7);
    inner.patch.turns = {0.1, -0.2, 0.05};
    expect_exact_derivatives(inner.rest, inner.patch);
  }
}

TEST(BendingElement, AFoldAsksForMoreWithoutBoundAsItCloses) {
  const Inner flat = inner_triangle();
  const auto angle_at = [&](double angle) {
    BendingPatch patch = flat.patch;
    fold(patch, 1, angle);
    return side_angles(flat.rest, patch)[1];
  };
  const double sense = angle_at(1) > 0 ? 1 : -1, half = std::numbers::pi;
  EXPECT_NEAR(angle_at(sense * 2.4), 0.5 * 2.4, 1e-12);
  EXPECT_NEAR(angle_at(-sense * 2.4), -0.5 * 2.4, 1e-12);
  // Smooth where it begins, and odd.
  EXPECT_NEAR(angle_at(sense * 2.51), 0.5 * 2.51, 1e-5);
  EXPECT_NEAR(angle_at(sense * 2.9), -angle_at(-sense * 2.9), 1e-12);
  // tan(pi / 2 - x) is 1 / x to the square of x.
  const double left = 1e-4, stretch = 0.5 * half / (half - 2.5);
  EXPECT_NEAR(angle_at(sense * (half - left)), 0.5 / (stretch * stretch * left), 1e-3 / left);
}

TEST(BendingElement, AnEdgeThatIsSharpAtRestBendsFromThereAsAFlatOneDoes) {
  Wall wall = wall_of(make_sheet(2, 2, 2));
  for (Eigen::Vector3d& vertex : wall.mesh.vertices) {
    const Eigen::Vector3d along = Eigen::Vector3d(1, 1, 0).normalized();
    if (vertex.x() > vertex.y() + 1) vertex = Eigen::AngleAxisd(3.0, along) * vertex;
  }
  const Wall sharp = wall_of(wall.mesh);
  for (const double more : {-0.3, 0.05}) {
    const BendingRest& rest = sharp.bending[0];
    const auto side = std::ranges::find_if(rest.sides, [](const BendingSide& one) { return one.share > 0; });
    const int folded = static_cast<int>(side - rest.sides.begin());
    BendingPatch patch = patch_of(rest, sharp.unknowns(sharp.mesh.vertices), sharp.vertices());
    EXPECT_NEAR(bending_strain(rest, patch).norm(), 0, 1e-12);
    fold(patch, folded, more);
    const double turned = side_angles(rest, patch)[folded] - side->rest_angle;
    EXPECT_NEAR(std::abs(turned), 0.5 * std::abs(more), 1e-12);
    EXPECT_NEAR(side->fold, std::abs(side->rest_angle) + 0.5 * std::numbers::pi, 1e-12)
        << "half of what is left to half a turn";
  }
}

TEST(BendingElement, AClampedSideGoesOnBeyondItselfInThePlaneOfItsTriangle) {
  const Wall sheet = wall_of(make_sheet(2, 2, 8), true);
  int clamped = 0;
  for (const BendingRest& rest : sheet.bending) {
    const Eigen::Vector3d angles =
        side_angles(rest, patch_of(rest, sheet.unknowns(sheet.mesh.vertices), sheet.vertices()));
    for (int side = 0; side < 3; ++side) {
      if (!rest.sides[side].clamped) continue;
      EXPECT_NEAR(angles[side], 0, 1e-12);
      ++clamped;
    }
  }
  EXPECT_EQ(clamped, 8);
}

TEST(BendingElement, AStressFreeCurvedShapeMovedRigidlyStaysStressFree) {
  const Wall wall = wall_of(make_hemisphere(1, 64));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3d> moved;
  for (const Eigen::Vector3d& vertex : wall.mesh.vertices) moved.push_back(turn * vertex + Eigen::Vector3d(3, -1, 2));
  for (const BendingRest& rest : wall.bending) {
    const BendingPatch patch = patch_of(rest, wall.unknowns(moved), wall.vertices());
    EXPECT_LT(bending_strain(rest, patch).norm(), 1e-12);
    EXPECT_LT(bending_terms(rest, patch).gradient.norm(), 1e-9);
  }
}

TEST(BendingElement, AStretchAloneDoesNotBend) {
  const Wall wall = wall_of(make_sphere(1, 320));
  std::vector<Eigen::Vector3d> blown;
  for (const Eigen::Vector3d& vertex : wall.mesh.vertices) blown.push_back(1.7 * vertex);
  for (const BendingRest& rest : wall.bending) {
    EXPECT_LT(bending_strain(rest, patch_of(rest, wall.unknowns(blown), wall.vertices())).norm(), 1e-12);
  }
}

TEST(BendingElement, ForcesOfAnyBendingBalance) {
  const Wall wall = wall_of(irregular_sheet(128));
  std::vector<Eigen::Vector3d> bent = wall.mesh.vertices;
  for (Eigen::Vector3d& vertex : bent) vertex.z() = 0.3 * std::sin(2 * vertex.x()) * std::cos(3 * vertex.y());
  for (const BendingRest& rest : wall.bending) {
    const BendingPatch patch = patch_of(rest, wall.unknowns(bent), wall.vertices());
    const BendingTerms terms = bending_terms(rest, patch);
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    for (int k = 0; k < 6; ++k) {
      force += terms.gradient.segment<3>(3 * k);
      torque += patch.position[k].cross(Eigen::Vector3d(terms.gradient.segment<3>(3 * k)));
    }
    EXPECT_LT(force.norm(), 1e-10 * terms.gradient.norm());
    EXPECT_LT(torque.norm(), 1e-10 * terms.gradient.norm());
  }
}

/// A sheet bent a little to z = (a x^2 + b y^2) / 2 + c x y, its edges turned as the surface is at their middles.
struct Bent {
  double a, b, c;  // 1 / metre

  Eigen::VectorXd unknowns(const Wall& wall) const {
    std::vector<Eigen::Vector3d> positions = wall.mesh.vertices;
    for (Eigen::Vector3d& x : positions) x.z() = height(x);
    Eigen::VectorXd all = wall.unknowns(positions);
    for (const BendingRest& rest : wall.bending) {
      BendingPatch patch = patch_of(rest, all, wall.vertices());
      patch.turns.setZero();
      const Eigen::Vector3d angles = side_angles(rest, patch);
      for (int side = 0; side < 3; ++side) {
        const BendingSide& own = rest.sides[side];
        if (own.turn_share == 0) continue;
        all[3 * wall.vertices() + rest.edges[side]] = (slope(wall, rest, side) - angles[side]) / own.turn_share;
      }
    }
    return all;
  }

  double height(const Eigen::Vector3d& x) const {
    return 0.5 * a * x.x() * x.x() + 0.5 * b * x.y() * x.y() + c * x.x() * x.y();
  }

  /// Outwards across a side at its middle, less that of the flat triangle.
  double slope(const Wall& wall, const BendingRest& rest, int side) const {
    const Eigen::Vector3d &p = wall.mesh.vertices[rest.vertices[side]],
                          &q = wall.mesh.vertices[rest.vertices[(side + 1) % 3]],
                          &r = wall.mesh.vertices[rest.vertices[(side + 2) % 3]];
    const Eigen::Vector3d along = (q - p).normalized(), arm = r - p;
    const double foot = arm.dot(along), reach = (arm - foot * along).norm();
    const Eigen::Vector3d outer(along.y(), -along.x(), 0), middle = 0.5 * (p + q);
    const double at_foot = height(p) + foot / (q - p).norm() * (height(q) - height(p));
    const Eigen::Vector3d gradient(a * middle.x() + c * middle.y(), b * middle.y() + c * middle.x(), 0);
    return gradient.dot(outer) - (at_foot - height(r)) / reach;
  }
};

TEST(BendingElement, EvenCurvatureIsExactOnAnyMesh) {
  for (const Bent& shape : {Bent{1, 0, 0}, Bent{0, 1, 0}, Bent{0, 0, 1}, Bent{1, -0.4, 0.3}}) {
    const double small = 1e-5;
    const Bent bent{small * shape.a, small * shape.b, small * shape.c};
    const Wall wall = wall_of(irregular_sheet(512));
    const Eigen::VectorXd unknowns = bent.unknowns(wall);
    const Eigen::Vector3d strain(bent.a, bent.b, 2 * bent.c);
    for (const BendingRest& rest : wall.bending) {
      const double energy = bending_terms(rest, patch_of(rest, unknowns, wall.vertices())).energy;
      // The stiffness is isotropic, so that the directions of the rest plane do not matter.
      const double exact = 0.5 * rest.area * strain.dot(rest.stiffness * strain);
      EXPECT_NEAR(energy, exact, 1e-6 * exact);  // slopes count as angles to their third power
    }
  }
}

TEST(BendingElement, EvenMomentsPushNoInnerVertexAndTurnNoInnerEdge) {
  const Wall wall = wall_of(irregular_sheet(512));
  const Eigen::VectorXd unknowns = Bent{1e-5, 0.5e-5, 0.3e-5}.unknowns(wall);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(unknowns.size()), single = force;
  for (const BendingRest& rest : wall.bending) {
    const BendingTerms terms = bending_terms(rest, patch_of(rest, unknowns, wall.vertices()));
    const std::array<int, 21> places = unknowns_of(rest, wall.vertices());
    for (int k = 0; k < 21; ++k) {
      force[places[k]] += terms.gradient[k];
      single[places[k]] = std::max(single[places[k]], std::abs(terms.gradient[k]));
    }
  }
  for (int v = 0; v < wall.vertices(); ++v) {
    if (wall.mesh.vertices[v].head<2>().lpNorm<Eigen::Infinity>() > 0.85) continue;
    EXPECT_LT(std::abs(force[3 * v + 2]), 1e-6 * single[3 * v + 2]);
  }
  for (std::size_t edge = 0; edge < wall.topology.edges.size(); ++edge) {
    if (triangles_at(wall.topology, static_cast<int>(edge)).size() < 2) continue;
    const Eigen::Index k = 3 * wall.vertices() + static_cast<Eigen::Index>(edge);
    EXPECT_LT(std::abs(force[k]), 1e-6 * single[k]);
  }
}

}  // namespace
}  // namespace thinwall

#include "engine/wall/MembraneElement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

constexpr double kThickness = 1.3e-3;  // metres

/// Laws that stand for all: the element knows none by name, and each has exact derivatives in its own test.
std::vector<Material> materials() {
  return {{find_wall_law("st_venant_kirchhoff"), {30e3, 0.3}},
          {find_wall_law("neo_hookean"), {20e3}},
          {find_wall_law("mooney_rivlin"), {8e3, 2e3}}};
}

Corners moved(const Corners& corners, const Eigen::Matrix3d& matrix, const Eigen::Vector3d& shift) {
  return {matrix * corners[0] + shift, matrix * corners[1] + shift, matrix * corners[2] + shift};
}

Eigen::Matrix3d some_rotation() {
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
}

/// Rest corners of an oblique triangle, metres.
Corners rest_corners() {
  return {Eigen::Vector3d(1e-3, 2e-3, -1e-3), Eigen::Vector3d(4e-3, 2.5e-3, 0), Eigen::Vector3d(1.5e-3, 5e-3, 1e-3)};
}

struct Placement {
  const char* name;
  Corners corners;
};

std::vector<Placement> placements() {
  const Corners rest = rest_corners();
  Eigen::Matrix3d small, large, sheared, squeezed;
  small << 1.02, 0.01, 0, -0.01, 0.98, 0.02, 0, 0.01, 1.01;
  large << 2.8, 0.3, 0.2, -0.1, 2.1, 0.4, 0.3, 0.1, 3;
  sheared << 1, 1.5, 0.7, 0, 1, 0, 0.2, 0, 1;
  squeezed << 0.6, 0, 0, 0.1, 1.4, 0, 0, 0.1, 0.7;
  return {{"at rest", rest},
          {"small strain", moved(rest, small, {0, 0, 0})},
          {"large strain", moved(rest, large, {0.01, 0, 0})},
          {"sheared", moved(rest, sheared, {0, 0.02, 0})},
          {"squeezed", moved(rest, squeezed, {0, 0, 0})},
          {"turned and stretched", moved(rest, some_rotation() * large, {0.01, -0.02, 0.03})}};
}

Prestretch evenly(double stretch) {
  return {.first = stretch, .second = stretch};
}

/// Energy of a membrane triangle by the metrics g and G of the current and rest edges: C has the invariants
/// tr G^-1 g and det g / det G. No deformation gradient, no plane of reference.
HyperDual energy_by_metrics(const Material& material, const Corners& rest, double prestretch,
                            const std::array<DualVector, 3>& corners) {
  const Eigen::Vector3d rest_1 = (rest[1] - rest[0]) / prestretch, rest_2 = (rest[2] - rest[0]) / prestretch;
  Eigen::Matrix2d metric;
  metric << rest_1.dot(rest_1), rest_1.dot(rest_2), rest_1.dot(rest_2), rest_2.dot(rest_2);
  const double volume = 0.5 * std::sqrt(metric.determinant()) * kThickness;
  const double scale = 1 / metric.determinant();
  const DualVector edge_1 = corners[1] - corners[0], edge_2 = corners[2] - corners[0];
  const HyperDual g11 = dot(edge_1, edge_1), g12 = dot(edge_1, edge_2), g22 = dot(edge_2, edge_2);
  // M = G^-1 g
  const HyperDual m11 = scale * (metric(1, 1) * g11 - metric(0, 1) * g12);
  const HyperDual m12 = scale * (metric(1, 1) * g12 - metric(0, 1) * g22);
  const HyperDual m21 = scale * (metric(0, 0) * g12 - metric(0, 1) * g11);
  const HyperDual m22 = scale * (metric(0, 0) * g22 - metric(0, 1) * g12);
  const HyperDual trace = m11 + m22, det = m11 * m22 - m12 * m21;
  const std::vector<double>& p = material.parameters;
  if (material.law->name == "st_venant_kirchhoff") {
    const double lambda = p[0] * p[1] / (1 - p[1] * p[1]), mu = 0.5 * p[0] / (1 + p[1]);
    const HyperDual strain = 0.5 * (trace - 2);  // tr E
    const HyperDual squares = 0.25 * (m11 * m11 + 2 * m12 * m21 + m22 * m22 - 2 * trace + 2);
    return volume * (0.5 * lambda * strain * strain + mu * squares);
  }
  // Incompressible: the third principal stretch squared is 1 / det C.
  const HyperDual i1 = trace + 1 / det, i2 = trace / det + det;
  if (material.law->name == "neo_hookean") return volume * 0.5 * p[0] * (i1 - 3);
  return volume * (p[0] * (i1 - 3) + p[1] * (i2 - 3));
}

double largest(const Eigen::MatrixXd& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

TEST(MembraneElement, EnergyGradientAndHessianAgreeWithExactDerivativesOfTheMetricForm) {
  // Both sides are exact up to round-off; residuals seen are below 5e-15 of the scale, 1e-13 leaves room for another
  // compiler. Energies and gradients vanish at rest, so they are compared with stiffness times length.
  double seen = 0;
  for (const Material& material : materials()) {
    for (const double prestretch : {1.0, 1.25}) {
      const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness, evenly(prestretch));
      for (const Placement& placement : placements()) {
        const MembraneTerms terms = membrane_terms(rest, material, placement.corners);
        const CornerDerivatives exact = corner_derivatives(
            [&](const auto& corners) { return energy_by_metrics(material, rest_corners(), prestretch, corners); },
            placement.corners);
        const double stiffness = largest(exact.hessian), length = 4e-3;
        const double energy = std::abs(terms.energy - exact.value) / (stiffness * length * length);
        const double gradient = largest(terms.gradient - exact.gradient) / (stiffness * length);
        const double hessian = largest(terms.hessian - exact.hessian) / stiffness;
        seen = std::max({seen, energy, gradient, hessian});
        EXPECT_LT(energy, 1e-13) << material.law->name << ", " << placement.name << ", prestretch " << prestretch;
        EXPECT_LT(gradient, 1e-13) << material.law->name << ", " << placement.name << ", prestretch " << prestretch;
        EXPECT_LT(hessian, 1e-13) << material.law->name << ", " << placement.name << ", prestretch " << prestretch;
      }
    }
  }
  std::printf("largest relative residual: %.1e\n", seen);
}

TEST(MembraneElement, CentralDifferencesOfItsOwnTermsConvergeWithTheSquareOfTheStep) {
  // Guards the pair energy and gradient even where the metric form of the test were wrong in the same way.
  for (const Material& material : materials()) {
    const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness, evenly(1.1));
    for (const Placement& placement : placements()) {
      const MembraneTerms terms = membrane_terms(rest, material, placement.corners);
      std::array<double, 2> error{};
      for (int level = 0; level < 2; ++level) {
        const double h = level == 0 ? 2e-5 : 1e-5;  // metres, of edges of 4e-3
        Eigen::Matrix<double, 9, 1> difference;
        for (int i = 0; i < 9; ++i) {
          Corners plus = placement.corners, minus = placement.corners;
          plus[i / 3][i % 3] += h;
          minus[i / 3][i % 3] -= h;
          difference[i] =
              (membrane_terms(rest, material, plus).energy - membrane_terms(rest, material, minus).energy) / (2 * h);
        }
        error[level] = largest(difference - terms.gradient);
      }
      // Ratios seen: 3.99 to 4.01.
      EXPECT_NEAR(error[0] / error[1], 4, 0.05) << material.law->name << ", " << placement.name;
    }
  }
}

TEST(MembraneElement, HessianIsSymmetricToTheLastBitsThatMatter) {
  for (const Material& material : materials()) {
    const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness, evenly(1.1));
    for (const Placement& placement : placements()) {
      const Eigen::Matrix<double, 9, 9> hessian = membrane_terms(rest, material, placement.corners).hessian;
      EXPECT_LT(largest(hessian - hessian.transpose()), 1e-14 * largest(hessian)) << placement.name;
    }
  }
}

TEST(MembraneElement, RigidMotionsDoNoWorkAndLeaveTheEnergyUnchanged) {
  // Residuals seen: 2e-15 of the scale; the coordinates carry some 1e-16 of their own.
  const Eigen::Matrix3d rotation = some_rotation();
  for (const Material& material : materials()) {
    const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness);
    for (const Placement& placement : placements()) {
      const MembraneTerms terms = membrane_terms(rest, material, placement.corners);
      const MembraneTerms turned =
          membrane_terms(rest, material, moved(placement.corners, rotation, {0.02, -0.01, 0.03}));
      const double stiffness = largest(terms.hessian), force = stiffness * 4e-3;
      EXPECT_NEAR(turned.energy, terms.energy, 1e-13 * force * 4e-3) << material.law->name << ", " << placement.name;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d part = terms.gradient.segment<3>(3 * k);
        sum += part;
        torque += placement.corners[k].cross(part);
        // Forces turn with the triangle.
        EXPECT_LT(largest(turned.gradient.segment<3>(3 * k) - rotation * part), 1e-13 * force) << placement.name;
      }
      EXPECT_LT(sum.norm(), 1e-14 * force) << material.law->name << ", " << placement.name;
      EXPECT_LT(torque.norm(), 1e-14 * force * 0.02) << material.law->name << ", " << placement.name;
      // The Hessian answers a translation with nothing, and a spin w with the turned gradient, w x f.
      const Eigen::Vector3d spin(0.4, -0.7, 0.2);
      Eigen::Matrix<double, 9, 1> translation, turning, answer;
      for (int k = 0; k < 3; ++k) {
        translation.segment<3>(3 * k) = spin;
        turning.segment<3>(3 * k) = spin.cross(placement.corners[k]);
        answer.segment<3>(3 * k) = spin.cross(Eigen::Vector3d(terms.gradient.segment<3>(3 * k)));
      }
      EXPECT_LT(largest(terms.hessian * translation), 1e-13 * stiffness) << placement.name;
      EXPECT_LT(largest(terms.hessian * turning - answer), 1e-13 * force) << placement.name;
    }
  }
}

TEST(MembraneElement, IsFreeOfEnergyAndForceInItsOwnShapeAndUnderTensionWhenPrestretched) {
  for (const Material& material : materials()) {
    const MembraneTerms relaxed =
        membrane_terms(make_membrane_rest(rest_corners(), kThickness), material, rest_corners());
    const double force = largest(relaxed.hessian) * 4e-3;
    EXPECT_NEAR(relaxed.energy, 0, 1e-14 * force * 4e-3);
    EXPECT_LT(largest(relaxed.gradient), 1e-14 * force);
    const MembraneTerms stretched =
        membrane_terms(make_membrane_rest(rest_corners(), kThickness, evenly(1.2)), material, rest_corners());
    EXPECT_GT(stretched.energy, 1e-3 * force * 4e-3);
  }
}

/// Corner 1 lies at distance a along x, corner 2 above the origin at height b.
MembraneRest right_triangle(double a, double b, double thickness) {
  return make_membrane_rest({Eigen::Vector3d::Zero(), Eigen::Vector3d(a, 0, 0), Eigen::Vector3d(0, b, 0)}, thickness);
}

TEST(MembraneElement, UniaxialTensionOfRubberTakesTheTextbookForce) {
  // Nominal stress 2 (c1 + c2 / l) (l - 1 / l^2) (Treloar 1975); the triangle narrows by l^-1/2 and thins as much.
  const double a = 3e-3, b = 2e-3, c1 = 8e3, c2 = 2e3;
  const MembraneRest rest = right_triangle(a, b, kThickness);
  const Material material{find_wall_law("mooney_rivlin"), {c1, c2}};
  for (const double l : {0.7, 1.01, 1.5, 3.0}) {
    const Corners corners = {Eigen::Vector3d::Zero(), Eigen::Vector3d(l * a, 0, 0),
                             Eigen::Vector3d(0, b / std::sqrt(l), 0)};
    const double nominal = 2 * (c1 + c2 / l) * (l - 1 / (l * l));
    const MembraneTerms terms = membrane_terms(rest, material, corners);
    // The force on the side x = 0 is shared evenly by its two ends; corner 1 stands for the half of the section.
    const double force = 0.5 * nominal * b * kThickness;
    EXPECT_NEAR(terms.gradient[3], force, 1e-13 * c1 * b * kThickness) << l;
    EXPECT_NEAR(terms.gradient[7], 0, 1e-13 * c1 * b * kThickness) << l;  // no force across
    const double tension = nominal * kThickness * std::sqrt(l);           // per current width b / sqrt l
    EXPECT_NEAR(largest_tension(rest, material, corners), std::max(0.0, tension), 1e-12 * c1 * kThickness) << l;
  }
}

TEST(MembraneElement, EquibiaxialTensionOfRubberTakesTheTextbookTension) {
  // Tension per current length 2 h (c1 + c2 l^2) (1 - l^-6) (Treloar 1975).
  const double a = 3e-3, b = 2e-3, c1 = 8e3, c2 = 2e3;
  const MembraneRest rest = right_triangle(a, b, kThickness);
  const Material material{find_wall_law("mooney_rivlin"), {c1, c2}};
  for (const double l : {1.01, 1.5, 3.0}) {
    const Corners corners = {Eigen::Vector3d::Zero(), Eigen::Vector3d(l * a, 0, 0), Eigen::Vector3d(0, l * b, 0)};
    const double tension = 2 * kThickness * (c1 + c2 * l * l) * (1 - std::pow(l, -6));
    EXPECT_NEAR(largest_tension(rest, material, corners), tension, 1e-12 * c1 * kThickness) << l;
    EXPECT_NEAR(membrane_terms(rest, material, corners).gradient[3], 0.5 * tension * l * b, 1e-13 * c1 * b * kThickness)
        << l;
  }
}

TEST(MembraneElement, StVenantKirchhoffUniaxialForceIsThatOfItsModulus) {
  // S11 = E (l^2 - 1) / 2 when the sides are free: E22 = -nu E11.
  const double a = 3e-3, b = 2e-3, e = 30e3, nu = 0.3;
  const MembraneRest rest = right_triangle(a, b, kThickness);
  const Material material{find_wall_law("st_venant_kirchhoff"), {e, nu}};
  for (const double l : {0.9, 1.01, 1.3}) {
    const double strain = 0.5 * (l * l - 1), narrow = std::sqrt(1 - 2 * nu * strain);
    const Corners corners = {Eigen::Vector3d::Zero(), Eigen::Vector3d(l * a, 0, 0), Eigen::Vector3d(0, narrow * b, 0)};
    EXPECT_NEAR(membrane_terms(rest, material, corners).gradient[3], 0.5 * e * strain * l * b * kThickness,
                1e-13 * e * b * kThickness)
        << l;
    EXPECT_NEAR(largest_tension(rest, material, corners), std::max(0.0, e * strain * l * kThickness / narrow),
                1e-12 * e * kThickness)
        << l;
  }
}

TEST(MembraneElement, LargestTensionDoesNotDependOnThePlacementInSpaceOrTheFirstCorner) {
  Eigen::Matrix3d stretch;
  stretch << 1.6, 0.4, 0, 0.1, 1.2, 0.3, 0, 0, 1;
  const Corners rest = rest_corners(), now = moved(rest, stretch, {0, 0, 0});
  for (const Material& material : materials()) {
    const double tension = largest_tension(make_membrane_rest(rest, kThickness), material, now);
    const Corners turned_rest = {rest[1], rest[2], rest[0]};
    Corners turned = moved(now, some_rotation(), {0.1, 0.2, 0.3});
    turned = {turned[1], turned[2], turned[0]};
    EXPECT_NEAR(largest_tension(make_membrane_rest(turned_rest, kThickness), material, turned), tension,
                1e-11 * tension);
  }
}

TEST(MembraneElement, AStressOfItsOwnAddsItsGeometricStiffnessToTheHessian) {
  const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness);
  const Eigen::Vector3d stress(3e3, -2e3, 1e3);
  for (const Placement& placement : placements()) {
    const Material material = materials()[1];
    const Eigen::Matrix<double, 9, 9> with =
        membrane_terms(rest, material, placement.corners, {.overstress = stress}).hessian;
    const Eigen::Matrix<double, 9, 9> without = membrane_terms(rest, material, placement.corners).hessian;
    EXPECT_LT((with - without - geometric_stiffness(rest, stress)).cwiseAbs().maxCoeff(),
              1e-13 * with.cwiseAbs().maxCoeff())
        << placement.name;
  }
}

TEST(MembraneElement, MemoryAddsToTheEnergyThePotentialOfItsStress) {
  // With e the strain of an even stretch: scale W + overstress . e + damping / 2 e . D0 e per volume.
  const double l = 1.2, strain = 0.5 * (l * l - 1);
  const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness);
  const Corners corners = moved(rest_corners(), l * Eigen::Matrix3d::Identity(), {0, 0, 0});
  const MembraneMemory memory{.scale = 0.8, .overstress = {500, -200, 100}, .damping = 0.3};
  for (const Material& material : materials()) {
    const Eigen::Matrix3d unstrained = material.law->respond(material.parameters, {1, 1, 0}).tangent;
    const double stiffness = unstrained.topLeftCorner<2, 2>().sum();  // pascal, of both strains at once
    const MembraneTerms terms = membrane_terms(rest, material, corners, memory);
    const double expected =
        0.8 * terms.strain_energy + rest.area * kThickness * (300 * strain + 0.3 * 0.5 * stiffness * strain * strain);
    EXPECT_NEAR(terms.energy, expected, 1e-13 * expected) << material.law->name;
  }
}

TEST(MembraneElement, ForeseesTheStressOfASmallMotionInFirstOrder) {
  const MembraneRest rest = make_membrane_rest(rest_corners(), kThickness);
  const MembraneMemory memory{.scale = 0.8, .overstress = {50, -20, 10}, .damping = 0.3};
  for (const Placement& placement : placements()) {
    for (const Material& material : materials()) {
      std::array<double, 2> missed;
      for (int halving = 0; halving < 2; ++halving) {
        const double size = 1e-6 / (1 << halving);
        const Corners motion = {size * Eigen::Vector3d(1, -0.5, 0.3), size * Eigen::Vector3d(-0.2, 0.7, 1),
                                size * Eigen::Vector3d(0.4, 0.1, -0.9)};
        Corners reached = placement.corners;
        for (int k = 0; k < 3; ++k) reached[k] += motion[k];
        const MembraneStress stress = membrane_stress(rest, material, placement.corners, motion, memory);
        missed[halving] = (membrane_stress(rest, material, reached, motion, memory).now - stress.foreseen).norm();
        EXPECT_LT(missed[halving], 1e-2 * (stress.foreseen - stress.now).norm()) << placement.name;
      }
      // What is missed is of second order.
      EXPECT_NEAR(missed[0] / missed[1], 4, 0.1) << placement.name << ", " << material.law->name;
    }
  }
}

TEST(MembraneElement, TermsGrowWithThicknessAndAreaAsTheyShould) {
  Eigen::Matrix3d stretch;
  stretch << 1.6, 0.4, 0, 0.1, 1.2, 0.3, 0, 0, 1;
  const Corners rest = rest_corners(), now = moved(rest, stretch, {0, 0, 0});
  const Eigen::Matrix3d twice = 2 * Eigen::Matrix3d::Identity();
  const Corners rest_twice = moved(rest, twice, {0, 0, 0}), now_twice = moved(now, twice, {0, 0, 0});
  for (const Material& material : materials()) {
    const MembraneTerms once = membrane_terms(make_membrane_rest(rest, kThickness), material, now);
    const MembraneTerms thick = membrane_terms(make_membrane_rest(rest, 3 * kThickness), material, now);
    const MembraneTerms wide = membrane_terms(make_membrane_rest(rest_twice, kThickness), material, now_twice);
    EXPECT_NEAR(thick.energy, 3 * once.energy, 1e-13 * thick.energy);
    EXPECT_LT(largest(thick.gradient - 3 * once.gradient), 1e-13 * largest(thick.gradient));
    EXPECT_LT(largest(thick.hessian - 3 * once.hessian), 1e-13 * largest(thick.hessian));
    EXPECT_NEAR(wide.energy, 4 * once.energy, 1e-13 * wide.energy);
    EXPECT_LT(largest(wide.gradient - 2 * once.gradient), 1e-13 * largest(wide.gradient));
    EXPECT_LT(largest(wide.hessian - once.hessian), 1e-13 * largest(wide.hessian));
  }
}

TEST(MembraneElement, PrestretchIsARestShapeShrunkByIt) {
  const Corners rest = rest_corners();
  const MembraneRest whole = make_membrane_rest(rest, kThickness);
  const MembraneRest shrunk = make_membrane_rest(rest, kThickness, evenly(1.25));
  EXPECT_NEAR(shrunk.area, whole.area / (1.25 * 1.25), 1e-15 * whole.area);
  EXPECT_EQ(shrunk.thickness, kThickness);
  const Eigen::Matrix<double, 3, 2> f = deformation_gradient(shrunk, rest);
  EXPECT_LT(largest(f.transpose() * f - 1.25 * 1.25 * Eigen::Matrix2d::Identity()), 1e-14);
}

TEST(MembraneElement, PrestretchOfTwoSizesStretchesOneAlongItsDirectionAndTheOtherAcrossIt) {
  const Corners rest = rest_corners();
  const Eigen::Vector3d along(0.4, 1, 0.3);
  // With fibres that way the axes of the rest plane are those of the stretch.
  const MembraneRest shrunk =
      make_membrane_rest(rest, kThickness, {.along = along, .first = 1.3, .second = 1.1}, along);
  EXPECT_NEAR(shrunk.area, make_membrane_rest(rest, kThickness).area / (1.3 * 1.1), 1e-15 * shrunk.area);
  const Eigen::Matrix<double, 3, 2> f = deformation_gradient(shrunk, rest);
  const Eigen::Matrix2d expected = Eigen::Vector2d(1.3 * 1.3, 1.1 * 1.1).asDiagonal();
  EXPECT_LT(largest(f.transpose() * f - expected), 1e-14);
}

TEST(MembraneElement, FibresAtAnAngleTakeTheClosedFormOfTheTurnedStrain) {
  // A stretch along x and one along y, fibres at an angle to x: the strain along and across them is turned by hand.
  const double c = 2e3, a1 = 3, a2 = 2, a3 = 0.8, a4 = 1.5;
  const Material material{find_wall_law("fung"), {c, a1, a2, a3, a4}};
  const double x = 0.5 * (1.3 * 1.3 - 1), y = 0.5 * (0.9 * 0.9 - 1);  // Green-Lagrange strain
  const Corners rest = {Eigen::Vector3d::Zero(), Eigen::Vector3d(3e-3, 0, 0), Eigen::Vector3d(1e-3, 2e-3, 0)};
  const Eigen::Matrix3d stretch = Eigen::Vector3d(1.3, 0.9, 1).asDiagonal();
  for (const double angle : {0.0, 0.5, 1.2}) {
    const double k = std::cos(angle), s = std::sin(angle);
    const double e11 = k * k * x + s * s * y, e22 = s * s * x + k * k * y, e12 = k * s * (y - x);
    const double energy =
        0.5 * c * (std::exp(a1 * e11 * e11 + a2 * e22 * e22 + 2 * a3 * e11 * e22 + a4 * e12 * e12) - 1);
    // The fibre points out of the plane as well: only its part in the plane counts.
    const MembraneRest turned = make_membrane_rest(rest, kThickness, {}, Eigen::Vector3d(k, s, 0.7));
    const double volume = 3e-6 * kThickness;
    EXPECT_NEAR(membrane_terms(turned, material, moved(rest, stretch, {0, 0, 0})).energy, volume * energy,
                1e-12 * volume * energy)
        << angle;
  }
}

}  // namespace
}  // namespace thinwall

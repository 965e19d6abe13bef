#include "engine/material/WallLaw.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

struct Example {
  const char* law;
  std::vector<double> parameters;
};

const std::vector<Example>& examples() {
  static const std::vector<Example> all = {{"st_venant_kirchhoff", {30e3, 0.3}},
                                           {"st_venant_kirchhoff", {30e3, 0.5}},
                                           {"neo_hookean", {20e3}},
                                           {"mooney_rivlin", {8e3, 2e3}},
                                           {"mooney_rivlin", {10e3, 0}},
                                           {"gent", {20e3, 30}},
                                           {"ogden", {12e3, 3, -2e3, -2, 400, 5.5}},
                                           {"fung", {2e3, 3, 2, 0.8, 1.5}},
                                           {"holzapfel", {5e3, 8e3, 0.3, 0.1, 0.6}},
                                           {"holzapfel", {5e3, 8e3, 0.3, 0, 0}},
                                           {"holzapfel", {5e3, 8e3, 0.3, 1.0 / 3, 0.6}}};
  return all;
}

const std::vector<Eigen::Vector3d>& strains() {
  static const std::vector<Eigen::Vector3d> all = {{1, 1, 0},       {1.3, 0.9, 0.1}, {2.2, 1.7, -0.4},
                                                   {0.6, 0.8, 0.2}, {4, 0.5, 0.3},   {0.3, 0.4, 0.1}};
  return all;
}

WallLawResponse respond(const Example& example, const Eigen::Vector3d& c) {
  return find_wall_law(example.law)->respond(example.parameters, c);
}

TEST(WallLaw, EveryRowHasAnExampleHere) {
  for (const WallLaw& law : wall_laws()) {
    bool found = false;
    for (const Example& example : examples()) found = found || law.name == example.law;
    EXPECT_TRUE(found) << law.name;
  }
}

TEST(WallLaw, UnknownNameGivesNoLaw) {
  EXPECT_EQ(find_wall_law("hookean"), nullptr);
}

TEST(WallLaw, IsFreeOfEnergyAndStressAtRest) {
  for (const Example& example : examples()) {
    const WallLawResponse response = respond(example, {1, 1, 0});
    EXPECT_NEAR(response.energy, 0, 1e-10) << example.law;
    EXPECT_LT(response.second_piola_kirchhoff.norm(), 1e-9) << example.law;
  }
}

TEST(WallLaw, StressIsTheDerivativeOfTheEnergyAndTheTangentThatOfTheStress) {
  // Central differences with h = 1e-5 leave about h^2 times the third derivative: residuals seen are below 2e-8.
  constexpr double h = 1e-5;
  for (const Example& example : examples()) {
    for (const Eigen::Vector3d& c : strains()) {
      // Fibres become taut at rest: the stress has a kink there.
      if (std::string_view(example.law) == "holzapfel" && c == Eigen::Vector3d(1, 1, 0)) continue;
      const WallLawResponse at = respond(example, c);
      const double scale = at.tangent.norm();
      for (int k = 0; k < 3; ++k) {
        Eigen::Vector3d step = Eigen::Vector3d::Zero();
        step[k] = k < 2 ? 2 * h : h;  // e = (E11, E22, 2 E12), C11 = 1 + 2 E11, C12 = 2 E12
        const WallLawResponse plus = respond(example, c + step), minus = respond(example, c - step);
        EXPECT_NEAR((plus.energy - minus.energy) / (2 * h), at.second_piola_kirchhoff[k], 1e-7 * scale) << example.law;
        const Eigen::Vector3d column = (plus.second_piola_kirchhoff - minus.second_piola_kirchhoff) / (2 * h);
        EXPECT_LT((column - at.tangent.col(k)).norm(), 1e-7 * scale) << example.law << " column " << k;
      }
      EXPECT_LT((at.tangent - at.tangent.transpose()).norm(), 1e-12 * scale) << example.law;
    }
  }
}

TEST(WallLaw, InitialModulusIsTheSlopeOfUniaxialStress) {
  for (const Example& example : examples()) {
    const Eigen::Matrix3d tangent = respond(example, {1, 1, 0}).tangent;
    const double modulus = tangent(0, 0) - tangent(0, 1) * tangent(1, 0) / tangent(1, 1);
    const double expected = find_wall_law(example.law)->initial_modulus(example.parameters);
    EXPECT_NEAR(modulus, expected, 1e-12 * expected) << example.law;
  }
}

/// C22 at which a wall of a given C11 is free of stress across.
double free_width(const Example& example, double first) {
  double least = 1e-9, most = 100;
  for (int halving = 0; halving < 200; ++halving) {
    const double middle = std::sqrt(least * most);
    const WallLawResponse response = respond(example, {first, middle, 0});
    const bool is_narrow = std::isfinite(response.energy) ? response.second_piola_kirchhoff[1] < 0 : middle < 1;
    (is_narrow ? least : most) = middle;
  }
  return std::sqrt(least * most);
}

TEST(WallLaw, PressedTogetherAWallPushesBackTheMoreTheSmallerItIs) {
  // A linear law by itself pushes less and less below a stretch of 1 / sqrt(3), and nothing at last.
  std::vector<Example> all = examples();
  for (const double nu : {-0.9, 0.0, 0.2, 0.4}) all.push_back({"st_venant_kirchhoff", {30e3, nu}});
  for (const Example& example : all) {
    double force = 0;  // newton / metre^2 of rest
    for (double stretch = 0.97; stretch > 0.1; stretch *= 0.97) {
      const double first = stretch * stretch;
      const double pushed =
          -stretch * respond(example, {first, free_width(example, first), 0}).second_piola_kirchhoff[0];
      EXPECT_GT(pushed, force) << example.law << " " << (example.parameters.size() > 1 ? example.parameters[1] : 0)
                               << " at " << stretch;
      force = pushed;
    }
  }
}

TEST(WallLaw, DrawnOutAWallKeepsAWidth) {
  // A linear law by itself has none left at a stretch of sqrt(1 + 1 / nu), 1.87 here.
  std::vector<Example> all = examples();
  for (const double nu : {0.4, 0.45}) all.push_back({"st_venant_kirchhoff", {30e3, nu}});
  for (const Example& example : all) EXPECT_GT(free_width(example, 4), 0.01) << example.law;
}

TEST(NeoHookean, UniaxialStressFollowsTheClosedForm) {
  // sigma = mu (lambda^2 - 1/lambda), with the stretch across free: S11 = sigma / lambda^2.
  for (const double stretch : {0.7, 1.0, 1.5, 2.5}) {
    const WallLawResponse response = respond({"neo_hookean", {20e3}}, {stretch * stretch, 1 / stretch, 0});
    EXPECT_NEAR(response.second_piola_kirchhoff[0], 20e3 * (1 - std::pow(stretch, -3)), 1e-9);
    EXPECT_NEAR(response.second_piola_kirchhoff[1], 0, 1e-9);
  }
}

TEST(MooneyRivlin, EquibiaxialStressFollowsTheClosedForm) {
  // sigma = 2 (lambda^2 - lambda^-4)(c1 + c2 lambda^2)
  for (const double stretch : {0.8, 1.2, 2.0, 3.0}) {
    const double square = stretch * stretch;
    const WallLawResponse response = respond({"mooney_rivlin", {8e3, 2e3}}, {square, square, 0});
    const double sigma = 2 * (square - std::pow(stretch, -4)) * (8e3 + 2e3 * square);
    EXPECT_NEAR(response.second_piola_kirchhoff[0] * square, sigma, 1e-11 * std::abs(sigma) + 1e-9);
  }
}

TEST(MooneyRivlin, WithoutItsSecondTermIsNeoHookean) {
  for (const Eigen::Vector3d& c : strains()) {
    const WallLawResponse mooney = respond({"mooney_rivlin", {10e3, 0}}, c), neo = respond({"neo_hookean", {20e3}}, c);
    EXPECT_NEAR(mooney.energy, neo.energy, 1e-12 * std::abs(neo.energy));
    EXPECT_LT((mooney.tangent - neo.tangent).norm(), 1e-12 * neo.tangent.norm());
  }
}

/// What keeps a wall from shrinking to nothing, of a law with this modulus.
HyperDual written_guard(double modulus, const HyperDual& det) {
  if (det.value >= 0.5) return 0;
  const HyperDual depth = log(0.5 / det);
  return 0.1 * modulus * depth * depth * depth;
}

/// The energies as the literature writes them, in principal stretches, invariants and strains.
HyperDual written_energy(const Example& example, const DualVector& c) {
  const std::vector<double>& p = example.parameters;
  const std::string_view law = example.law;
  const HyperDual det = c[0] * c[1] - c[2] * c[2], trace = c[0] + c[1];
  const HyperDual i1 = trace + 1 / det, i2 = trace / det + det;
  const HyperDual e11 = 0.5 * (c[0] - 1), e22 = 0.5 * (c[1] - 1), e12 = 0.5 * c[2];
  if (law == "st_venant_kirchhoff") {
    const HyperDual form = e11 * e11 + e22 * e22 + 2 * p[1] * e11 * e22 + 2 * (1 - p[1]) * e12 * e12;
    return 0.5 * p[0] / (1 - p[1] * p[1]) * form + written_guard(p[0], det);
  }
  if (law == "neo_hookean") return 0.5 * p[0] * (i1 - 3);
  if (law == "mooney_rivlin") return p[0] * (i1 - 3) + p[1] * (i2 - 3);
  if (law == "gent") return -0.5 * p[0] * p[1] * log(1 - (i1 - 3) / p[1]);
  if (law == "fung") {
    const HyperDual q = p[1] * e11 * e11 + p[2] * e22 * e22 + 2 * p[3] * e11 * e22 + p[4] * e12 * e12;
    return 0.5 * p[0] * (exp(q) - 1) + written_guard(p[0] * (p[1] - p[3] * p[3] / p[2]), det);
  }
  if (law == "ogden") {
    const HyperDual root = sqrt(0.25 * (c[0] - c[1]) * (c[0] - c[1]) + c[2] * c[2]);
    const HyperDual l1 = sqrt(0.5 * trace + root), l2 = sqrt(0.5 * trace - root), l3 = 1 / (l1 * l2);
    HyperDual energy = 0;
    for (std::size_t k = 0; k < p.size(); k += 2) {
      energy = energy + p[k] / p[k + 1] * (pow(l1, p[k + 1]) + pow(l2, p[k + 1]) + pow(l3, p[k + 1]) - 3);
    }
    return energy;
  }
  HyperDual energy = 0.5 * p[0] * (i1 - 3);
  for (const double side : {1.0, -1.0}) {
    const double m1 = std::cos(p[4]), m2 = side * std::sin(p[4]);
    const HyperDual i4 = m1 * m1 * c[0] + m2 * m2 * c[1] + 2 * m1 * m2 * c[2];
    const HyperDual strain = p[3] * (i1 - 3) + (1 - 3 * p[3]) * (i4 - 1);
    if (strain.value >= 0) energy = energy + 0.5 * p[1] / p[2] * (exp(p[2] * strain * strain) - 1);
  }
  return energy;
}

TEST(WallLaw, AgreesWithExactDerivativesOfTheWrittenEnergy) {
  // Both sides are exact up to round-off: residuals seen are printed; the written Ogden energy loses digits where its
  // stretches are nearly equal, and has no derivatives where they are.
  double seen = 0;
  for (const Example& example : examples()) {
    for (const Eigen::Vector3d& c : strains()) {
      if (std::string_view(example.law) == "ogden" && c == Eigen::Vector3d(1, 1, 0)) continue;
      const WallLawResponse response = respond(example, c);
      const double scale = std::max(response.tangent.norm(), 1e3);
      for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
          DualVector moved = {c[0], c[1], c[2]};
          moved[i].first = i < 2 ? 2 : 1;  // e = (E11, E22, 2 E12): C11 = 1 + 2 e1, C12 = e3
          moved[j].second = j < 2 ? 2 : 1;
          const HyperDual exact = written_energy(example, moved);
          const double error = std::max({std::abs(response.energy - exact.value),
                                         std::abs(response.second_piola_kirchhoff[i] - exact.first),
                                         std::abs(response.tangent(i, j) - exact.both)}) /
                               scale;
          seen = std::max(seen, error);
          EXPECT_LT(error, 1e-12) << example.law << " at " << c.transpose() << ", entry " << i << j;
        }
      }
    }
  }
  std::printf("largest relative residual: %.1e\n", seen);
}

/// A stretch along the fibres and one across them.
struct Stretches {
  double along, across;
};

/// Uniaxial tension of an incompressible isotropic wall, equibiaxial tension, pure shear.
std::vector<Stretches> three_tests(double stretch) {
  return {{stretch, 1 / std::sqrt(stretch)}, {stretch, stretch}, {stretch, 1}};
}

void expect_principal_stress(const Example& example, const Stretches& l, double along, double across) {
  const WallLawResponse response = respond(example, {l.along * l.along, l.across * l.across, 0});
  // Residuals seen are below 1e-13 of the stress.
  const double scale = std::abs(along) + std::abs(across) + 1;
  EXPECT_NEAR(response.second_piola_kirchhoff[0], along, 1e-11 * scale) << example.law << " " << l.along;
  EXPECT_NEAR(response.second_piola_kirchhoff[1], across, 1e-11 * scale) << example.law << " " << l.along;
  EXPECT_NEAR(response.second_piola_kirchhoff[2], 0, 1e-11 * scale) << example.law;
}

TEST(Gent, StressesOfTheThreeTestsFollowTheClosedForms) {
  // S1 = mu Jm / (Jm - I1 + 3) (1 - l3^2 / l1^2) (Gent 1996)
  for (const double stretch : {0.8, 1.3, 2.5}) {
    for (const Stretches& l : three_tests(stretch)) {
      const double across_wall = 1 / std::pow(l.along * l.across, 2), first = l.along * l.along,
                   second = l.across * l.across;
      const double factor = 20e3 * 50 / (50 - (first + second + across_wall - 3));
      expect_principal_stress({"gent", {20e3, 50}}, l, factor * (1 - across_wall / first),
                              factor * (1 - across_wall / second));
    }
  }
}

TEST(Gent, EnergyIsInfiniteFromItsLimitOn) {
  const Example gent{"gent", {20e3, 3}};
  for (const double l : {1.72, 1.8}) {  // 2 l^2 + l^-4 - 3 = 3.03 and 3.6
    const WallLawResponse beyond = respond(gent, {l * l, l * l, 0});
    EXPECT_TRUE(std::isinf(beyond.energy)) << l;
    EXPECT_TRUE(beyond.second_piola_kirchhoff.isZero() && beyond.tangent.isZero()) << l;
  }
  EXPECT_TRUE(std::isfinite(respond(gent, {1.7 * 1.7, 1.7 * 1.7, 0}).energy));  // 2.9
}

TEST(Gent, FarLimitIsNeoHookean) {
  // The difference is about (I1 - 3) / Jm, some 2e-5 at most.
  for (const Eigen::Vector3d& c : strains()) {
    const WallLawResponse gent = respond({"gent", {20e3, 1e6}}, c), neo = respond({"neo_hookean", {20e3}}, c);
    EXPECT_LT((gent.tangent - neo.tangent).norm(), 1e-4 * neo.tangent.norm());
  }
}

TEST(Ogden, StressesOfTheThreeTestsFollowTheClosedForms) {
  // S1 = sum of mu_p (l1^alpha_p - l3^alpha_p) / l1^2 (Ogden 1972), with his constants for rubber, pascal.
  const Example rubber{"ogden", {6.3e5, 1.3, 1.2e3, 5, -1e4, -2}};
  for (const double stretch : {0.8, 1.3, 2.5, 6.0}) {
    for (const Stretches& l : three_tests(stretch)) {
      double along = 0, across = 0;
      for (std::size_t k = 0; k < 6; k += 2) {
        const double mu = rubber.parameters[k], alpha = rubber.parameters[k + 1];
        const double wall = std::pow(l.along * l.across, -alpha);
        along += mu * (std::pow(l.along, alpha) - wall) / (l.along * l.along);
        across += mu * (std::pow(l.across, alpha) - wall) / (l.across * l.across);
      }
      expect_principal_stress(rubber, l, along, across);
    }
  }
}

TEST(Ogden, WithTheExponentsTwoAndMinusTwoIsMooneyRivlinAlsoWhereStretchesAreEqual) {
  std::vector<Eigen::Vector3d> places = strains();
  places.insert(places.end(), {{1.7, 1.7, 0}, {1.7, 1.7, 1e-9}, {1.7, 1.7 + 1e-12, 0}, {0.4, 0.4, 1e-5}});
  for (const Eigen::Vector3d& c : places) {
    const WallLawResponse ogden = respond({"ogden", {16e3, 2, -4e3, -2}}, c);
    const WallLawResponse mooney = respond({"mooney_rivlin", {8e3, 2e3}}, c);
    // Residuals seen: 2e-15 of the tangent.
    EXPECT_NEAR(ogden.energy, mooney.energy, 1e-12 * mooney.tangent.norm());
    EXPECT_LT((ogden.second_piola_kirchhoff - mooney.second_piola_kirchhoff).norm(), 1e-12 * mooney.tangent.norm());
    EXPECT_LT((ogden.tangent - mooney.tangent).norm(), 1e-12 * mooney.tangent.norm());
  }
}

TEST(Ogden, TangentHasNoJumpWhereTwoStretchesMeet) {
  const Example example = {"ogden", {12e3, 3, -2e3, -2, 400, 5.5}};
  const Eigen::Matrix3d at = respond(example, {1.7, 1.7, 0}).tangent;
  for (const double step : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    for (const Eigen::Vector3d& way : {Eigen::Vector3d(1, -1, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 1)}) {
      const Eigen::Matrix3d near = respond(example, Eigen::Vector3d(1.7, 1.7, 0) + step * way).tangent;
      EXPECT_LT((near - at).norm(), (10 * step + 1e-14) * at.norm()) << step;
    }
  }
}

TEST(Ogden, TermsWithoutStiffnessAtRestAreRefused) {
  const WallLaw& law = *find_wall_law("ogden");
  EXPECT_EQ(law.complaint(std::vector<double>{1e3, 2, -1e3, -2}), "");
  EXPECT_NE(law.complaint(std::vector<double>{1e3, -2}), "");
  EXPECT_NE(law.complaint(std::vector<double>{1e3, 2, 5, 0}), "");
}

TEST(Fung, StressesOfTheThreeTestsFollowTheClosedForms) {
  // S11 = c exp(Q) (a1 E11 + a3 E22), S22 = c exp(Q) (a3 E11 + a2 E22); a free side has E22 = -a3/a2 E11.
  const double c = 2e3, a1 = 3, a2 = 2, a3 = 0.8;
  const Example fung{"fung", {c, a1, a2, a3, 1.5}};
  for (const double stretch : {0.9, 1.2, 1.6}) {
    const double strain = 0.5 * (stretch * stretch - 1);
    for (const double across : {-a3 / a2 * strain, strain, 0.0}) {
      const double growth = c * std::exp(a1 * strain * strain + a2 * across * across + 2 * a3 * strain * across);
      expect_principal_stress(fung, {stretch, std::sqrt(1 + 2 * across)}, growth * (a1 * strain + a3 * across),
                              growth * (a3 * strain + a2 * across));
    }
  }
}

TEST(Fung, IsTheSameInEveryDirectionWhereItsShearFactorSaysSo) {
  // a1 = a2 and a4 = a1 + a2 - 2 a3: Q = a3 (tr E)^2 + (a1 - a3) tr E^2.
  const Example fung{"fung", {2e3, 3, 3, 0.8, 4.4}};
  const double k = std::cos(0.7), s = std::sin(0.7), c1 = 1.7, c2 = 0.9;
  const Eigen::Vector3d turned(k * k * c1 + s * s * c2, s * s * c1 + k * k * c2, k * s * (c1 - c2));
  EXPECT_NEAR(respond(fung, turned).energy, respond(fung, {c1, c2, 0}).energy, 1e-11);
}

TEST(Fung, OverflowGivesAnInfiniteEnergyAndNoNumberThatIsNone) {
  const WallLawResponse beyond = respond({"fung", {2e3, 300, 200, 80, 150}}, {9, 9, 0});
  EXPECT_TRUE(std::isinf(beyond.energy));
  EXPECT_TRUE(beyond.second_piola_kirchhoff.isZero() && beyond.tangent.isZero());
}

TEST(Fung, CouplingThatMakesTheEnergyFallIsRefused) {
  const WallLaw& law = *find_wall_law("fung");
  EXPECT_EQ(law.complaint(std::vector<double>{2e3, 3, 2, 2.4, 1}), "");
  EXPECT_NE(law.complaint(std::vector<double>{2e3, 3, 2, 2.5, 1}), "");
  EXPECT_NE(law.complaint(std::vector<double>{2e3, 4, 1, 2, 1}), "") << "with a strain that costs nothing";
}

TEST(Holzapfel, StressesOfTheThreeTestsFollowTheClosedFormsForTwoAngles) {
  // Both families are stretched alike: E = kappa (I1 - 3) + (1 - 3 kappa)(l1^2 cos^2 + l2^2 sin^2 - 1).
  const double mu = 5e3, k1 = 8e3, k2 = 0.3;
  for (const double angle : {0.0, std::numbers::pi / 6, 0.9}) {
    for (const double kappa : {0.0, 0.1, 1.0 / 3}) {
      for (const double stretch : {0.8, 1.2, 1.6}) {
        for (const Stretches& l : three_tests(stretch)) {
          const double first = l.along * l.along, second = l.across * l.across, wall = 1 / (first * second);
          const double m1 = std::pow(std::cos(angle), 2), m2 = std::pow(std::sin(angle), 2);
          const double strain =
              std::max(0.0, kappa * (first + second + wall - 3) + (1 - 3 * kappa) * (first * m1 + second * m2 - 1));
          const double pull = 4 * k1 * strain * std::exp(k2 * strain * strain);
          const double along = (mu + pull * kappa) * (1 - wall / first) + pull * (1 - 3 * kappa) * m1;
          const double across = (mu + pull * kappa) * (1 - wall / second) + pull * (1 - 3 * kappa) * m2;
          expect_principal_stress({"holzapfel", {mu, k1, k2, kappa, angle}}, l, along, across);
        }
      }
    }
  }
}

TEST(Holzapfel, FibresThatAreShortenedDoNothing) {
  const Eigen::Vector3d shortened(0.8, 1.1, 0);
  const WallLawResponse with = respond({"holzapfel", {5e3, 8e3, 0.3, 0, 0}}, shortened);
  const WallLawResponse without = respond({"neo_hookean", {5e3}}, shortened);
  EXPECT_EQ(with.energy, without.energy);
  EXPECT_EQ(with.second_piola_kirchhoff, without.second_piola_kirchhoff);
}

}  // namespace
}  // namespace thinwall

#include "engine/material/WallLaw.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

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
                                           {"mooney_rivlin", {10e3, 0}}};
  return all;
}

const std::vector<Eigen::Vector3d>& strains() {
  static const std::vector<Eigen::Vector3d> all = {
      {1, 1, 0}, {1.3, 0.9, 0.1}, {2.2, 1.7, -0.4}, {0.6, 0.8, 0.2}, {4, 0.5, 0.3}};
  return all;
}

WallLawResponse respond(const Example& example, const Eigen::Vector3d& c) {
  return find_wall_law(example.law)->respond(example.parameters.data(), c);
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
    const double expected = find_wall_law(example.law)->initial_modulus(example.parameters.data());
    EXPECT_NEAR(modulus, expected, 1e-12 * expected) << example.law;
  }
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

}  // namespace
}  // namespace thinwall

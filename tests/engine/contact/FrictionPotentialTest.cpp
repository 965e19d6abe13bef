#include "engine/contact/FrictionPotential.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/engine/HyperDual.hpp"

namespace thinwall {
namespace {

const Eigen::Vector3d kNormal = Eigen::Vector3d(0.2, -0.4, 0.9).normalized();
constexpr FrictionPotential kPotential{.limit = 0.7, .give = 0.02};

FrictionTerms terms_at(const FrictionPotential& potential, const Eigen::Vector3d& slip) {
  return potential.at(slip, kNormal, potential.stiffness() * potential.elastic_part(slip));
}

Eigen::Vector3d tangential(const Eigen::Vector3d& v) {
  return v - kNormal * kNormal.dot(v);
}

/// The energy as a function of where the wall is, written down a second time.
HyperDual energy_at(const std::array<HyperDual, 3>& place) {
  HyperDual across = 0, squared = 0;
  for (int k = 0; k < 3; ++k) across = across + kNormal[k] * place[k];
  for (int k = 0; k < 3; ++k) {
    const HyperDual slip = place[k] - across * kNormal[k];
    squared = squared + slip * slip;
  }
  const double limit = kPotential.limit, give = kPotential.give;
  if (std::sqrt(squared.value) <= give) return limit / (2 * give) * squared;
  return limit * sqrt(squared) - 0.5 * limit * give;
}

TEST(FrictionPotential, HasTheDerivativesOfItsEnergyStickingAndSliding) {
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(0.01, 0.005, 0.3), Eigen::Vector3d(0.4, -0.2, 0.1)}) {
    const FrictionTerms terms = terms_at(kPotential, tangential(place));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        std::array<HyperDual, 3> dual;
        for (int k = 0; k < 3; ++k) dual[k] = HyperDual(place[k], i == k ? 1 : 0, j == k ? 1 : 0, 0);
        const HyperDual energy = energy_at(dual);
        EXPECT_NEAR(terms.energy, energy.value, 1e-15);
        EXPECT_NEAR(terms.gradient[i], energy.first, 1e-15);
        EXPECT_NEAR(terms.hessian(i, j), energy.both, 1e-13);
      }
    }
  }
}

TEST(FrictionPotential, NeverPullsWithMoreThanItsLimitAndIsContinuousWhereSlidingBegins) {
  const Eigen::Vector3d along = tangential({1, 2, 3}).normalized();
  const double begin = kPotential.give;
  const FrictionTerms below = terms_at(kPotential, (1 - 1e-12) * begin * along);
  const FrictionTerms above = terms_at(kPotential, (1 + 1e-12) * begin * along);
  EXPECT_NEAR(below.energy, above.energy, 1e-12);
  EXPECT_LT((below.gradient - above.gradient).norm(), 1e-11);
  for (const double slip : {0.1, 1.0, 3.0, 1e6}) {
    EXPECT_LE(terms_at(kPotential, slip * begin * along).gradient.norm(), kPotential.limit * (1 + 1e-15));
  }
}

TEST(FrictionPotential, GivesBackOnlyTheElasticPartOfTheSlip) {
  const Eigen::Vector3d along = tangential({1, 2, 3}).normalized();
  const double begin = kPotential.give;
  EXPECT_EQ(kPotential.elastic_part(0.5 * begin * along), 0.5 * begin * along);
  EXPECT_LT((kPotential.elastic_part(7 * begin * along) - begin * along).norm(), 1e-15);
}

TEST(FrictionPotential, EstimatesStayWithinTheLimitAndCatchUpWithTheForce) {
  const Eigen::Vector3d slip = tangential({0.4, -0.2, 0.1});
  Eigen::Vector3d estimate = tangential({-0.1, 0.5, 0.2});
  const FrictionTerms behind = kPotential.at(slip, kNormal, estimate);
  EXPECT_EQ(behind.gradient, terms_at(kPotential, slip).gradient);
  EXPECT_GT(slip.dot(behind.hessian * slip), 0.1 * kPotential.limit / slip.norm() * slip.squaredNorm());
  for (const double change : {3.0, -7.0, 0.0}) {
    estimate = kPotential.next_estimate(slip, change * slip, estimate);
    EXPECT_LE(estimate.norm(), kPotential.limit * (1 + 1e-15));
  }
  EXPECT_LT((estimate - behind.gradient).norm(), 1e-15);
}

TEST(FrictionPotential, WithoutNormalForceDoesNothing) {
  const FrictionPotential none{.limit = 0, .give = 0.02};
  EXPECT_EQ(terms_at(none, tangential({1, 2, 3})).gradient.norm(), 0);
  EXPECT_EQ(terms_at(none, Eigen::Vector3d::Zero()).gradient.norm(), 0);
}

}  // namespace
}  // namespace thinwall

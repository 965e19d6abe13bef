#include "engine/contact/PairDistance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/contact/FoldPotential.hpp"

namespace thinwall {
namespace {

PairCorners random_corners(std::mt19937& random) {
  std::uniform_real_distribution<double> draw(-1, 1);
  PairCorners corners;
  for (Eigen::Vector3d& corner : corners) corner = {draw(random), draw(random), draw(random)};
  return corners;
}

/// By trying many places of both parts.
double sampled_distance(PairKind kind, const PairCorners& x, int samples) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) {
    for (int j = 0; j <= samples; ++j) {
      const double s = static_cast<double>(i) / samples, t = static_cast<double>(j) / samples;
      const Eigen::Vector3d offset =
          kind == PairKind::kEdgeEdge ? Eigen::Vector3d(x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2]))
                                      : Eigen::Vector3d(x[0] - x[1] - s * (x[2] - x[1]) - (1 - s) * t * (x[3] - x[1]));
      smallest = std::min(smallest, offset.norm());
    }
  }
  return smallest;
}

Eigen::Matrix<double, 12, 1> as_vector(const PairCorners& corners) {
  Eigen::Matrix<double, 12, 1> vector;
  for (int k = 0; k < 4; ++k) vector.segment<3>(3 * k) = corners[k];
  return vector;
}
PairCorners as_corners(const Eigen::Matrix<double, 12, 1>& vector) {
  return {vector.segment<3>(0), vector.segment<3>(3), vector.segment<3>(6), vector.segment<3>(9)};
}

/// Central differences of a value and of its gradient.
template <typename Value>
Eigen::Matrix<double, 12, 1> difference(const Value& value, const PairCorners& corners, double step) {
  const Eigen::Matrix<double, 12, 1> middle = as_vector(corners);
  Eigen::Matrix<double, 12, 1> slopes;
  for (int k = 0; k < 12; ++k) {
    Eigen::Matrix<double, 12, 1> up = middle, down = middle;
    up[k] += step;
    down[k] -= step;
    slopes[k] = (value(as_corners(up)) - value(as_corners(down))) / (2 * step);
  }
  return slopes;
}
template <typename Gradient>
Eigen::Matrix<double, 12, 12> gradient_difference(const Gradient& gradient, const PairCorners& corners, double step) {
  const Eigen::Matrix<double, 12, 1> middle = as_vector(corners);
  Eigen::Matrix<double, 12, 12> slopes;
  for (int k = 0; k < 12; ++k) {
    Eigen::Matrix<double, 12, 1> up = middle, down = middle;
    up[k] += step;
    down[k] -= step;
    slopes.col(k) = (gradient(as_corners(up)) - gradient(as_corners(down))) / (2 * step);
  }
  return slopes;
}

constexpr PairKind kPairKinds[] = {PairKind::kPointTriangle, PairKind::kEdgeEdge};

TEST(PairDistance, IsTheSmallestOverAllPlaces) {
  std::mt19937 random(3);
  for (const PairKind kind : kPairKinds) {
    for (int k = 0; k < 60; ++k) {
      const PairCorners corners = random_corners(random);
      const double sampled = sampled_distance(kind, corners, 200);
      const double distance = pair_distance(kind, corners).distance;
      EXPECT_LE(distance, sampled + 1e-14);
      EXPECT_GT(distance, sampled - 2 * 3.5 / 200);  // a sample lies within half a spacing of edges up to 3.5 long
    }
  }
}

TEST(PairDistance, IsNeverBelowTheGapBetweenTheCentres) {
  std::mt19937 random(17);
  for (const PairKind kind : kPairKinds) {
    int apart = 0;
    for (int k = 0; k < 5000; ++k) {
      PairCorners corners = random_corners(random);
      // From within each other to well apart.
      const Eigen::Vector3d away = 4e-4 * k * Eigen::Vector3d::UnitX();
      corners[0] += away;
      if (kind == PairKind::kEdgeEdge) corners[1] += away;
      const double least = least_distance(kind, corners), distance = pair_distance(kind, corners).distance;
      // Rounding only: they are equal where two corners face each other along the centres' line.
      EXPECT_LE(least, distance + 1e-14);
      if (least > 0.5 * distance) ++apart;
    }
    EXPECT_GT(apart, 1000);
  }
}

TEST(PairDistance, IsTheGapBetweenTheCentresWherePartsFaceEachOther) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  EXPECT_DOUBLE_EQ(least_distance(PairKind::kEdgeEdge, {x, -x, y + 2 * z, 2 * z - y}), 2);
  EXPECT_DOUBLE_EQ(least_distance(PairKind::kPointTriangle, {3 * z, x + y, x - y, -2 * x}), 3);
  EXPECT_EQ(least_distance(PairKind::kEdgeEdge, {x, -x, y, -y}), 0);
}

TEST(PairDistance, OffsetIsWhatTheWeightsCombine) {
  std::mt19937 random(4);
  for (const PairKind kind : kPairKinds) {
    for (int k = 0; k < 100; ++k) {
      const PairCorners corners = random_corners(random);
      const PairDistance closest = pair_distance(kind, corners);
      Eigen::Vector3d offset = Eigen::Vector3d::Zero();
      for (int c = 0; c < 4; ++c) offset += closest.weights[c] * corners[c];
      EXPECT_LT((offset - closest.offset).norm(), 1e-15);
      EXPECT_NEAR(closest.weights.sum(), 0, 1e-15);
      EXPECT_NEAR(closest.offset.norm(), closest.distance, 1e-15);
      // The first part counts positive.
      EXPECT_GE(closest.weights[0], 0);
      EXPECT_LE(closest.weights[3], 0);
    }
  }
}

TEST(PairDistance, HasTheDerivativesOfItsDifferences) {
  std::mt19937 random(5);
  std::array<int, 3> seen = {0, 0, 0};  // by slides: corners, edges, interiors
  for (const PairKind kind : kPairKinds) {
    for (int k = 0; k < 200; ++k) {
      const PairCorners corners = random_corners(random);
      const PairDistance closest = pair_distance(kind, corners);
      const auto value = [&](const PairCorners& moved) { return pair_distance(kind, moved).distance; };
      const auto gradient = [&](const PairCorners& moved) { return distance_gradient(pair_distance(kind, moved)); };
      if (closest.distance < 0.05) continue;
      // The distance has one slope everywhere, but jumps in curvature where the closest part changes.
      EXPECT_LT((distance_gradient(closest) - difference(value, corners, 1e-6)).norm(), 1e-7);
      const Eigen::Matrix<double, 12, 12> hessian = distance_hessian(closest, corners);
      const Eigen::Matrix<double, 12, 12> expected = gradient_difference(gradient, corners, 1e-7);
      const bool changes = [&] {
        const Eigen::Matrix<double, 12, 1> middle = as_vector(corners);
        for (int c = 0; c < 24; ++c) {
          const Eigen::Matrix<double, 12, 1> moved =
              middle + (c % 2 ? 1e-6 : -1e-6) * Eigen::Matrix<double, 12, 1>::Unit(c / 2);
          if (pair_distance(kind, as_corners(moved)).slide_count != closest.slide_count) return true;
        }
        return false;
      }();
      if (changes) continue;
      ++seen[closest.slide_count];
      EXPECT_LT((hessian - expected).norm(), 1e-5 * (1 + expected.norm()));
    }
  }
  for (const int count : seen) EXPECT_GT(count, 5);
}

TEST(PairDistance, OfParallelEdgesIsThatOfTheirLines) {
  const PairCorners overlapping = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.3, 0.2, 0),
                                   Eigen::Vector3d(1.3, 0.2, 0)};
  EXPECT_NEAR(pair_distance(PairKind::kEdgeEdge, overlapping).distance, 0.2, 1e-15);
  const PairCorners apart = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(4, 4, 0),
                             Eigen::Vector3d(9, 4, 0)};
  EXPECT_NEAR(pair_distance(PairKind::kEdgeEdge, apart).distance, 5, 1e-15);
}

TEST(PairDistance, IsZeroWhereAVertexLiesOnAnEdge) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_NEAR(pair_distance(PairKind::kPointTriangle, {Eigen::Vector3d(0.4, 0, 0), a, b, c}).distance, 0, 1e-16);
  EXPECT_NEAR(pair_distance(PairKind::kPointTriangle, {a, a, b, c}).distance, 0, 1e-16);
  EXPECT_NEAR(
      pair_distance(PairKind::kEdgeEdge, {a, b, Eigen::Vector3d(0.4, 0, 0), Eigen::Vector3d(0.4, 0, 2)}).distance, 0,
      1e-16);
}

TEST(PairDistance, OfAnEdgeWithoutLengthIsThatOfItsPoint) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), p(0.5, 0.3, 0);
  EXPECT_NEAR(pair_distance(PairKind::kEdgeEdge, {a, b, p, p}).distance, 0.3, 1e-15);
}

FoldPair make_pair_at(PairKind kind, const PairCorners& corners, double range, double parallel) {
  return {.kind = kind,
          .corners = corners,
          .closest = pair_distance(kind, corners),
          .potential = {.range = range, .pressure = 2, .area = 0.3},
          .parallel = parallel};
}

TEST(FoldPair, HasTheDerivativesOfItsDifferences) {
  std::mt19937 random(6);
  int fading = 0, whole = 0;
  for (const PairKind kind : kPairKinds) {
    for (int k = 0; k < 200; ++k) {
      const PairCorners corners = random_corners(random);
      // Half of the edges count as nearly parallel, and half of the triangles as crushed.
      const double parallel = k % 2 ? 1e-3 : 4;
      const FoldPair pair = make_pair_at(kind, corners, 1.5, parallel);
      if (pair.closest.distance < 0.1 || pair.closest.distance > 1.4) continue;
      (parallel == 4 ? fading : whole) += 1;
      const auto value = [&](const PairCorners& moved) {
        return make_pair_at(kind, moved, 1.5, parallel).terms().energy;
      };
      const auto gradient = [&](const PairCorners& moved) {
        return make_pair_at(kind, moved, 1.5, parallel).terms().gradient;
      };
      const FoldTerms terms = pair.terms();
      EXPECT_LT((terms.gradient - difference(value, corners, 1e-6)).norm(), 1e-7 * (1 + terms.gradient.norm()));
      const Eigen::Matrix<double, 12, 12> expected = gradient_difference(gradient, corners, 1e-7);
      // Where the closest part changes the curvature jumps, which one difference in many thousands meets.
      EXPECT_LT((pair.hessian() - expected).norm(), 1e-5 * (1 + expected.norm()));
    }
  }
  EXPECT_GT(fading, 20);
  EXPECT_GT(whole, 50);
}

TEST(FoldPair, PushesWithoutNetForceOrMoment) {
  std::mt19937 random(7);
  for (const PairKind kind : kPairKinds) {
    for (int k = 0; k < 50; ++k) {
      const PairCorners corners = random_corners(random);
      const FoldTerms terms = make_pair_at(kind, corners, 4, 1).terms();
      Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
      for (int c = 0; c < 4; ++c) {
        force += terms.gradient.segment<3>(3 * c);
        moment += corners[c].cross(Eigen::Vector3d(terms.gradient.segment<3>(3 * c)));
      }
      EXPECT_LT(force.norm(), 1e-13 * terms.gradient.norm());
      EXPECT_LT(moment.norm(), 1e-13 * terms.gradient.norm());
    }
  }
}

TEST(FoldPair, OfEdgesFadesSmoothlyAsTheyBecomeParallel) {
  // Two edges across each other's middle, turned through parallel: without the fading, the force would jump from one
  // pair of ends to the other.
  const auto turned = [](double angle) {
    const Eigen::Vector3d half(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0);
    const PairCorners corners = {Eigen::Vector3d(-0.5, 0, 0), Eigen::Vector3d(0.5, 0, 0),
                                 Eigen::Vector3d(0, 0, 0.1) - half, Eigen::Vector3d(0, 0, 0.1) + half};
    return make_pair_at(PairKind::kEdgeEdge, corners, 0.2, 1e-3).terms();
  };
  const double whole = turned(0.5).gradient.norm();
  // The force rises evenly from zero on either side.
  EXPECT_LT(turned(1e-6).gradient.norm(), 1e-3 * whole);
  EXPECT_LT((turned(1e-6).gradient - turned(-1e-6).gradient).norm(), 1e-3 * whole);
  EXPECT_GT(turned(0.04).gradient.norm(), 0.9 * whole);
  EXPECT_EQ(turned(0).energy, 0);
}

TEST(FoldPair, OfACrushedTriangleFadesSmoothlyAsItsCornerPassesItsSide) {
  // A point in the plane of a triangle whose third corner comes through the side that the point lies at: without the
  // fading that corner would be pushed all at once.
  const auto passed = [](double beyond) {
    const PairCorners corners = {Eigen::Vector3d(0.4, -0.1, 0), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                 Eigen::Vector3d(0.5, -beyond, 0)};
    return make_pair_at(PairKind::kPointTriangle, corners, 0.2, 1e-3).terms();
  };
  const double whole = passed(-0.5).gradient.norm();
  EXPECT_LT(passed(1e-6).gradient.norm(), 1e-3 * whole);
  EXPECT_LT((passed(1e-6).gradient - passed(-1e-6).gradient).norm(), 1e-3 * whole);
  EXPECT_NEAR(passed(-0.04).gradient.norm(), whole, 1e-12 * whole);
  EXPECT_EQ(passed(0).energy, 0);
}

/// A point over a triangle, or an edge over another, at a part of the range of 0.1 mm, metres.
FoldPair pair_above(PairKind kind, double part) {
  const double height = part * 1e-4;
  const PairCorners of_point = {{{0.4e-3, 0.3e-3, height}, {0, 0, 0}, {1e-3, 0, 0}, {0.2e-3, 1e-3, 0}}};
  const PairCorners of_edges = {
      {{-0.5e-3, 0.1e-3, height}, {0.6e-3, 0.2e-3, height}, {0.1e-3, -0.5e-3, 0}, {0, 0.7e-3, 0}}};
  return make_pair_at(kind, kind == PairKind::kPointTriangle ? of_point : of_edges, 1e-4, 0);
}

double least_eigenvalue(const Eigen::Matrix<double, 12, 12>& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>>(matrix).eigenvalues().minCoeff();
}

TEST(FoldPair, HasAConvexPartThatIsNeverNegative) {
  for (const PairKind kind : kPairKinds) {
    for (const double part : {0.5, 0.05, 1e-3, 1e-6}) {
      const Eigen::Matrix<double, 12, 12> convex = pair_above(kind, part).convex_hessian();
      EXPECT_GT(least_eigenvalue(convex), -1e-12 * convex.norm()) << part;
    }
  }
}

TEST(FoldPair, HasAConvexPartAboveItsCurvatureInAnyDirectionWhereItIsCrushed) {
  for (const PairKind kind : kPairKinds) {
    for (const double part : {5e-3, 1e-4, 1e-6}) {
      const FoldPair pair = pair_above(kind, part);
      // What it has along the wall, force over the edge's length, is far below what it has across it.
      const double along = -pair.potential.at(part * pair.potential.range).slope / 1e-3;
      EXPECT_GT(least_eigenvalue(pair.convex_hessian() - pair.hessian()), -1e-3 * along) << part;
    }
  }
}

TEST(FoldPotential, EndsSmoothlyAtItsRangeAndGrowsWithoutBound) {
  const FoldPotential potential{.range = 1e-3, .pressure = 1e3, .area = 1e-6};
  EXPECT_EQ(potential.at(1e-3).energy, 0);
  EXPECT_NEAR(potential.at(0.999999e-3).curvature, 0, 1e-5 * potential.at(0.5e-3).curvature);
  EXPECT_NEAR(-potential.at(0.5e-3).slope, 1.193e-3, 1e-6);
  EXPECT_GT(-potential.at(1e-9).slope, 1e5 * 1e-3);
  EXPECT_GT(potential.at(1e-9).energy, potential.at(1e-8).energy);
}

}  // namespace
}  // namespace thinwall

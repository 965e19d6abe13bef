// The cap over an opening: what it adds to volume and area, its derivatives, and the load of a pressure on a wall with
// an opening.

#include "engine/fluid/LipCap.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/fluid/EnclosedVolume.hpp"

namespace thinwall {
namespace {

Eigen::Matrix3Xd random_lips(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> between(-0.2, 0.2);
  Eigen::Matrix3Xd lips(3, count);
  for (int k = 0; k < count; ++k) {
    const double angle = -2 * std::numbers::pi * k / count;
    lips.col(k) << 1 + std::cos(angle) + between(random), 2 + std::sin(angle) + between(random), 3 + between(random);
  }
  return lips;
}

/// Central differences of a function of the lips.
template <typename Function>
Eigen::Matrix3Xd differences(const Eigen::Matrix3Xd& lips, const Function& function) {
  constexpr double kStep = 1e-5;
  Eigen::Matrix3Xd gradient(3, lips.cols());
  for (Eigen::Index k = 0; k < lips.size(); ++k) {
    Eigen::Matrix3Xd forth = lips, back = lips;
    forth(k) += kStep;
    back(k) -= kStep;
    gradient(k) = (function(forth) - function(back)) / (2 * kStep);
  }
  return gradient;
}

TEST(LipCap, OfAPolygonHasItsAreaAndTheConeToTheOrigin) {
  Eigen::Matrix3Xd lips(3, 4);
  // Clockwise seen from above, as the rim of a wall below it runs.
  lips << 0, 0, 2, 2, 0, 3, 3, 0, 5, 5, 5, 5;
  const LipCap cap = lip_cap_of(lips);
  EXPECT_LT((cap.area - Eigen::Vector3d(0, 0, 6)).norm(), 1e-14);
  EXPECT_NEAR(cap.volume, 6 * 5 / 3.0, 1e-13);
  EXPECT_LT((cap.center - Eigen::Vector3d(1, 1.5, 5)).norm(), 1e-14);
}

TEST(LipCap, OfASlitWhoseLipsLieOnEachOtherHasNoArea) {
  Eigen::Matrix3Xd lips(3, 6);
  lips << 0, 1, 2, 3, 2, 1, 0, 0.2, 0.1, 0, 0.1, 0.2, 0, 0, 0.5, 0, 0.5, 0;
  const LipCap cap = lip_cap_of(lips);
  EXPECT_LT(cap.area.norm(), 1e-15);
  EXPECT_LT(open_area_gradient(lips, Eigen::Vector3d::Zero()).norm(), 1e-15);
}

TEST(LipCap, DerivativesAgreeWithDifferences) {
  const Eigen::Matrix3Xd lips = random_lips(9);
  const LipCap cap = lip_cap_of(lips);
  const auto volume = differences(lips, [](const auto& moved) { return lip_cap_of(moved).volume; });
  EXPECT_LT((cap.volume_gradient - volume).norm(), 1e-9);
  const auto area = differences(lips, [](const auto& moved) { return lip_cap_of(moved).area.norm(); });
  EXPECT_LT((open_area_gradient(lips, cap.area) - area).norm(), 1e-9);
  const LipMoment moment = lip_moment_of(lips);
  for (int axis = 0; axis < 3; ++axis) {
    const auto change = differences(lips, [&](const auto& moved) { return lip_moment_of(moved).value[axis]; });
    EXPECT_LT((moment.gradient[axis] - change).norm(), 1e-8);
  }
}

TEST(LipCap, LoadOfAnEvenPressureIsPressureTimesArea) {
  const Eigen::Matrix3Xd lips = random_lips(7);
  const Eigen::Matrix3Xd load = lip_load_of(lips, {.at_origin = 40});
  EXPECT_LT((load.rowwise().sum() - 40 * lip_cap_of(lips).area).norm(), 1e-12);
}

/// A cone of three triangles around a tip, open below, as a wall whose rim is corners 1, 2, 3.
struct OpenCone {
  std::array<Eigen::Vector3d, 4> vertices = {Eigen::Vector3d(0.3, 0.2, 1.1), Eigen::Vector3d(1.2, -0.1, 0.1),
                                             Eigen::Vector3d(-0.5, 0.9, -0.1), Eigen::Vector3d(-0.4, -1.0, 0.2)};
  static constexpr int kTriangles[3][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  static constexpr int kRim[3] = {1, 2, 3};

  std::array<Eigen::Vector3d, 3> corners(int t) const {
    return {vertices[kTriangles[t][0]], vertices[kTriangles[t][1]], vertices[kTriangles[t][2]]};
  }
  Eigen::Matrix3Xd lips() const {
    Eigen::Matrix3Xd lips(3, 3);
    for (int k = 0; k < 3; ++k) lips.col(k) = vertices[kRim[k]];
    return lips;
  }
  Eigen::VectorXd load(const PressureField& field) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(12);
    for (int t = 0; t < 3; ++t) {
      const auto part = pressure_load_of(corners(t), field);
      for (int k = 0; k < 3; ++k) sum.segment<3>(3 * kTriangles[t][k]) += part.segment<3>(3 * k);
    }
    return sum;
  }
};

TEST(PressureLoad, OnWallAndCapIsTheGradientOfTheVolume) {
  const OpenCone cone;
  Eigen::VectorXd volume = Eigen::VectorXd::Zero(12);
  for (int t = 0; t < 3; ++t) {
    const auto part = volume_gradient_of(cone.corners(t));
    for (int k = 0; k < 3; ++k) volume.segment<3>(3 * OpenCone::kTriangles[t][k]) += part.segment<3>(3 * k);
  }
  const Eigen::Matrix3Xd lip = lip_cap_of(cone.lips()).volume_gradient - lip_load_of(cone.lips(), {.at_origin = 1});
  for (int k = 0; k < 3; ++k) volume.segment<3>(3 * OpenCone::kRim[k]) += lip.col(k);
  EXPECT_LT((volume - cone.load({.at_origin = 1})).norm(), 1e-14);
}

/// The derivative by differences is the symmetric part of all triangles, and the skew-symmetric one of the rim alone.
void expect_tangent(const PressureField& field) {
  const OpenCone cone;
  Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(12, 12);
  for (int t = 0; t < 3; ++t) {
    const auto part = PressedTriangle(cone.corners(t), field).symmetric_tangent();
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        tangent.block<3, 3>(3 * OpenCone::kTriangles[t][a], 3 * OpenCone::kTriangles[t][b]) +=
            part.block<3, 3>(3 * a, 3 * b);
      }
    }
  }
  Eigen::MatrixXd skew = Eigen::MatrixXd::Zero(12, 12);
  for (int column = 0; column < 12; ++column) {
    constexpr double kStep = 1e-6;
    OpenCone forth = cone, back = cone;
    forth.vertices[column / 3][column % 3] += kStep;
    back.vertices[column / 3][column % 3] -= kStep;
    const Eigen::VectorXd change = (forth.load(field) - back.load(field)) / (2 * kStep);
    std::array<Eigen::Vector3d, 4> motion;
    motion.fill(Eigen::Vector3d::Zero());
    motion[column / 3][column % 3] = 1;
    for (int k = 0; k < 3; ++k) {
      const int first = OpenCone::kRim[k], second = OpenCone::kRim[(k + 1) % 3];
      const auto ends =
          rim_load_change({cone.vertices[first], cone.vertices[second]}, {motion[first], motion[second]}, field);
      skew.block<3, 1>(3 * first, column) += ends[0];
      skew.block<3, 1>(3 * second, column) += ends[1];
    }
    EXPECT_LT((tangent.col(column) + skew.col(column) - change).norm(), 1e-9);
  }
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-14);
  EXPECT_LT((skew + skew.transpose()).norm(), 1e-14);
  EXPECT_GT(skew.norm(), 0.1);
}

TEST(PressureLoad, TangentIsASymmetricPartAndOneOnTheRim) {
  expect_tangent({.at_origin = 2, .slope = {0.7, -1.1, 0.4}});
  // A free surface through all three triangles, and through two with corners of the rim above it.
  expect_tangent({.at_origin = 1.4, .slope = {0, 0, -2}, .suction = false});
  expect_tangent({.at_origin = 0.2, .slope = {0.9, 0.3, -1}, .suction = false});
}

TEST(PressureLoad, OfTheThreeMomentsIsThatOfEvenFieldsAlongTheAxes) {
  const std::array<Eigen::Vector3d, 3> corners = OpenCone().corners(1);
  const Eigen::Matrix<double, 9, 3> loads = moment_loads_of(corners);
  for (int axis = 0; axis < 3; ++axis) {
    const auto one = pressure_load_of(corners, {.slope = Eigen::Vector3d::Unit(axis)});
    EXPECT_LT((loads.col(axis) - one).norm(), 1e-16);
  }
  EXPECT_GT(loads.norm(), 0.1);
}

TEST(PressureLoad, UnderAFreeSurfaceIsTheWeightOfWhatIsBelowIt) {
  // A cube of side 2, filled up to a height of 0.7: twelve triangles, four of them cut by the surface.
  std::vector<std::array<Eigen::Vector3d, 3>> cube;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {0.0, 2.0}) {
      std::array<Eigen::Vector3d, 4> corners;
      for (int k = 0; k < 4; ++k) {
        const int turned = side > 0 ? k : 3 - k;
        corners[k][axis] = side;
        corners[k][(axis + 1) % 3] = turned == 1 || turned == 2 ? 2 : 0;
        corners[k][(axis + 2) % 3] = turned > 1 ? 2 : 0;
      }
      cube.push_back({corners[0], corners[1], corners[2]});
      cube.push_back({corners[0], corners[2], corners[3]});
    }
  }
  const double weight = 5, height = 0.7;
  const PressureField field{.at_origin = weight * height, .slope = {0, 0, -weight}, .suction = false};
  Eigen::Vector3d load = Eigen::Vector3d::Zero(), unit = load, squared = load;
  for (const auto& corners : cube) {
    const PressedTriangle pressed(corners, field);
    const auto part = pressed.load(), one = pressed.unit_load();
    for (int k = 0; k < 3; ++k) load += part.segment<3>(3 * k), unit += one.segment<3>(3 * k);
    squared += pressed.squared_load();
  }
  EXPECT_LT((load - Eigen::Vector3d(0, 0, -weight * 4 * height)).norm(), 1e-13);
  EXPECT_LT((unit - Eigen::Vector3d(0, 0, -4)).norm(), 1e-13);  // the area of the surface
  EXPECT_NEAR(squared.z(), -weight * (weight * 4 * height * height / 2), 1e-12);
}

}  // namespace
}  // namespace thinwall

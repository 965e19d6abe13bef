#pragma once

#include <array>
#include <cmath>

namespace thinwall {

/// A point or direction of the picture's geometry.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

template <typename Number>
Vector3 vector3(const std::array<Number, 3>& values) {
  return {values[0], values[1], values[2]};
}

inline Vector3 operator+(Vector3 a, Vector3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(Vector3 a, Vector3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator-(Vector3 a) {
  return {-a.x, -a.y, -a.z};
}
inline Vector3 operator*(double factor, Vector3 a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
inline double dot(Vector3 a, Vector3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vector3 a) {
  return std::sqrt(dot(a, a));
}

/// Of length one; `otherwise` where `a` has no direction.
inline Vector3 normalized(Vector3 a, Vector3 otherwise = {0, 0, 1}) {
  const double size = length(a);
  return size > 0 ? (1 / size) * a : otherwise;
}

/// Any direction of length one perpendicular to `direction`, which has length one.
inline Vector3 perpendicular(Vector3 direction) {
  const Vector3 other = std::abs(direction.z) < 0.9 ? Vector3{0, 0, 1} : Vector3{1, 0, 0};
  return normalized(cross(direction, other));
}

/// By `angle` (radians) about `axis`, which has length one (Rodrigues).
inline Vector3 turned(Vector3 offset, Vector3 axis, double angle) {
  const Vector3 along = dot(offset, axis) * axis, across = offset - along;
  return along + std::cos(angle) * across + std::sin(angle) * cross(axis, across);
}

/// (4 x 4), column by column as OpenGL wants it.
struct Matrix4 {
  std::array<double, 16> values{};
  double& operator()(int row, int column) { return values[static_cast<std::size_t>(4 * column + row)]; }
  double operator()(int row, int column) const { return values[static_cast<std::size_t>(4 * column + row)]; }
};

inline Matrix4 operator*(const Matrix4& a, const Matrix4& b) {
  Matrix4 product;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      for (int k = 0; k < 4; ++k) product(row, column) += a(row, k) * b(k, column);
    }
  }
  return product;
}

/// World to eye: `right`, `up` and `backward` are perpendicular and of length one, and become x, y and z.
inline Matrix4 eye_matrix(Vector3 position, Vector3 right, Vector3 up, Vector3 backward) {
  const Vector3 rows[3] = {right, up, backward};
  Matrix4 matrix;
  for (int row = 0; row < 3; ++row) {
    matrix(row, 0) = rows[row].x;
    matrix(row, 1) = rows[row].y;
    matrix(row, 2) = rows[row].z;
    matrix(row, 3) = -dot(rows[row], position);
  }
  matrix(3, 3) = 1;
  return matrix;
}

/// Eye to clip coordinates of a pinhole camera that looks along -z.
inline Matrix4 perspective_matrix(double tangent_x, double tangent_y, double nearest, double farthest) {
  Matrix4 matrix;
  matrix(0, 0) = 1 / tangent_x;
  matrix(1, 1) = 1 / tangent_y;
  matrix(2, 2) = -(farthest + nearest) / (farthest - nearest);
  matrix(2, 3) = -2 * farthest * nearest / (farthest - nearest);
  matrix(3, 2) = -1;
  return matrix;
}

/// Eye to clip coordinates of parallel rays along -z: a box of half widths `half`, from `nearest` to `farthest`.
inline Matrix4 parallel_matrix(double half, double nearest, double farthest) {
  Matrix4 matrix;
  matrix(0, 0) = 1 / half;
  matrix(1, 1) = 1 / half;
  matrix(2, 2) = -2 / (farthest - nearest);
  matrix(2, 3) = -(farthest + nearest) / (farthest - nearest);
  matrix(3, 3) = 1;
  return matrix;
}

}  // namespace thinwall

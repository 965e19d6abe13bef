#include "renderer/metric/ColorSpace.hpp"

#include <cmath>

namespace thinwall {
namespace {

ColorMatrix inverse(const ColorMatrix& m) {
  ColorMatrix result{};
  const auto cofactor = [&](std::size_t row, std::size_t column) {
    const std::size_t r0 = (row + 1) % 3;
    const std::size_t r1 = (row + 2) % 3;
    const std::size_t c0 = (column + 1) % 3;
    const std::size_t c1 = (column + 2) % 3;
    return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) result[row][column] = cofactor(column, row) / determinant;
  }
  return result;
}

std::array<double, 3> product(const ColorMatrix& m, const std::array<double, 3>& v) {
  std::array<double, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  return result;
}

/// XYZ of a chromaticity at Y = 1.
std::array<double, 3> of_chromaticity(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}

/// Columns are the primaries, scaled so that their sum is the white point.
ColorMatrix make_rgb_to_xyz() {
  const std::array primaries = {of_chromaticity(0.64, 0.33), of_chromaticity(0.30, 0.60), of_chromaticity(0.15, 0.06)};
  ColorMatrix matrix{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) matrix[row][column] = primaries[column][row];
  }
  const std::array<double, 3> scale = product(inverse(matrix), of_chromaticity(0.3127, 0.3290));
  for (auto& row : matrix) {
    for (std::size_t column = 0; column < 3; ++column) row[column] *= scale[column];
  }
  return matrix;
}

double lab_curve(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

const ColorMatrix& rgb_to_xyz() {
  static const ColorMatrix matrix = make_rgb_to_xyz();
  return matrix;
}

const ColorMatrix& xyz_to_rgb() {
  static const ColorMatrix matrix = inverse(rgb_to_xyz());
  return matrix;
}

const std::array<double, 3>& white_xyz() {
  static const std::array<double, 3> white = product(rgb_to_xyz(), {1, 1, 1});
  return white;
}

const std::array<float, 256>& linear_levels() {
  static const std::array<float, 256> levels = [] {
    std::array<float, 256> table{};
    for (std::size_t level = 0; level < table.size(); ++level) {
      const double c = static_cast<double>(level) / 255;
      table[level] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return table;
  }();
  return levels;
}

std::array<double, 3> lab_of_linear(const std::array<double, 3>& rgb) {
  const std::array<double, 3> xyz = product(rgb_to_xyz(), rgb);
  const double x = lab_curve(xyz[0] / white_xyz()[0]);
  const double y = lab_curve(xyz[1] / white_xyz()[1]);
  const double z = lab_curve(xyz[2] / white_xyz()[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace thinwall

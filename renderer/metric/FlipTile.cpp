#include "renderer/metric/FlipTile.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/metric/ColorSpace.hpp"
#include "renderer/metric/Lanes.hpp"
#include "renderer/metric/SeparableFilter.hpp"

namespace thinwall {
namespace {

using lanes::Lanes;

/// Linear sRGB to Y, X - Y, Y - Z relative to white: the linear opponent colours of the paper but for their scales.
struct OpponentMatrix {
  float rows[3][3];
};

OpponentMatrix opponent_matrix() {
  OpponentMatrix result{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = rgb_to_xyz()[0][c] / white_xyz()[0];
    const double y = rgb_to_xyz()[1][c] / white_xyz()[1];
    const double z = rgb_to_xyz()[2][c] / white_xyz()[2];
    result.rows[0][c] = static_cast<float>(y);
    result.rows[1][c] = static_cast<float>(x - y);
    result.rows[2][c] = static_cast<float>(y - z);
  }
  return result;
}

/// Back to linear sRGB, and from there to X, Y, Z relative to white.
struct LabMatrices {
  float opponent_to_rgb[3][3];
  float rgb_to_relative[3][3];
};

LabMatrices lab_matrices() {
  LabMatrices result{};
  for (std::size_t row = 0; row < 3; ++row) {
    const double x = xyz_to_rgb()[row][0] * white_xyz()[0];
    const double y = xyz_to_rgb()[row][1] * white_xyz()[1];
    const double z = xyz_to_rgb()[row][2] * white_xyz()[2];
    // X = Y + (X - Y), Z = Y - (Y - Z)
    result.opponent_to_rgb[row][0] = static_cast<float>(x + y + z);
    result.opponent_to_rgb[row][1] = static_cast<float>(x);
    result.opponent_to_rgb[row][2] = static_cast<float>(-z);
    for (std::size_t c = 0; c < 3; ++c) {
      result.rgb_to_relative[row][c] = static_cast<float>(rgb_to_xyz()[row][c] / white_xyz()[row]);
    }
  }
  return result;
}

THINWALL_FOR_ALL_PROCESSORS
void to_opponent(const float* red, const float* green, const float* blue, int count, const OpponentMatrix& matrix,
                 float* const to[3]) {
  for (int x = 0; x < count; x += lanes::kCount) {
    Lanes r;
    Lanes g;
    Lanes b;
    lanes::load(r, red + x);
    lanes::load(g, green + x);
    lanes::load(b, blue + x);
    for (int plane = 0; plane < 3; ++plane) {
      const Lanes value = matrix.rows[plane][0] * r + matrix.rows[plane][1] * g + matrix.rows[plane][2] * b;
      lanes::store(value, to[plane] + x);
    }
  }
}

/// Filtered opponent colours to L, a, b with Hunt's adjustment: colours of dark places count less.
THINWALL_FOR_ALL_PROCESSORS
void to_adjusted_lab(const float* const opponent[3], int count, const LabMatrices& matrices, float* const to[3]) {
  const Lanes zero = {};
  const Lanes one = zero + 1.0F;
  for (int i = 0; i < count; i += lanes::kCount) {
    Lanes in[3];
    for (int plane = 0; plane < 3; ++plane) lanes::load(in[plane], opponent[plane] + i);
    Lanes rgb[3];
    for (int c = 0; c < 3; ++c) {
      const float(&row)[3] = matrices.opponent_to_rgb[c];
      const Lanes value = row[0] * in[0] + row[1] * in[1] + row[2] * in[2];
      const Lanes positive = value < zero ? zero : value;
      rgb[c] = positive > one ? one : positive;
    }
    Lanes f[3];
    for (int c = 0; c < 3; ++c) {
      const float(&row)[3] = matrices.rgb_to_relative[c];
      const Lanes t = row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2];
      Lanes root = t < 1e-4F ? zero + 1e-4F : t;
      lanes::cube_root(root);
      // (6/29)^3, and the straight line below it.
      f[c] = t > 0.008856451679F ? root : t * 7.787037037F + 0.1379310345F;
    }
    const Lanes lightness = 116.0F * f[1] - 16.0F;
    const Lanes hunt = 0.01F * lightness;
    lanes::store(lightness, to[0] + i);
    lanes::store(hunt * (500.0F * (f[0] - f[1])), to[1] + i);
    lanes::store(hunt * (200.0F * (f[1] - f[2])), to[2] + i);
  }
}

THINWALL_FOR_ALL_PROCESSORS
void lengths(const float* x, const float* y, int count, float* to) {
  for (int i = 0; i < count; ++i) to[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

// Section 4.1.3 of the paper: colour errors up to kKnee of the largest take kKneeError of the range.
constexpr double kColorExponent = 0.7;
constexpr double kKnee = 0.4;
constexpr double kKneeError = 0.95;

/// The largest colour error: between pure green and pure blue.
double largest_color_error() {
  const auto adjusted = [](const std::array<double, 3>& rgb) {
    std::array<double, 3> lab = lab_of_linear(rgb);
    lab[1] *= 0.01 * lab[0];
    lab[2] *= 0.01 * lab[0];
    return lab;
  };
  const std::array<double, 3> green = adjusted({0, 1, 0});
  const std::array<double, 3> blue = adjusted({0, 0, 1});
  const double distance = std::abs(green[0] - blue[0]) + std::hypot(green[1] - blue[1], green[2] - blue[2]);
  return std::pow(distance, kColorExponent);
}

THINWALL_FOR_ALL_PROCESSORS
void combine(const FlipWorkspace& w, int count, float largest, float* errors) {
  const Lanes zero = {};
  const auto knee = static_cast<float>(kKnee) * largest;
  const auto knee_error = static_cast<float>(kKneeError);
  for (int i = 0; i < count; i += lanes::kCount) {
    Lanes difference[3];
    for (int c = 0; c < 3; ++c) {
      Lanes reference;
      Lanes test;
      lanes::load(reference, &w.color[0][c][static_cast<std::size_t>(i)]);
      lanes::load(test, &w.color[1][c][static_cast<std::size_t>(i)]);
      difference[c] = reference - test;
    }
    const Lanes chroma_square = difference[1] * difference[1] + difference[2] * difference[2];
    float chroma[lanes::kCount];
    lanes::store(chroma_square, chroma);
    for (float& value : chroma) value = std::sqrt(value);
    Lanes color;
    lanes::load(color, chroma);
    color += difference[0] < zero ? -difference[0] : difference[0];
    lanes::power(color, zero + static_cast<float>(kColorExponent));
    const Lanes below = color * (knee_error / knee);
    const Lanes above = knee_error + (color - knee) * ((1 - knee_error) / (largest - knee));
    color = color < knee ? below : above;
    float exponent[lanes::kCount];
    for (int lane = 0; lane < lanes::kCount; ++lane) {
      const auto at = static_cast<std::size_t>(i + lane);
      const float feature =
          std::max(std::abs(w.edges[0][at] - w.edges[1][at]), std::abs(w.points[0][at] - w.points[1][at]));
      exponent[lane] = 1 - std::sqrt(std::min(feature * 0.7071067811865476F, 1.0F));
    }
    Lanes weight;
    lanes::load(weight, exponent);
    lanes::power(color, weight);
    lanes::store(color, errors + i);
  }
}

/// One picture's part of a tile.
class TilePicture {
 public:
  TilePicture(const FlipKernels& kernels, FlipWorkspace& workspace, int rows)
      : kernels_(kernels),
        workspace_(workspace),
        rows_(rows),
        all_rows_(rows + 2 * kernels.margin),
        pitch_((kFlipTile + 2 * kernels.margin + lanes::kCount - 1) / lanes::kCount * lanes::kCount) {
    const auto size_for = [](std::vector<float>& values, int height, int width) {
      values.resize(static_cast<std::size_t>(height) * static_cast<std::size_t>(width));
    };
    size_for(workspace.row, 3, pitch_);
    for (auto& plane : workspace.opponent) size_for(plane, all_rows_, pitch_);
    for (auto& plane : workspace.passed) size_for(plane, all_rows_, kFlipTile);
    for (auto& plane : workspace.filtered) size_for(plane, rows, kFlipTile);
    for (int picture = 0; picture < 2; ++picture) {
      for (auto& plane : workspace.color[picture]) size_for(plane, rows, kFlipTile);
      size_for(workspace.edges[picture], rows, kFlipTile);
      size_for(workspace.points[picture], rows, kFlipTile);
    }
  }

  /// Opponent colours of the tile and its margins.
  void read(const LinearRow& picture, ImageSize size, const PixelRegion& region) {
    const int left = region.left - kernels_.margin;
    const int width = kFlipTile + 2 * kernels_.margin;
    const int first = std::clamp(left, 0, size.width - 1);
    const int last = std::clamp(left + width - 1, 0, size.width - 1);
    static const OpponentMatrix matrix = opponent_matrix();
    for (int row = 0; row < all_rows_; ++row) {
      const int y = std::clamp(region.top - kernels_.margin + row, 0, size.height - 1);
      // Beyond the picture's border a row is the row before it.
      if (row > 0 && y == std::clamp(region.top - kernels_.margin + row - 1, 0, size.height - 1)) {
        repeat_row(row);
        continue;
      }
      const int count = last - first + 1;
      float* line = workspace_.row.data();
      // The picture gives its planes one after the other; each is spread to its own place, the last one first.
      picture(y, first, count, line);
      for (int channel = 2; channel >= 0; --channel)
        spread(line + channel * count, line + channel * pitch_, first - left, count);
      float* const to[3] = {row_of(0, row), row_of(1, row), row_of(2, row)};
      to_opponent(line, line + pitch_, line + 2 * pitch_, pitch_, matrix, to);
    }
  }

  void filter_colors(int picture) {
    both_ways(0, kernels_.achromatic, kernels_.achromatic, 0);
    both_ways(1, kernels_.red_green, kernels_.red_green, 1);
    both_ways(2, kernels_.blue_yellow, kernels_.blue_yellow, 2);
    both_ways(2, kernels_.blue_yellow_narrow, kernels_.blue_yellow_narrow, 3);
    std::vector<float>& wide = workspace_.filtered[2];
    const std::vector<float>& narrow = workspace_.filtered[3];
    for (std::size_t i = 0; i < wide.size(); ++i) wide[i] += narrow[i];
    static const LabMatrices matrices = lab_matrices();
    const float* const from[3] = {workspace_.filtered[0].data(), workspace_.filtered[1].data(), wide.data()};
    auto& color = workspace_.color[picture];
    float* const to[3] = {color[0].data(), color[1].data(), color[2].data()};
    to_adjusted_lab(from, rows_ * kFlipTile, matrices, to);
  }

  void find_features(int picture) {
    along_rows(0, kernels_.smooth, 0);
    along_rows(0, kernels_.edge, 1);
    along_rows(0, kernels_.point, 2);
    down_columns(1, kernels_.smooth, 0);
    down_columns(0, kernels_.edge, 1);
    down_columns(2, kernels_.smooth, 2);
    down_columns(0, kernels_.point, 3);
    const int count = rows_ * kFlipTile;
    lengths(workspace_.filtered[0].data(), workspace_.filtered[1].data(), count, workspace_.edges[picture].data());
    lengths(workspace_.filtered[2].data(), workspace_.filtered[3].data(), count, workspace_.points[picture].data());
  }

 private:
  float* row_of(int plane, int row) {
    return workspace_.opponent[plane].data() + static_cast<std::ptrdiff_t>(row) * pitch_;
  }

  void repeat_row(int row) {
    for (int plane = 0; plane < 3; ++plane) {
      std::copy_n(row_of(plane, row - 1), pitch_, row_of(plane, row));
    }
  }

  /// Moves `count` values to `offset`, and repeats the outermost ones up to both ends.
  void spread(float* from, float* to, int offset, int count) const {
    std::copy_backward(from, from + count, to + offset + count);
    std::fill(to, to + offset, to[offset]);
    std::fill(to + offset + count, to + pitch_, to[offset + count - 1]);
  }

  void along_rows(int plane, const Kernel& kernel, int result) {
    filter({.from = workspace_.opponent[plane].data() + kernels_.margin,
            .pitch = pitch_,
            .stride = 1,
            .to = workspace_.passed[result].data(),
            .width = kFlipTile,
            .rows = all_rows_},
           kernel);
  }

  void down_columns(int passed, const Kernel& kernel, int result) {
    filter({.from = workspace_.passed[passed].data() + static_cast<std::ptrdiff_t>(kernels_.margin) * kFlipTile,
            .pitch = kFlipTile,
            .stride = kFlipTile,
            .to = workspace_.filtered[result].data(),
            .width = kFlipTile,
            .rows = rows_},
           kernel);
  }

  void both_ways(int plane, const Kernel& rows, const Kernel& columns, int result) {
    along_rows(plane, rows, 0);
    down_columns(0, columns, result);
  }

  const FlipKernels& kernels_;
  FlipWorkspace& workspace_;
  int rows_;
  int all_rows_;  // with margins
  int pitch_;
};

}  // namespace

void flip_tile(const LinearRow& reference, const LinearRow& test, ImageSize size, const PixelRegion& region,
               const FlipKernels& kernels, FlipWorkspace& workspace, std::vector<float>& errors) {
  TilePicture tile(kernels, workspace, region.height());
  int picture = 0;
  for (const LinearRow* row : {&reference, &test}) {
    tile.read(*row, size, region);
    tile.filter_colors(picture);
    tile.find_features(picture);
    ++picture;
  }
  static const double largest = largest_color_error();
  workspace.filtered[0].resize(static_cast<std::size_t>(region.height()) * kFlipTile);
  combine(workspace, region.height() * kFlipTile, static_cast<float>(largest), workspace.filtered[0].data());
  errors.clear();
  for (int y = 0; y < region.height(); ++y) {
    const float* row = workspace.filtered[0].data() + static_cast<std::ptrdiff_t>(y) * kFlipTile;
    errors.insert(errors.end(), row, row + region.width());
  }
}

}  // namespace thinwall

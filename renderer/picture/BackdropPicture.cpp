#include "renderer/picture/BackdropPicture.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace thinwall {
namespace {

constexpr int kDitherRows = 64;

/// Levels are held as whole numbers of 16 bits with seven bits behind the point, parts with fifteen.
constexpr int kLevel = 1 << 7;
constexpr int kWholePart = 1 << 15;

/// Interleaved gradient noise (Jimenez 2014), as in shaders/tone.glsl, -0.5 to 0.5.
std::int16_t dither_at(int column, int row) {
  const double inner = 0.06711056 * (column + 0.5) + 0.00583715 * (row + 0.5);
  const double outer = 52.9829189 * (inner - std::floor(inner));
  return static_cast<std::int16_t>(std::lround(kLevel * (outer - std::floor(outer) - 0.5)));
}

/// `top` to `bottom` by `part`, with noise, rounded to levels.
void blend_rows(const std::int16_t* __restrict top, const std::int16_t* __restrict bottom, std::int16_t part,
                const std::int16_t* __restrict dither, std::uint8_t* __restrict to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto difference = static_cast<std::int16_t>(bottom[i] - top[i]);
    const auto half_step = static_cast<std::int16_t>((static_cast<int>(difference) * part) >> 16);
    auto level = static_cast<std::int16_t>(top[i] + 2 * half_step + dither[i] + kLevel / 2);
    level = static_cast<std::int16_t>(level >> 7);
    level = std::max(level, std::int16_t{0});
    level = std::min(level, std::int16_t{255});
    to[i] = static_cast<std::uint8_t>(level);
  }
}

/// Part of the light that a field stop of radius 1 lets through at `radius`, as field_stop of shaders/tone.glsl.
constexpr double kWholeRadius = 0.985;
double let_through(double radius) {
  const double t = std::clamp((radius - kWholeRadius) / (1 - kWholeRadius), 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

}  // namespace

ScreenArea area_within(const FieldStop& stop, ImageSize size) {
  if (!(stop.tangent > 0)) return {0, 0, size.width, size.height};
  const auto side = [&](std::size_t axis, int count) -> std::array<int, 2> {
    const double half = 0.5 * count * std::min(stop.tangent / stop.half_field[axis], 1.0) + 2;
    const int first = std::max(static_cast<int>(std::floor(0.5 * count - half)), 0);
    return {first, std::min(static_cast<int>(std::ceil(0.5 * count + half)), count) - first};
  };
  const auto [left, width] = side(0, size.width);
  const auto [bottom, height] = side(1, size.height);
  return {left, bottom, width, height};
}

std::vector<BackdropPicture::Place> BackdropPicture::places(int small, int size) {
  std::vector<Place> places;
  for (int i = 0; i < size; ++i) {
    const double place = std::clamp((i + 0.5) * small / size - 0.5, 0.0, small - 1.0);
    const int first = static_cast<int>(place);
    const auto part = static_cast<std::int16_t>(std::min(std::lround(kWholePart * (place - first)), kWholePart - 1L));
    places.push_back({first, std::min(first + 1, small - 1), part});
  }
  return places;
}

BackdropPicture::BackdropPicture(ImageSize small, ImageSize size)
    : small_(small), size_(size), columns_(places(small.width, size.width)), rows_(places(small.height, size.height)) {
  for (int row = 0; row < kDitherRows; ++row) {
    for (int column = 0; column < size.width; ++column) {
      dither_.insert(dither_.end(), 3, dither_at(column, row));
      dither_.push_back(0);
    }
  }
  const std::size_t width = 4 * static_cast<std::size_t>(size.width);
  for (std::vector<std::int16_t>& row : wide_) row.resize(width);
  pixels_.resize(width * static_cast<std::size_t>(size.height));
}

void BackdropPicture::widen(const std::uint8_t* row, std::vector<std::int16_t>& wide) const {
  std::int16_t* to = wide.data();
  for (const Place& column : columns_) {
    const std::uint8_t* first = row + 4 * column.first;
    const std::uint8_t* second = row + 4 * column.second;
    for (int channel = 0; channel < 3; ++channel) {
      const int step = (second[channel] - first[channel]) * column.part / (kWholePart / kLevel);
      to[channel] = static_cast<std::int16_t>(kLevel * first[channel] + step);
    }
    to[3] = 255 * kLevel;
    to += 4;
  }
}

void BackdropPicture::find_changes(std::span<const std::uint8_t> small, const FieldStop& stop) {
  const bool is_comparable = enlarged_.size() == small.size() && stop == kept_stop_;
  const std::size_t width = 4 * static_cast<std::size_t>(small_.width);
  has_changed_.resize(static_cast<std::size_t>(small_.height));
  for (std::size_t row = 0; row < has_changed_.size(); ++row) {
    has_changed_[row] = !is_comparable || std::memcmp(&small[row * width], &enlarged_[row * width], width) != 0 ? 1 : 0;
  }
  enlarged_.assign(small.begin(), small.end());
  kept_stop_ = stop;
}

std::span<const std::uint8_t> BackdropPicture::enlarge(std::span<const std::uint8_t> small, const FieldStop& stop) {
  const std::size_t width = 4 * static_cast<std::size_t>(size_.width);
  const std::size_t small_width = 4 * static_cast<std::size_t>(small_.width);
  find_changes(small, stop);
  const auto has_changed = [&](int row) { return has_changed_[static_cast<std::size_t>(row)] != 0; };
  int held = -1;  // the first of the two rows that are held
  for (int row = 0; row < size_.height; ++row) {
    const Place& place = rows_[static_cast<std::size_t>(row)];
    if (!has_changed(place.first) && !has_changed(place.second)) continue;
    if (place.first != held) {
      if (place.first == held + 1 && held >= 0) {
        std::swap(wide_[0], wide_[1]);
      } else {
        widen(small.data() + small_width * static_cast<std::size_t>(place.first), wide_[0]);
      }
      widen(small.data() + small_width * static_cast<std::size_t>(place.second), wide_[1]);
      held = place.first;
    }
    blend_rows(wide_[0].data(), wide_[1].data(), place.part,
               dither_.data() + width * static_cast<std::size_t>(row % kDitherRows),
               pixels_.data() + width * static_cast<std::size_t>(row), width);
    if (stop.tangent > 0) stop_down(row, stop);
  }
  return pixels_;
}

void BackdropPicture::stop_down(int row, const FieldStop& stop) {
  const double across = 2 * stop.half_field[0] / size_.width / stop.tangent;
  const double y = ((row + 0.5) * 2 / size_.height - 1) * stop.half_field[1] / stop.tangent;
  std::uint8_t* pixels = pixels_.data() + 4 * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(row);
  // How many pixels on either side of the row's middle are within a radius.
  const double middle = 0.5 * size_.width;
  const auto within = [&](double radius) { return std::sqrt(std::max(radius * radius - y * y, 0.0)) / across; };
  const auto shade = [&](int from, int to) {
    for (int column = std::max(from, 0); column < std::min(to, size_.width); ++column) {
      const double part = let_through(std::hypot((column + 0.5 - middle) * across, y));
      for (int channel = 0; channel < 3; ++channel) {
        std::uint8_t& level = pixels[4 * column + channel];
        level = static_cast<std::uint8_t>(std::lround(part * level));
      }
    }
  };
  const auto blacken = [&](int from, int to) {
    constexpr std::array<std::uint8_t, 4> kBlack{0, 0, 0, 255};
    for (int column = std::max(from, 0); column < std::min(to, size_.width); ++column) {
      std::copy(kBlack.begin(), kBlack.end(), pixels + 4 * column);
    }
  };
  const double lit = std::min(within(1), middle) + 1, whole = std::min(within(kWholeRadius), middle);
  const int first_lit = static_cast<int>(middle - lit), last_lit = static_cast<int>(std::ceil(middle + lit));
  blacken(0, first_lit);
  shade(first_lit, static_cast<int>(std::ceil(middle - whole)));
  shade(std::max(static_cast<int>(middle + whole), static_cast<int>(std::ceil(middle - whole))), last_lit);
  blacken(last_lit, size_.width);
}

}  // namespace thinwall

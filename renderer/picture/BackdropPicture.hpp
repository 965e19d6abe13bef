#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/shape/ScreenArea.hpp"

namespace thinwall {

/// Where an endoscope's field stop lies on the rays of a picture's pixels: a circle around the line of sight.
struct FieldStop {
  double tangent = 0;                  // of the angle off the line of sight; 0: there is none
  std::array<double, 2> half_field{};  // tangents at the middle of the right and of the upper border
  bool operator==(const FieldStop&) const = default;
};

/// All pixels of a picture of `size` that show something within the stop, and a border of two.
ScreenArea area_within(const FieldStop& stop, ImageSize size);

/// Enlarges what lies behind a scene from the small picture that it is drawn in, and breaks the bands of its slow
/// gradients by less than one level. Done by the processor: on a driver without a GPU, where it fills most of a
/// picture, it takes a quarter of the time that looking up a texture for each pixel does.
class BackdropPicture {
 public:
  BackdropPicture(ImageSize small, ImageSize size);

  /// `small`: (4 x width x height), RGBA, row by row. The result is as large as the picture, opaque, and black outside
  /// the field stop; it stays valid until the next call. Rows that would be as they were the last time are left as they
  /// are: where camera and lamps stand still, little changes behind a scene.
  std::span<const std::uint8_t> enlarge(std::span<const std::uint8_t> small, const FieldStop& stop);

  /// What enlarge has given last.
  std::span<const std::uint8_t> pixels() const { return pixels_; }

 private:
  void find_changes(std::span<const std::uint8_t> small, const FieldStop& stop);
  void widen(const std::uint8_t* row, std::vector<std::int16_t>& wide) const;
  void stop_down(int row, const FieldStop& stop);

  /// Between two neighbours of the small picture.
  struct Place {
    int first = 0;
    int second = 0;
    std::int16_t part = 0;  // of the second, 2^15 for the whole
  };
  static std::vector<Place> places(int small, int size);

  ImageSize small_;
  ImageSize size_;
  std::vector<Place> columns_;                     // (width)
  std::vector<Place> rows_;                        // (height)
  std::vector<std::int16_t> dither_;               // (kDitherRows x 4 width), like `wide_`
  std::array<std::vector<std::int16_t>, 2> wide_;  // (4 width), rows of the small picture widened, 2^7 for a level
  std::vector<std::uint8_t> pixels_;               // (4 x width x height)
  std::vector<std::uint8_t> enlarged_;             // the small picture that `pixels_` was made of
  FieldStop kept_stop_;                            // and the stop
  std::vector<char> has_changed_;                  // (height of the small picture), since then
};

}  // namespace thinwall

#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "studio/recorder/Painter.hpp"

namespace thinwall {

/// Stands in for the renderer where no GL is wanted: a ground whose brightness tells the first tool's depth and how
/// many others are not set aside, with a pattern so that shifts show; the right half is of the second take where there
/// is one. `gain` makes a renderer that has changed.
class FlatPainter final : public Painter {
 public:
  explicit FlatPainter(ImageSize size, double gain = 1) : size_(size), gain_(gain) {}

  Image paint(const Snapshot& snapshot, const Shot& shot) override {
    const double left = level_of(snapshot);
    const double right = shot.beside_snapshot ? level_of(*shot.beside_snapshot) : left;
    Image image{.size = size_, .pixels = {}};
    for (int y = 0; y < size_.height; ++y) {
      for (int x = 0; x < size_.width; ++x) {
        const double level = 2 * x < size_.width ? left : right;
        const auto shade = static_cast<std::uint8_t>(std::lround(level) + (x / 8 + y / 8) % 2 * 20);
        image.pixels.insert(image.pixels.end(), {shade, static_cast<std::uint8_t>(shade / 2), 40});
      }
    }
    return image;
  }
  std::string driver() const override { return "flat painter 1.0"; }

 private:
  double level_of(const Snapshot& snapshot) const {
    const double depth = snapshot.tools.empty() ? 0 : snapshot.tools.front().depth;
    double others = 0;
    for (std::size_t k = 1; k < snapshot.tools.size(); ++k) others += snapshot.tools[k].is_set_aside ? 0 : 1;
    return gain_ * (60 + 2e4 * depth + 8 * others);
  }

  ImageSize size_;
  double gain_;
};

inline PainterFactory flat_painters(double gain = 1) {
  return [gain](ImageSize size) { return std::make_unique<FlatPainter>(size, gain); };
}

}  // namespace thinwall

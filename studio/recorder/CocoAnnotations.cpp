#include "studio/recorder/CocoAnnotations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace thinwall {
namespace {

struct PixelBounds {
  int left = 0, top = 0, right = -1, bottom = -1;  // pixels, the last ones included
  std::size_t area = 0;                            // pixels
};

std::vector<PixelBounds> boxes_of(ImageSize size, const std::vector<std::uint16_t>& instances, std::size_t count) {
  std::vector<PixelBounds> boxes(count, {.left = size.width, .top = size.height});
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const std::uint16_t instance = instances[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
                                               static_cast<std::size_t>(column)];
      if (instance == 0) continue;
      PixelBounds& box = boxes[instance - 1U];
      box.left = std::min(box.left, column);
      box.right = std::max(box.right, column);
      box.top = std::min(box.top, row);
      box.bottom = std::max(box.bottom, row);
      ++box.area;
    }
  }
  return boxes;
}

std::string list(const std::vector<std::string>& elements) {
  return fmt::format("[\n{}\n]", fmt::join(elements, ",\n"));
}

}  // namespace

std::vector<std::uint32_t> run_lengths(ImageSize size, const std::vector<std::uint16_t>& instances,
                                       std::uint16_t instance) {
  std::vector<std::uint32_t> counts = {0};
  bool inside = false;
  for (std::size_t column = 0; column < static_cast<std::size_t>(size.width); ++column) {
    for (std::size_t row = 0; row < static_cast<std::size_t>(size.height); ++row) {
      const bool is_inside = instances[row * static_cast<std::size_t>(size.width) + column] == instance;
      if (is_inside != inside) counts.push_back(0);
      inside = is_inside;
      ++counts.back();
    }
  }
  return counts;
}

void CocoAnnotations::add(std::size_t frame, ImageSize size, const std::vector<std::uint16_t>& instances,
                          const std::vector<std::uint16_t>& category_of) {
  images_.push_back(fmt::format(R"({{"id": {}, "width": {}, "height": {}, "file_name": "frame_{:06}.png"}})", frame,
                                size.width, size.height, frame));
  const std::vector<PixelBounds> boxes = boxes_of(size, instances, category_of.size());
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const PixelBounds& box = boxes[k];
    if (box.area == 0) continue;
    annotations_.push_back(
        fmt::format(R"({{"id": {}, "image_id": {}, "category_id": {}, "instance": {}, "iscrowd": 0, "area": {}, )"
                    R"("bbox": [{}, {}, {}, {}], "segmentation": {{"size": [{}, {}], "counts": [{}]}}}})",
                    annotations_.size() + 1, frame, category_of[k], k + 1, box.area, box.left, box.top,
                    box.right - box.left + 1, box.bottom - box.top + 1, size.height, size.width,
                    fmt::join(run_lengths(size, instances, static_cast<std::uint16_t>(k + 1)), ", ")));
  }
}

std::string CocoAnnotations::json() const {
  std::vector<std::string> categories;
  for (const CocoCategory& category : categories_) {
    categories.push_back(
        nlohmann::ordered_json{{"id", category.id}, {"name", category.name}, {"supercategory", category.supercategory}}
            .dump());
  }
  return fmt::format("{{\n\"images\": {},\n\"categories\": {},\n\"annotations\": {}\n}}\n", list(images_),
                     list(categories), list(annotations_));
}

}  // namespace thinwall

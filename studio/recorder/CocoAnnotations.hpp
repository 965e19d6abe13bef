#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/image/Image.hpp"

namespace thinwall {

/// A kind of thing, as annotations name it.
struct CocoCategory {
  int id = 0;
  std::string name;
  std::string supercategory;
};

/// The file annotations.json in COCO's format for object detection: for each frame and instance a mask as uncompressed
/// run lengths, its area and its box.
class CocoAnnotations {
 public:
  explicit CocoAnnotations(std::vector<CocoCategory> categories) : categories_(std::move(categories)) {}

  /// `instances`: (height x width), 0 for none; `category_of`: (instances) ids of the categories.
  void add(std::size_t frame, ImageSize size, const std::vector<std::uint16_t>& instances,
           const std::vector<std::uint16_t>& category_of);

  std::string json() const;

 private:
  std::vector<CocoCategory> categories_;
  std::vector<std::string> images_;       // JSON each
  std::vector<std::string> annotations_;  // JSON each
};

/// Run lengths of a mask, columns first, as COCO counts them: of pixels outside, inside, outside, ...
std::vector<std::uint32_t> run_lengths(ImageSize size, const std::vector<std::uint16_t>& instances,
                                       std::uint16_t instance);

}  // namespace thinwall

#pragma once

#include "renderer/image/Image.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/View.hpp"

namespace thinwall {

/// The frame that a picture is drawn to, and the way from there to an Image.
class PictureTarget {
 public:
  /// Throws PictureFailure for sizes that are not positive, beyond the driver's limits, or that need too much memory.
  PictureTarget(ImageSize size, Tier tier);

  /// Makes the frame the one that is drawn to, emptied.
  void begin() const;

  /// Brings the samples together and reads the picture.
  Image finish() const;

  ImageSize size() const { return size_; }
  ImageSize drawn_size() const { return drawn_; }  // larger than size() with Tier::kFinal

 private:
  void resolve() const;

  ImageSize size_;
  ImageSize drawn_;
  int samples_ = 0;
  Renderbuffer color_;
  Renderbuffer depth_;
  Framebuffer frame_;
  Renderbuffer resolved_color_;  // one sample per pixel, drawn size
  Framebuffer resolved_;
  Renderbuffer small_color_;  // one sample per pixel, size
  Framebuffer small_;
};

}  // namespace thinwall

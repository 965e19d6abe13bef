#pragma once

#include <array>
#include <optional>

#include "renderer/image/Image.hpp"
#include "renderer/picture/BackdropPicture.hpp"
#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/View.hpp"

namespace thinwall {

/// The frames that a picture is drawn to, and the way from there to an Image. Two frames share depth and stencil: one
/// takes what is seen of the tissue (normal, rest position, depth), the other the colours.
class PictureTarget {
 public:
  /// Throws PictureFailure for sizes that are not positive, beyond the driver's limits, or that need too much memory.
  PictureTarget(ImageSize size, Tier tier);

  /// Empties depth and stencil and makes the frame of what is seen of the tissue the one that is drawn to.
  void begin_surface() const;

  /// Makes the colours the frame that is drawn to, and binds the other for tissue.frag.
  void begin_color() const;

  /// Makes a picture of a quarter of the size the one that is drawn to, for what lies behind the scene: nothing in it
  /// is sharp.
  void begin_backdrop() const;

  /// Fills the colours with that picture; the rest is drawn over it.
  void lay_backdrop(const FieldStop& stop);

  /// The colours as they are now.
  const Texture& copy_of_color() const;

  /// Makes one of two pictures of half the size the one that is drawn to, and binds depth and, for the first (`turn`
  /// 0), the colours, for the second the first, for FocusPass.
  void begin_blurred(std::size_t turn) const;

  /// Makes the colours the frame that is drawn to, and binds depth and the second picture of half the size.
  void begin_focused() const;

  /// Makes the frame behind the lens the one that is drawn to, and binds the colours for lens.frag. It takes the place
  /// of the copy of the colours.
  void begin_lens() const;

  /// Reads the picture, or the one behind the lens.
  Image finish(bool through_lens = false) const;

  ImageSize size() const { return size_; }
  ImageSize drawn_size() const { return drawn_; }  // larger than size() with Tier::kFinal

 private:
  ImageSize size_;
  ImageSize drawn_;
  Texture depth_;   // and stencil
  Texture normal_;  // and depth
  Texture rest_;    // and state
  Framebuffer surface_;
  Texture backdrop_color_;
  Framebuffer backdrop_;
  std::optional<BackdropPicture> backdrop_picture_;
  Texture color_;
  Texture color_copy_;
  Framebuffer frame_;
  std::array<Texture, 2> blurred_color_;
  std::array<Framebuffer, 2> blurred_;
  Framebuffer color_alone_;  // without depth, which is read then
  Framebuffer lens_;         // draws to color_copy_
  Texture small_color_;
  Framebuffer small_;
};

}  // namespace thinwall

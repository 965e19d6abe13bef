#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/picture/BackdropPicture.hpp"
#include "renderer/picture/FinePixels.hpp"
#include "renderer/picture/GlObjects.hpp"

namespace thinwall {

/// The frames that a picture is drawn to, and the way from there to an Image. Three frames share depth and stencil: one
/// takes what is seen of the tissue, one what is seen of the tools, one the colours.
class PictureTarget {
 public:
  /// Throws PictureFailure for sizes that are not positive, beyond the driver's limits, or that need too much memory.
  explicit PictureTarget(ImageSize size);

  /// Empties depth and stencil.
  void clear_depth() const;

  /// Empties them but for what keep_stop has kept for the same stop; false where there is no such.
  bool clear_depth(const FieldStop& stop) const;

  /// Keeps depth as it is now, with nothing drawn but the field stop: each picture begins with it, and copying is
  /// cheaper than drawing.
  void keep_stop(const FieldStop& stop);

  /// Makes the frame of what is seen of the tissue the one that is drawn to.
  void begin_surface() const;

  /// Makes the frame of what is seen of the tools the one that is drawn to. Of tissue that they hide it leaves what is
  /// seen, for metal mirrors it.
  void begin_tools() const;

  /// Makes the colours the frame that is drawn to, and binds the others for tissue.frag and metal.frag.
  void begin_color() const;

  /// Makes a picture of a quarter of the size the one that is drawn to, for what lies behind the scene: nothing in it
  /// is sharp.
  void begin_backdrop() const;

  ImageSize backdrop_size() const;

  /// Reads that picture, as soon as it is drawn.
  void read_backdrop();

  /// Fills the colours with what was read; the rest is drawn over it.
  void lay_backdrop(const FieldStop& stop);

  /// The picture that lay_backdrop has made: (4 x width x height), as of read_color.
  std::span<const std::uint8_t> backdrop() const { return backdrop_picture_->pixels(); }

  /// Reads the colours within `area`: (4 x area.width x area.height), RGBA, from the lower left corner, row by row.
  /// `pixels` is memory that is used again.
  void read_color(const ScreenArea& area, std::vector<std::uint8_t>& pixels) const;

  /// Puts colours back, as of read_color.
  void write_color(const ScreenArea& area, std::span<const std::uint8_t> pixels) const;

  /// Empties depth and stencil of the corners of fine pixels, and puts all else so near that nothing is drawn there.
  void clear_depth(const FinePixels& fine) const;

  /// Keeps depth as it is now for begin_blurred and begin_focused, whatever is drawn until then.
  void keep_depth();

  /// Keeps depth as it is now for the tools, which mirror what lies there. Outside `tissue` there is nothing but the
  /// field stop.
  void keep_tissue_depth(const ScreenArea& tissue, const FieldStop& stop);

  /// Makes a picture beside the colours the one that is drawn to, with their depth and stencil, and binds the colours,
  /// for OutlinePass.
  void begin_smoothing() const;

  /// Makes the colours the frame that is drawn to, and binds the picture beside them.
  void begin_smoothed() const;

  /// Makes one of two pictures of half the size the one that is drawn to, and binds depth and, for the first (`turn`
  /// 0), the colours, for the second the first, for FocusPass.
  void begin_blurred(std::size_t turn) const;

  /// Makes the colours the frame that is drawn to, and binds depth and the second picture of half the size.
  void begin_focused() const;

  /// Makes the frame behind the lens the one that is drawn to, and binds the colours for lens.frag. It takes the place
  /// of the picture beside the colours.
  void begin_lens() const;

  /// Reads the picture, or the one behind the lens.
  Image finish(bool through_lens = false);

  /// Of a picture that has been read, as of read_color.
  Image finish(std::span<const std::uint8_t> picture) const;

  ImageSize size() const { return size_; }
  ScreenArea whole() const { return {0, 0, size_.width, size_.height}; }

 private:
  void copy_depth(const ScreenArea& area, std::optional<Texture>& to) const;

  ImageSize size_;
  Texture depth_;  // and stencil
  std::optional<Texture> stop_depth_;
  FieldStop kept_stop_;
  std::optional<Texture> kept_depth_;
  std::optional<Texture> tissue_depth_;  // without tools
  ScreenArea kept_tissue_;               // what of it is more than this
  FieldStop tissue_stop_;                // and this
  Texture tissue_;                       // see shaders/seen.glsl
  Framebuffer surface_;
  Texture tool_place_;
  Texture tool_normal_;
  Texture tool_axis_;
  Framebuffer tools_;
  Texture backdrop_color_;
  Framebuffer backdrop_;
  std::optional<BackdropPicture> backdrop_picture_;
  Texture color_;
  Texture beside_color_;
  Framebuffer frame_;
  Framebuffer smoothing_;  // draws to beside_color_
  std::array<Texture, 2> blurred_color_;
  std::array<Framebuffer, 2> blurred_;
  Framebuffer color_alone_;  // without depth, which is read then
  Framebuffer lens_;         // draws to beside_color_
  // Memory that is used again: what is new to a process takes the processor as long as filling it does.
  std::vector<std::uint8_t> small_backdrop_;  // (4 x width x height of the backdrop)
  std::vector<std::uint8_t> read_back_;       // (4 x width x rows that are read at once)
};

}  // namespace thinwall

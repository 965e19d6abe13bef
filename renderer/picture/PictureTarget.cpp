#include "renderer/picture/PictureTarget.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/image/Opaque.hpp"
#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

std::string dimensions(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void require_drawable(ImageSize size) {
  if (size.width < 1 || size.height < 1) {
    throw PictureFailure("a picture of " + dimensions(size) + " pixels cannot be made: width and height start at 1");
  }
  GLint largest = 0, viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int limit = std::min({largest, viewport[0], viewport[1]});
  if (size.width > limit || size.height > limit) {
    throw PictureFailure("a picture of " + dimensions(size) + " pixels is beyond this driver's limit of " +
                         std::to_string(limit) + " on a side; choose a smaller size");
  }
  // Software drivers do not refuse what the machine cannot hold, they die of it.
  constexpr double kMostGigabytes = 4;
  constexpr double kBytesPerPixel = 16 + 16 + 8 + 8 + 4 + 4 + 4 + 0.5 + 2;  // of the textures below
  const double gigabytes = 1e-9 * kBytesPerPixel * size.width * size.height;
  if (gigabytes > kMostGigabytes) {
    throw PictureFailure("a picture of " + dimensions(size) + " pixels would take " +
                         std::to_string(std::lround(gigabytes)) +
                         " GB of frames, 4 GB are allowed; choose a smaller size");
  }
}

int half(int side) {
  return (side + 1) / 2;
}

int quarter(int side) {
  return (side + 3) / 4;
}

void attach(const Framebuffer& frame, GLenum attachment, const Texture& texture) {
  glNamedFramebufferTexture(frame.name(), attachment, texture.name(), 0);
}

void attach_depth(const Framebuffer& frame, const Texture& depth) {
  glNamedFramebufferTexture(frame.name(), GL_DEPTH_STENCIL_ATTACHMENT, depth.name(), 0);
}

void copy_within(const ScreenArea& area, const Texture& from, const Texture& to) {
  const auto& [left, bottom, width, height] = area;
  if (width == 0 || height == 0) return;
  glCopyImageSubData(from.name(), GL_TEXTURE_2D, 0, left, bottom, 0, to.name(), GL_TEXTURE_2D, 0, left, bottom, 0,
                     width, height, 1);
}

Image empty_image(ImageSize size) {
  const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  return {.size = size, .pixels = std::vector<std::uint8_t>(3 * pixels)};
}

/// Takes `rows` rows as of read_color, of which the first is the one above `bottom`.
void take_rows(const std::uint8_t* from, int bottom, int rows, Image& image) {
  const auto width = static_cast<std::size_t>(image.size.width);
  for (int row = 0; row < rows; ++row) {
    const auto from_top = static_cast<std::size_t>(image.size.height - 1 - bottom - row);
    leave_out_alpha(from + 4 * width * static_cast<std::size_t>(row), image.pixels.data() + 3 * width * from_top,
                    width);
  }
}

/// Of colours alone.
Framebuffer frame_of(const Texture& color, const char* name) {
  Framebuffer frame = create_framebuffer();
  attach(frame, GL_COLOR_ATTACHMENT0, color);
  require_complete(frame, name);
  return frame;
}

}  // namespace

PictureTarget::PictureTarget(ImageSize size) : size_(size) {
  require_drawable(size_);
  const auto texture = [&](GLenum format) { return create_texture(format, size_.width, size_.height, GL_NEAREST); };
  depth_ = texture(GL_DEPTH24_STENCIL8);
  tissue_ = texture(GL_RGBA32UI);
  color_ = create_texture(GL_RGBA8, size_.width, size_.height, GL_LINEAR);
  beside_color_ = texture(GL_RGBA8);

  surface_ = create_framebuffer();
  attach(surface_, GL_COLOR_ATTACHMENT0, tissue_);
  attach_depth(surface_, depth_);
  require_complete(surface_, "a frame of what is seen of tissue");

  tool_place_ = texture(GL_RGBA32F);
  tool_normal_ = texture(GL_RGBA16F);
  tool_axis_ = texture(GL_RGBA16F);
  tools_ = create_framebuffer();
  attach(tools_, GL_COLOR_ATTACHMENT0, tool_place_);
  attach(tools_, GL_COLOR_ATTACHMENT1, tool_normal_);
  attach(tools_, GL_COLOR_ATTACHMENT2, tool_axis_);
  attach_depth(tools_, depth_);
  const GLenum all_of_tools[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
  glNamedFramebufferDrawBuffers(tools_.name(), 3, all_of_tools);
  require_complete(tools_, "a frame of what is seen of tools");

  backdrop_color_ = create_texture(GL_RGBA8, quarter(size_.width), quarter(size_.height), GL_LINEAR);
  backdrop_ = frame_of(backdrop_color_, "a backdrop");
  backdrop_picture_.emplace(ImageSize{quarter(size_.width), quarter(size_.height)}, size_);

  frame_ = create_framebuffer();
  attach(frame_, GL_COLOR_ATTACHMENT0, color_);
  attach_depth(frame_, depth_);
  require_complete(frame_, "a frame of " + dimensions(size_));
  smoothing_ = create_framebuffer();
  attach(smoothing_, GL_COLOR_ATTACHMENT0, beside_color_);
  attach_depth(smoothing_, depth_);
  require_complete(smoothing_, "a frame of smoothed outlines");
  for (std::size_t k = 0; k < blurred_.size(); ++k) {
    blurred_color_[k] = create_texture(GL_RGBA8, half(size_.width), half(size_.height), GL_LINEAR);
    blurred_[k] = frame_of(blurred_color_[k], "a frame out of focus");
  }
  color_alone_ = frame_of(color_, "a frame of colours alone");
  lens_ = frame_of(beside_color_, "a frame behind the lens");
}

void PictureTarget::clear_depth() const {
  glDepthMask(GL_TRUE);
  glStencilMask(0xff);
  glClearNamedFramebufferfi(surface_.name(), GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

void PictureTarget::clear_depth(const FinePixels& fine) const {
  glDepthMask(GL_TRUE);
  glStencilMask(0xff);
  glClearNamedFramebufferfi(surface_.name(), GL_DEPTH_STENCIL, 0, 0.0f, 0);
  constexpr std::uint32_t kFarthest = 0xffffff00, kNearest = 0;  // 24 bits of depth, 8 of stencil
  const std::vector<std::uint32_t> depth = at_corners(fine, kFarthest, kNearest);
  const auto& [left, bottom, width, height] = fine.area;
  glTextureSubImage2D(depth_.name(), 0, left, bottom, width, height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                      depth.data());
}

bool PictureTarget::clear_depth(const FieldStop& stop) const {
  if (!stop_depth_ || stop != kept_stop_) return false;
  copy_within(whole(), *stop_depth_, depth_);
  return true;
}

void PictureTarget::keep_stop(const FieldStop& stop) {
  copy_depth(whole(), stop_depth_);
  kept_stop_ = stop;
}

void PictureTarget::copy_depth(const ScreenArea& area, std::optional<Texture>& to) const {
  if (!to) to = create_texture(GL_DEPTH24_STENCIL8, size_.width, size_.height, GL_NEAREST);
  copy_within(area, depth_, *to);
}

void PictureTarget::keep_depth() {
  copy_depth(whole(), kept_depth_);
}

void PictureTarget::keep_tissue_depth(const ScreenArea& tissue, const FieldStop& stop) {
  // Where tissue was in the last picture there may be none now.
  const bool is_new = !tissue_depth_ || stop != tissue_stop_;
  copy_depth(is_new ? whole() : around(tissue, kept_tissue_), tissue_depth_);
  kept_tissue_ = tissue;
  tissue_stop_ = stop;
  glBindTextureUnit(4, tissue_depth_->name());
}

void PictureTarget::read_color(const ScreenArea& area, std::vector<std::uint8_t>& pixels) const {
  const auto& [left, bottom, width, height] = area;
  pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_.name());
  glReadPixels(left, bottom, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void PictureTarget::write_color(const ScreenArea& area, std::span<const std::uint8_t> pixels) const {
  const auto& [left, bottom, width, height] = area;
  glTextureSubImage2D(color_.name(), 0, left, bottom, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void PictureTarget::begin_surface() const {
  glBindFramebuffer(GL_FRAMEBUFFER, surface_.name());
  glViewport(0, 0, size_.width, size_.height);
}

void PictureTarget::begin_tools() const {
  glBindFramebuffer(GL_FRAMEBUFFER, tools_.name());
  glViewport(0, 0, size_.width, size_.height);
}

ImageSize PictureTarget::backdrop_size() const {
  return {quarter(size_.width), quarter(size_.height)};
}

void PictureTarget::begin_backdrop() const {
  glBindFramebuffer(GL_FRAMEBUFFER, backdrop_.name());
  glViewport(0, 0, quarter(size_.width), quarter(size_.height));
}

void PictureTarget::read_backdrop() {
  const ImageSize small = backdrop_size();
  small_backdrop_.resize(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, backdrop_.name());
  glReadPixels(0, 0, small.width, small.height, GL_RGBA, GL_UNSIGNED_BYTE, small_backdrop_.data());
}

void PictureTarget::lay_backdrop(const FieldStop& stop) {
  write_color(whole(), backdrop_picture_->enlarge(small_backdrop_, stop));
}

void PictureTarget::begin_color() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, size_.width, size_.height);
  glBindTextureUnit(2, tissue_.name());
  glBindTextureUnit(3, tool_place_.name());
  glBindTextureUnit(6, tool_normal_.name());
  glBindTextureUnit(7, tool_axis_.name());
}

void PictureTarget::begin_smoothing() const {
  glBindFramebuffer(GL_FRAMEBUFFER, smoothing_.name());
  glViewport(0, 0, size_.width, size_.height);
  glBindTextureUnit(0, color_.name());
}

void PictureTarget::begin_smoothed() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, size_.width, size_.height);
  glBindTextureUnit(0, beside_color_.name());
}

void PictureTarget::begin_blurred(std::size_t turn) const {
  glBindFramebuffer(GL_FRAMEBUFFER, blurred_[turn].name());
  glViewport(0, 0, half(size_.width), half(size_.height));
  glBindTextureUnit(0, turn == 0 ? color_.name() : blurred_color_[0].name());
  glBindTextureUnit(1, (kept_depth_ ? *kept_depth_ : depth_).name());
}

void PictureTarget::begin_focused() const {
  glBindFramebuffer(GL_FRAMEBUFFER, color_alone_.name());
  glViewport(0, 0, size_.width, size_.height);
  glBindTextureUnit(0, blurred_color_[1].name());
  glBindTextureUnit(1, (kept_depth_ ? *kept_depth_ : depth_).name());
}

void PictureTarget::begin_lens() const {
  glBindFramebuffer(GL_FRAMEBUFFER, lens_.name());
  glViewport(0, 0, size_.width, size_.height);
  glBindTextureUnit(0, color_.name());
}

Image PictureTarget::finish(bool through_lens) {
  // What was read last is still in the processor's cache when it is taken on.
  constexpr int kRowsAtOnce = 40;
  read_back_.resize(4 * static_cast<std::size_t>(size_.width) * kRowsAtOnce);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, through_lens ? lens_.name() : frame_.name());
  Image image = empty_image(size_);
  for (int bottom = 0; bottom < size_.height; bottom += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, size_.height - bottom);
    glReadPixels(0, bottom, size_.width, rows, GL_RGBA, GL_UNSIGNED_BYTE, read_back_.data());
    take_rows(read_back_.data(), bottom, rows, image);
  }
  require_no_gl_error("drawing a picture of " + dimensions(size_));
  return image;
}

Image PictureTarget::finish(std::span<const std::uint8_t> picture) const {
  Image image = empty_image(size_);
  take_rows(picture.data(), 0, size_.height, image);
  require_no_gl_error("drawing a picture of " + dimensions(size_));
  return image;
}

}  // namespace thinwall

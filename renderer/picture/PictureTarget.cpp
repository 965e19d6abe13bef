#include "renderer/picture/PictureTarget.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include "renderer/picture/PictureFailure.hpp"

namespace thinwall {
namespace {

constexpr int kSamples = 4;  // what OpenGL 4.5 promises everywhere; never the driver's most, which differs

std::string dimensions(ImageSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void require_drawable(ImageSize size, ImageSize drawn, int samples) {
  if (size.width < 1 || size.height < 1) {
    throw PictureFailure("a picture of " + dimensions(size) + " pixels cannot be made: width and height start at 1");
  }
  GLint largest = 0, viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int limit = std::min({largest, viewport[0], viewport[1]});
  const std::string drawn_text = drawn == size ? "" : ", drawn at " + dimensions(drawn) + " for tier final,";
  if (drawn.width > limit || drawn.height > limit) {
    throw PictureFailure("a picture of " + dimensions(size) + " pixels" + drawn_text +
                         " is beyond this driver's limit of " + std::to_string(limit) +
                         " on a side; choose a smaller size" + (drawn_text.empty() ? "" : " or tier record"));
  }
  // Software drivers do not refuse what the machine cannot hold, they die of it.
  constexpr double kMostGigabytes = 4;
  const double bytes_per_pixel = 8.0 * std::max(samples, 1) + 4;
  const double gigabytes = 1e-9 * bytes_per_pixel * drawn.width * drawn.height;
  if (gigabytes > kMostGigabytes) {
    throw PictureFailure("a picture of " + dimensions(size) + " pixels" + drawn_text + " would take " +
                         std::to_string(static_cast<int>(gigabytes + 0.5)) +
                         " GB of frames, 4 GB are allowed; choose a smaller size or a lower tier");
  }
}

Framebuffer framebuffer_with(const Renderbuffer& color) {
  Framebuffer framebuffer = create_framebuffer();
  glNamedFramebufferRenderbuffer(framebuffer.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color.name());
  return framebuffer;
}

}  // namespace

PictureTarget::PictureTarget(ImageSize size, Tier tier)
    : size_(size), drawn_(size), samples_(tier == Tier::kDraft ? 0 : kSamples) {
  // Sizes far beyond any limit must not overflow on their way to the message.
  if (tier == Tier::kFinal && std::max(size.width, size.height) < (1 << 28)) drawn_ = {2 * size.width, 2 * size.height};
  require_drawable(size_, drawn_, samples_);
  color_ = create_renderbuffer(GL_RGBA8, drawn_.width, drawn_.height, samples_);
  depth_ = create_renderbuffer(GL_DEPTH_COMPONENT32F, drawn_.width, drawn_.height, samples_);
  frame_ = framebuffer_with(color_);
  glNamedFramebufferRenderbuffer(frame_.name(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  require_complete(frame_, "a frame of " + dimensions(drawn_));
  if (samples_ > 0) {
    resolved_color_ = create_renderbuffer(GL_RGBA8, drawn_.width, drawn_.height, 0);
    resolved_ = framebuffer_with(resolved_color_);
    require_complete(resolved_, "a frame of " + dimensions(drawn_));
  }
  if (drawn_ != size_) {
    small_color_ = create_renderbuffer(GL_RGBA8, size_.width, size_.height, 0);
    small_ = framebuffer_with(small_color_);
    require_complete(small_, "a frame of " + dimensions(size_));
  }
}

void PictureTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, drawn_.width, drawn_.height);
  glDepthMask(GL_TRUE);
  const float black[4] = {0, 0, 0, 1};
  const float farthest = 1;
  glClearNamedFramebufferfv(frame_.name(), GL_COLOR, 0, black);
  glClearNamedFramebufferfv(frame_.name(), GL_DEPTH, 0, &farthest);
}

void PictureTarget::resolve() const {
  if (samples_ > 0) {
    glBlitNamedFramebuffer(frame_.name(), resolved_.name(), 0, 0, drawn_.width, drawn_.height, 0, 0, drawn_.width,
                           drawn_.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  if (drawn_ != size_) {
    // Half the size with linear filtering takes the mean of two by two pixels.
    glBlitNamedFramebuffer(resolved_.name(), small_.name(), 0, 0, drawn_.width, drawn_.height, 0, 0, size_.width,
                           size_.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  }
}

Image PictureTarget::finish() const {
  resolve();
  const Framebuffer& last = drawn_ != size_ ? small_ : samples_ > 0 ? resolved_ : frame_;
  const std::size_t width = static_cast<std::size_t>(size_.width);
  const std::size_t height = static_cast<std::size_t>(size_.height);
  std::vector<std::uint8_t> upside_down(4 * width * height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, last.name());
  glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
  require_no_gl_error("drawing a picture of " + dimensions(size_));

  Image image{.size = size_, .pixels = std::vector<std::uint8_t>(3 * width * height)};
  for (std::size_t row = 0; row < height; ++row) {
    const std::uint8_t* from = upside_down.data() + 4 * width * (height - 1 - row);
    std::uint8_t* to = image.pixels.data() + 3 * width * row;
    for (std::size_t column = 0; column < width; ++column) {
      to[3 * column] = from[4 * column];
      to[3 * column + 1] = from[4 * column + 1];
      to[3 * column + 2] = from[4 * column + 2];
    }
  }
  return image;
}

}  // namespace thinwall

#pragma once

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/image/Image.hpp"

namespace thinwall {

/// A part of a picture, in pixels from the upper left.
struct PictureBox {
  int left = 0;
  int top = 0;
  ImageSize size = {};
};

/// The part of a picture of `size` that the shot's own camera fills: all of it, or the left half when another is
/// beside.
PictureBox main_box(const Shot& shot, ImageSize size);

/// The right half.
PictureBox beside_box(ImageSize size);

/// A small picture of the same shape in the shot's corner, clear of title, time and panels: 0.3 times as wide as what
/// the shot's own camera fills, so that the middle of a half is free too.
PictureBox inset_box(const Shot& shot, ImageSize size);

/// Lays a picture onto a part of the same size of another.
void paste(const Image& part, const PictureBox& box, Image& onto);

/// A light line around a box, just inside it.
void frame_box(const PictureBox& box, Image& image);

}  // namespace thinwall

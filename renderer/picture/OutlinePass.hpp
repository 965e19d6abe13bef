#pragma once

#include <span>

#include "renderer/picture/GlObjects.hpp"
#include "renderer/picture/PictureTarget.hpp"
#include "renderer/shape/Outline.hpp"

namespace thinwall {

/// Smooths the stairs along outlines: a pixel that an outline runs through takes the part of its neighbour's colour
/// that the part of its area beyond the outline is (geometric anti-aliasing after Persson 2011). Where pixels are
/// computed by the processor this costs a hundredth of several samples per pixel, and knows 256 steps instead of 4.
class OutlinePass {
 public:
  OutlinePass();

  /// Smooths the colours of `target`; the Frame block must be bound. The first line that runs through a pixel smooths
  /// it.
  void draw(std::span<const OutlineSegment> outline, const PictureTarget& target) const;

 private:
  void draw_lines(const Program& program, std::size_t count) const;

  Program program_;
  Program blend_;
  VertexArray array_;
  Buffer segments_;
};

}  // namespace thinwall

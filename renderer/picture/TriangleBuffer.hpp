#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/picture/GlObjects.hpp"

namespace thinwall {

/// One vector of floats of a vertex, as a shader reads it.
struct VertexAttribute {
  GLuint location = 0;
  GLint components = 3;
  GLuint offset = 0;  // bytes from the start of the vertex
};

/// Vertices and triangles on the device.
class TriangleBuffer {
 public:
  TriangleBuffer(GLsizei vertex_size, const std::vector<VertexAttribute>& attributes);

  template <typename Vertex>
  void upload(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices) {
    upload_bytes(vertices.data(), vertices.size_bytes(), indices);
  }

  /// Draws `count` indices from `first` with the current program.
  void draw(std::size_t first, std::size_t count) const;
  void draw() const { draw(0, index_count_); }

  /// Draws triangles of other `indices` than those that were uploaded.
  void draw_others(std::span<const std::uint32_t> indices) const;

 private:
  void upload_bytes(const void* vertices, std::size_t bytes, std::span<const std::uint32_t> indices);

  VertexArray array_;
  Buffer vertices_;
  Buffer indices_;
  Buffer others_;
  std::size_t index_count_ = 0;
};

}  // namespace thinwall

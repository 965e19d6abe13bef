#include "renderer/picture/TriangleBuffer.hpp"

namespace thinwall {

TriangleBuffer::TriangleBuffer(GLsizei vertex_size, const std::vector<VertexAttribute>& attributes)
    : array_(create_vertex_array()), vertices_(create_buffer()), indices_(create_buffer()), others_(create_buffer()) {
  glVertexArrayVertexBuffer(array_.name(), 0, vertices_.name(), 0, vertex_size);
  for (const VertexAttribute& attribute : attributes) {
    glEnableVertexArrayAttrib(array_.name(), attribute.location);
    glVertexArrayAttribFormat(array_.name(), attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              attribute.offset);
    glVertexArrayAttribBinding(array_.name(), attribute.location, 0);
  }
}

void TriangleBuffer::upload_bytes(const void* vertices, std::size_t bytes, std::span<const std::uint32_t> indices) {
  glNamedBufferData(vertices_.name(), static_cast<GLsizeiptr>(bytes), vertices, GL_STREAM_DRAW);
  glNamedBufferData(indices_.name(), static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(), GL_STREAM_DRAW);
  index_count_ = indices.size();
}

void TriangleBuffer::draw(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  glVertexArrayElementBuffer(array_.name(), indices_.name());
  glBindVertexArray(array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void TriangleBuffer::draw_others(std::span<const std::uint32_t> indices) const {
  if (indices.empty()) return;
  glNamedBufferData(others_.name(), static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(), GL_STREAM_DRAW);
  glVertexArrayElementBuffer(array_.name(), others_.name());
  glBindVertexArray(array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace thinwall

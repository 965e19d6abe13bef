#include "renderer/shape/ToolOutline.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "renderer/snapshot/Vector.hpp"

namespace thinwall {
namespace {

/// A cube around the origin; each face has corners of its own, and two triangles.
ToolShape cube(float half) {
  ToolShape shape;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float sense : {-1.0F, 1.0F}) {
      const auto first = static_cast<std::uint32_t>(shape.vertices.size());
      for (const auto& [u, v] : std::array<std::array<float, 2>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
        ToolVertex vertex;
        vertex.position[axis] = sense * half;
        vertex.position[(axis + 1) % 3] = sense * u * half;
        vertex.position[(axis + 2) % 3] = v * half;
        vertex.normal[axis] = sense;
        shape.vertices.push_back(vertex);
      }
      for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) shape.indices.push_back(first + k);
    }
  }
  return shape;
}

std::vector<OutlineSegment> outline_of(const ToolShape& shape, Vector3 eye, double pixel = 0.001) {
  ToolOutline outline;
  outline.set(shape.vertices, shape.indices);
  std::vector<OutlineSegment> segments;
  outline.append(shape.vertices, eye, pixel, segments);
  return segments;
}

TEST(ToolOutline, OfACubeIsWhatIsSeenOfItsEdgesOnce) {
  EXPECT_EQ(outline_of(cube(1), {0, 0, 9}).size(), 4u) << "the square that faces the eye";
  EXPECT_EQ(outline_of(cube(1), {9, 8, 7}).size(), 9u) << "three faces, of whose edges three are creases";
}

TEST(ToolOutline, AFaceWithoutACreaseIsDividedNowhere) {
  ToolShape smooth = cube(1);
  for (ToolVertex& vertex : smooth.vertices) {
    const Vector3 outwards = normalized(vector3(vertex.position));
    for (std::size_t k = 0; k < 3; ++k)
      vertex.normal[k] = static_cast<float>(std::array{outwards.x, outwards.y, outwards.z}[k]);
  }
  EXPECT_EQ(outline_of(smooth, {9, 8, 7}).size(), 6u) << "the hexagon that divides it from what is behind";
}

TEST(ToolOutline, HasNoCreasesBesideSidesThatAreNarrowerThanAPixel) {
  ToolShape plate = cube(1);
  for (ToolVertex& vertex : plate.vertices) {
    if (vertex.normal[0] == 0) vertex.narrow = {2, 0, 0};
  }
  const Vector3 eye{900, 8, 7};
  EXPECT_EQ(outline_of(plate, eye, 1e-6).size(), 9u);
  EXPECT_EQ(outline_of(plate, eye, 1e-3).size(), 6u) << "what divides it from what is behind";
}

TEST(ToolOutline, IsTheSameWhateverWasThereBefore) {
  const ToolShape small = cube(1), large = cube(2);
  ToolShape both = small;
  for (const ToolVertex& vertex : large.vertices) both.vertices.push_back(vertex);
  for (const std::uint32_t index : large.indices) both.indices.push_back(24 + index);
  ToolOutline outline;
  std::vector<OutlineSegment> segments;
  for (const ToolShape* shape : {&small, static_cast<const ToolShape*>(&both), &large}) {
    outline.set(shape->vertices, shape->indices);
    segments.clear();
    outline.append(shape->vertices, {9, 8, 7}, 0.001, segments);
  }
  const std::vector<OutlineSegment> alone = outline_of(large, {9, 8, 7});
  ASSERT_EQ(segments.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(segments[i].start, alone[i].start);
    EXPECT_EQ(segments[i].end, alone[i].end);
  }
}

}  // namespace
}  // namespace thinwall

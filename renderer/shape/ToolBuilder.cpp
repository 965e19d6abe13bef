#include "renderer/shape/ToolBuilder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/snapshot/Float3.hpp"

namespace thinwall {

ToolBuilder::ToolBuilder(const SnapshotTool& tool, double scene_size)
    : tip_(vector3(tool.tip)), direction_(normalized(vector3(tool.direction), {0, 0, -1})), scene_size_(scene_size) {
  const Vector3 axis = vector3(tool.axis) - dot(vector3(tool.axis), direction_) * direction_;
  axis_ = length(axis) > 1e-9 ? normalized(axis) : perpendicular(direction_);
  side_ = cross(axis_, direction_);
}

void ToolBuilder::turn(const std::vector<OutlinePoint>& outline) {
  constexpr int kSegments = 32;
  const auto first = static_cast<std::uint32_t>(shape_.vertices.size());
  for (const OutlinePoint& point : outline) {
    for (int i = 0; i <= kSegments; ++i) {
      const double angle = 2 * std::numbers::pi * (i % kSegments) / kSegments;
      const Vector3 radial = std::cos(angle) * side_ + std::sin(angle) * axis_;
      append(tip_ - point.back * direction_ + point.out * radial,
             normalized(point.normal_out * radial - point.normal_back * direction_), point);
    }
  }
  stitch(first, static_cast<std::uint32_t>(outline.size()), kSegments + 1);
}

void ToolBuilder::draw_out(const std::vector<OutlinePoint>& outline, double span) {
  const auto first = static_cast<std::uint32_t>(shape_.vertices.size());
  for (const double end : {-0.5 * span, 0.5 * span}) {
    for (const OutlinePoint& point : outline) {
      append(place(point, end), normalized(point.normal_out * side_ - point.normal_back * direction_), point);
    }
  }
  stitch(first, 2, static_cast<std::uint32_t>(outline.size()));
  for (const double end : {-0.5 * span, 0.5 * span}) {
    const auto fan = static_cast<std::uint32_t>(shape_.vertices.size());
    for (const OutlinePoint& point : outline) append(place(point, end), end > 0 ? axis_ : -axis_, point);
    for (std::uint32_t i = 2; i < outline.size(); ++i) append_triangle(fan, fan + i - 1, fan + i);
  }
}

/// Sine of the angle by which the faces of a flat tool turn to their middle at their borders: they are hollow ground,
/// and so mirror more than one place.
constexpr double kHollow = 0.22;

/// Part of its thickness and, as length, of its half width by which the long edges of a flat tool are ground off.
constexpr double kChamfer = 0.5;
constexpr double kChamferWidth = 0.12;

/// Roughness of its narrow sides and of what is ground off, over that of its broad faces.
constexpr float kSideFinish = 0.75F;

/// Cosine of the largest angle between two faces that follow one another which does not show as a crease.
constexpr double kBent = 0.87;

void ToolBuilder::join(const std::vector<FlatSection>& sections) {
  // Corners of a section, from the middle of one broad face around to the other.
  constexpr std::size_t kQuarter = 4, kCorners = 2 * kQuarter;
  const auto middle_of = [&](const FlatSection& section) {
    return tip_ - section.back * direction_ + section.middle * side_;
  };
  const auto corner = [&](const FlatSection& section, std::size_t k) {
    const double sense = k % kCorners < kQuarter ? 1 : -1;
    const double x = section.half_thickness, y = section.half_width;
    const double off_x = section.chamfer > 0 ? section.chamfer : kChamfer * x;
    const double off_y = section.chamfer > 0 ? section.chamfer : kChamferWidth * y;
    const std::array<std::array<double, 2>, kQuarter> places = {
        {{x, off_y - y}, {x, y - off_y}, {x - off_x, y}, {off_x - x, y}}};
    const auto [across, along] = places[k % kQuarter];
    return middle_of(section) + sense * across * side_ + sense * along * axis_;
  };
  // Of the face from corner `c` on, between section `k` and the one before.
  const auto corners = [&](std::size_t k, std::size_t c) {
    return std::array<Vector3, 4>{corner(sections[k - 1], c), corner(sections[k - 1], c + 1),
                                  corner(sections[k], c + 1), corner(sections[k], c)};
  };
  const auto normal = [&](std::size_t k, std::size_t c) {
    const auto [a, b, d, e] = corners(k, c);
    const Vector3 across = normalized(cross(d - a, b - e));
    const Vector3 outwards = 0.25 * (a + b + d + e) - 0.5 * (middle_of(sections[k - 1]) + middle_of(sections[k]));
    return dot(across, outwards) < 0 ? -across : across;
  };
  for (std::size_t k = 1; k < sections.size(); ++k) {
    for (std::size_t c = 0; c < kCorners; ++c) {
      const Vector3 own = normal(k, c);
      // Faces that turn little from one to the next are one that is bent.
      const auto bent = [&](std::size_t other) {
        const Vector3 next = other > 0 && other < sections.size() ? normal(other, c) : own;
        return dot(own, next) > kBent ? normalized(own + next) : own;
      };
      append_face(corners(k, c), bent(k - 1), bent(k + 1), sections[k], c % kQuarter == 0);
      shown_as_beside(corners(k, c), own, normal(k, (c + 1) % kCorners), sections[k].roughness);
    }
  }
  for (const FlatSection* end : {&sections.front(), &sections.back()}) {
    const auto fan = static_cast<std::uint32_t>(shape_.vertices.size());
    const Vector3 outwards = end == &sections.front() ? direction_ : -direction_;
    for (std::size_t c = 0; c < kCorners; ++c)
      append(corner(*end, c), outwards, {.back = end->back, .roughness = -kBrushed});
    for (std::uint32_t c = 2; c < kCorners; ++c) append_triangle(fan, fan + c - 1, fan + c);
  }
}

void ToolBuilder::add_quad(const std::array<Vector3, 4>& corners, const std::array<Vector3, 4>& normals,
                           float roughness, const std::array<float, 4>& shade) {
  const auto first = static_cast<std::uint32_t>(shape_.vertices.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    append(tip_ + turned(corners[k]), normalized(turned(normals[k])),
           {.back = corners[k].z, .roughness = -roughness, .grip = -shade[k]});
  }
  append_triangle(first, first + 1, first + 2);
  append_triangle(first, first + 2, first + 3);
}

void ToolBuilder::add_narrow_quad(const std::array<Vector3, 4>& corners, const std::array<Vector3, 4>& normals,
                                  float roughness, double hollow, float broad_roughness) {
  add_quad(corners, normals, roughness);
  const Float3 narrow = float3(length(corners[1] - corners[0]) * side_);
  for (auto vertex = shape_.vertices.end() - 4; vertex != shape_.vertices.end(); ++vertex) {
    vertex->narrow = narrow;
    vertex->broad_hollow = static_cast<float>(hollow);
    vertex->broad_roughness = -broad_roughness;
  }
}

void ToolBuilder::add_rod(double back_from, double back_to, double radius) {
  add_rod(tip_ - back_from * direction_, tip_ - back_to * direction_, radius);
}

void ToolBuilder::add_rod_along_axis(double back, double span, double radius) {
  const Vector3 middle = tip_ - back * direction_;
  add_rod(middle - 0.5 * span * axis_, middle + 0.5 * span * axis_, radius);
}

ToolShape ToolBuilder::take() {
  return std::move(shape_);
}

void ToolBuilder::add(const ToolShape& other) {
  const auto first = static_cast<std::uint32_t>(shape_.vertices.size());
  shape_.vertices.insert(shape_.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t index : other.indices) shape_.indices.push_back(first + index);
  shape_.rods.insert(shape_.rods.end(), other.rods.begin(), other.rods.end());
}

Vector3 ToolBuilder::turned(Vector3 local) const {
  return local.x * side_ + local.y * axis_ - local.z * direction_;
}

Vector3 ToolBuilder::place(const OutlinePoint& point, double along_axis) const {
  return tip_ - point.back * direction_ + point.out * side_ + along_axis * axis_;
}

/// A face with the given corners, one after the other, the first two at its front; it may be bent between both ends.
void ToolBuilder::append_face(const std::array<Vector3, 4>& corners, Vector3 front, Vector3 rear,
                              const FlatSection& section, bool is_broad) {
  const double hollow = is_broad ? kHollow : 0;
  const auto first = static_cast<std::uint32_t>(shape_.vertices.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double aside = dot(corners[k] - tip_, axis_);
    const OutlinePoint point{.back = dot(tip_ - corners[k], direction_),
                             .roughness = -(is_broad ? 1.0F : kSideFinish) * section.roughness,
                             .grip = is_broad ? section.grip : 0};
    append(corners[k], normalized((k < 2 ? front : rear) - (aside > 0 ? hollow : -hollow) * axis_), point);
  }
  append_triangle(first, first + 1, first + 2);
  append_triangle(first, first + 2, first + 3);
}

/// Seen along itself the last face is less than a pixel wide: then it looks as the one beside it that the viewer sees.
/// `own`, `next`: outward normals, of it and of the one beyond its second and third corner.
void ToolBuilder::shown_as_beside(const std::array<Vector3, 4>& corners, Vector3 own, Vector3 next, float roughness) {
  // What is ground off is often about a pixel wide where it is not seen along itself.
  constexpr double kLessNarrow = 1.7;
  const double cosine = dot(own, next), sine = length(cross(own, next));
  for (std::size_t k = 0; k < corners.size(); ++k) {
    ToolVertex& vertex = shape_.vertices[shape_.vertices.size() - corners.size() + k];
    vertex.narrow = float3(kLessNarrow * (k < 2 ? corners[1] - corners[0] : corners[2] - corners[3]));
    vertex.broad_hollow = static_cast<float>(-cosine / std::max(sine, 0.1));
    vertex.broad_roughness = -roughness;
  }
}

void ToolBuilder::append(Vector3 position, Vector3 normal, const OutlinePoint& point) {
  shape_.vertices.push_back({.position = float3(position),
                             .normal = float3(normal),
                             .roughness = point.roughness,
                             .along = static_cast<float>(point.back / scene_size_),
                             .grip = point.grip,
                             .side = static_cast<float>(dot(position - tip_, side_) / scene_size_),
                             .aside = static_cast<float>(dot(position - tip_, axis_) / scene_size_)});
}

/// Counter-clockwise as seen from outside, where the normals point.
void ToolBuilder::append_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto position = [&](std::uint32_t i) { return vector3(shape_.vertices[i].position); };
  const auto normal = [&](std::uint32_t i) { return vector3(shape_.vertices[i].normal); };
  const Vector3 facing = cross(position(b) - position(a), position(c) - position(a));
  if (dot(facing, normal(a) + normal(b) + normal(c)) < 0) std::swap(b, c);
  shape_.indices.insert(shape_.indices.end(), {a, b, c});
}

/// Triangles between consecutive rows of `columns` vertices.
void ToolBuilder::stitch(std::uint32_t first, std::uint32_t rows, std::uint32_t columns) {
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t corner = first + row * columns + column;
      append_triangle(corner, corner + 1, corner + columns);
      append_triangle(corner + 1, corner + columns + 1, corner + columns);
    }
  }
}

void ToolBuilder::add_rod(Vector3 start, Vector3 end, double radius) {
  shape_.rods.push_back({float3(start), float3(end), static_cast<float>(radius)});
}

}  // namespace thinwall

#include "renderer/shape/ToolOutline.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace thinwall {
namespace {

struct PlaceHash {
  std::size_t operator()(const Float3& place) const {
    std::uint64_t mixed = 0;
    for (const float coordinate : place) {
      // Zero has two signs.
      mixed = (mixed ^ std::bit_cast<std::uint32_t>(coordinate + 0.0F)) * 0x9e3779b97f4a7c15u;
      mixed ^= mixed >> 29;
    }
    return mixed;
  }
};

std::vector<std::uint32_t> places_of(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners) {
  std::unordered_map<Float3, std::uint32_t, PlaceHash> first_at;
  first_at.reserve(vertices.size());
  std::vector<std::uint32_t> first_of(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    first_of[i] = first_at.try_emplace(vertices[i].position, i).first->second;
  }
  std::vector<std::uint32_t> places;
  places.reserve(corners.size());
  for (const std::uint32_t corner : corners) places.push_back(first_of[corner]);
  return places;
}

}  // namespace

void ToolOutline::set(std::span<const ToolVertex> vertices, std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> places = places_of(vertices, corners);
  if (places == places_) return;
  places_ = std::move(places);
  std::vector<std::pair<std::uint64_t, Side>> sides;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::uint32_t a = places_[i], b = places_[i + 1], c = places_[i + 2];
    if (a == b || b == c || c == a) continue;  // a tip, where many vertices of a turned outline meet
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t start = i + k, end = i + (k + 1) % 3, third = i + (k + 2) % 3;
      const std::uint64_t low = std::min(places_[start], places_[end]), high = std::max(places_[start], places_[end]);
      sides.push_back({low << 32 | high, {corners[start], corners[end], corners[third]}});
    }
  }
  std::ranges::stable_sort(sides, {}, [](const auto& side) { return side.first; });
  edges_.clear();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    Edge edge{.near = sides[i].second, .other = {}, .is_border = true};
    if (i + 1 < sides.size() && sides[i + 1].first == sides[i].first) {
      edge.other = sides[++i].second;
      edge.is_border = false;
    }
    edges_.push_back(edge);
  }
}

void ToolOutline::append(std::span<const ToolVertex> vertices, Vector3 eye, double pixel,
                         std::vector<OutlineSegment>& outline) const {
  const auto place = [&](std::uint32_t i) { return vector3(vertices[i].position); };
  const auto faces_eye = [&](const Side& side) {
    const Vector3 start = place(side.start);
    return dot(cross(place(side.end) - start, place(side.third) - start), eye - start) > 0;
  };
  const auto differ = [&](std::uint32_t i, std::uint32_t k) {
    constexpr double kCrease = 0.9962;  // cosine of 5 degrees
    return dot(vector3(vertices[i].normal), vector3(vertices[k].normal)) < kCrease;
  };
  const auto is_thin = [&](std::uint32_t i) {
    constexpr double kWidest = 1.1;  // pixels
    const Vector3 narrow = vector3(vertices[i].narrow), view = eye - place(i);
    const double width = length(narrow);
    if (!(width > 0)) return false;
    const Vector3 normal = vector3(vertices[i].normal), across = (1 / width) * narrow;
    const Vector3 outward = normalized(normal - dot(normal, across) * across);
    return width * std::abs(dot(outward, view)) < kWidest * pixel * dot(view, view);
  };
  for (const Edge& edge : edges_) {
    const bool near = faces_eye(edge.near), other = !edge.is_border && faces_eye(edge.other);
    if (!near && !other) continue;
    // Neighbours run along an edge in opposite senses.
    if (near && other && !differ(edge.near.start, edge.other.end) && !differ(edge.near.end, edge.other.start)) continue;
    if (near && other && (is_thin(edge.near.start) || is_thin(edge.other.start))) continue;
    outline.push_back({vertices[edge.near.start].position, vertices[edge.near.end].position});
  }
}

}  // namespace thinwall

#include "renderer/shape/WoundCoat.hpp"

#include <algorithm>
#include <span>

#include "renderer/snapshot/Float3.hpp"

namespace thinwall {
namespace {

constexpr double kDrawnOut = 0.55;  // how much of the way down a face its pattern is long

}  // namespace

FilmVertex wound_coat(const SurfaceVertex& vertex, double fullness, double height, double dry) {
  return {.position = vertex.position,
          .normal = vertex.normal,
          .rest = vertex.rest,
          .inward = static_cast<float>(std::max(fullness, 2 * kNoCoat)),
          .width = 1,
          .height = static_cast<float>(height),
          .dry = static_cast<float>(dry),
          .lift = kOnTriangles,
          .kind = kFilmCoat};
}

void append_faces(std::span<const BorderEdge> borders, const TissuePiece& rim, const WoundMap& map,
                  const FaceCoat& coat, Film& film) {
  const auto offset = static_cast<std::uint32_t>(film.vertices.size());
  for (std::size_t v = 0; v < rim.vertices.size(); ++v) {
    const BorderEdge& edge = borders[v / 4];
    const std::uint32_t lip = v % 4 < 2 ? edge.start : edge.end;
    const std::vector<double>& fullness = v % 2 == 0 ? coat.outside : coat.inside;
    film.vertices.push_back(wound_coat(rim.vertices[v], fullness[lip], coat.height, coat.dry[lip]));
    // What runs down is drawn out that way.
    const Vector3 outer = vector3(rim.vertices[v - v % 2].rest);
    Float3& rest = film.vertices.back().rest;
    rest = float3(outer + kDrawnOut * (vector3(rest) - outer));
  }
  for (std::size_t k = 0; k < borders.size(); ++k) {
    if (map.lip[borders[k].start] != borders[k].start || map.lip[borders[k].end] != borders[k].end) continue;
    const auto face = std::span(film.vertices).subspan(offset + 4 * k, 4);
    const auto is_coated = [](const FilmVertex& vertex) { return vertex.inward > static_cast<float>(kNoCoat); };
    if (std::ranges::none_of(face, is_coated)) continue;
    for (std::size_t c = 6 * k; c < 6 * k + 6; ++c) film.corners.push_back(offset + rim.corners[c]);
  }
}

}  // namespace thinwall

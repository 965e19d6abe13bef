#pragma once

#include <span>
#include <vector>

#include "renderer/shape/Film.hpp"
#include "renderer/shape/TissuePieces.hpp"
#include "renderer/wound/WoundMap.hpp"

namespace thinwall {

/// Fullness (inward / width) of a coat, below which the unevenness of film.glsl leaves nothing of it.
inline constexpr double kNoCoat = -1.6;

inline constexpr float kOnTriangles = 0.00002F;  // metres, lift of a film on the wall's own triangles

/// A coat on a vertex of what a cut has opened. `height`: metres, where the fullness is about one; `dry`: 0 to 1.
FilmVertex wound_coat(const SurfaceVertex& vertex, double fullness, double height, double dry);

/// What lies on the faces of a cut.
struct FaceCoat {
  double height = 0;                    // metres, where the fullness is about one
  std::vector<double> outside, inside;  // fullness (vertices), of lips, at the two edges of their faces
  std::vector<double> dry;              // (vertices), of lips, 0 to 1
};

/// Adds that to the rims of what has been cut, where there is any. `rim`: a piece of four vertices for each of the
/// borders.
void append_faces(std::span<const BorderEdge> borders, const TissuePiece& rim, const WoundMap& map,
                  const FaceCoat& coat, Film& film);

}  // namespace thinwall

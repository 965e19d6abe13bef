#pragma once

#include "renderer/camera/Camera.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/picture/FrameUniforms.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// By which power of two a camera with automatic exposure makes its picture brighter: what brings the mean brightness
/// of the walls that it sees to that of a well-lit picture, at most two stops either way; a dark organ stays darker
/// than a pale one. Metered from the triangles that face the camera inside the picture, each by the part of the picture
/// that it fills and by the light of the lamp that it receives; nothing but the arguments counts, so the exposure is
/// the same in any order of pictures. Zero where no wall is seen.
double metered_exposure(const Snapshot& snapshot, const ViewDefinition& view, const Camera& camera,
                        const FrameUniforms& frame, bool has_endoscope_lamp);

}  // namespace thinwall

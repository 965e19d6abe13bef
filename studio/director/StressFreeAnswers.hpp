#pragma once

#include "studio/director/HiddenParts.hpp"
#include "studio/director/InwardNormal.hpp"
#include "studio/scenario/SurfaceAnswers.hpp"

namespace thinwall {

/// Of the bodies as they are before anything has happened to them.
inline SurfaceAnswers stress_free_answers() {
  return {.inward_normal = inward_normal, .hidden_parts = hidden_parts};
}

}  // namespace thinwall

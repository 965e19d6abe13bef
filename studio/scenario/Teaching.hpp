#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/annotation/Annotation.hpp"

namespace thinwall {

/// The video stands still while the simulation does not go on.
struct Freeze {
  double at = 0;        // seconds of the simulation
  double duration = 1;  // seconds of the video
};

/// A span of the simulation that is shown at another speed.
struct SlowMotion {
  double begin = 0;  // seconds of the simulation
  double end = 1;    // seconds of the simulation
  double speed = 1;  // of the simulation in the video; below 1 slower
};

/// Words in the middle of a darkened picture.
struct CardScenario {
  std::string title = {};
  std::string text = {};  // below the title; empty: none
  double duration = 3;    // seconds of the video
};

/// What makes a recording a lesson.
struct Teaching {
  AnnotationDefinition annotations = {};
  std::vector<Freeze> freezes = {};
  std::vector<SlowMotion> slow_motions = {};
  std::optional<CardScenario> title_card = {};  // over the first picture
  std::optional<CardScenario> end_card = {};    // over the last one
};

}  // namespace thinwall

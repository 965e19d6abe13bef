#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/ground_truth/MaterialMatch.hpp"
#include "renderer/ground_truth/Projection.hpp"
#include "renderer/ground_truth/SeenPlaces.hpp"

namespace thinwall {

/// What becomes of what a pixel shows, in another picture.
enum class FlowState : std::uint8_t {
  kNothing,  // the pixel shows nothing, or there is no other picture
  kSeen,     // it is seen there too
  kHidden,   // something is before it there
  kOutside,  // it lies outside that picture
  kAbsent    // it is not there: born in between, looking back
};

struct OpticalFlow {
  std::vector<std::array<float, 2>> flow;  // (height x width), pixels, x to the right, y down; 0 where it is not known
  std::vector<FlowState> state;            // (height x width)
  // (height x width), whether the flow is: not of what is absent, nor of what lands nowhere, as it lies behind the
  // other camera or where its lens folds the plane over.
  std::vector<char> is_known;

  explicit OpticalFlow(std::size_t pixels) : flow(pixels), state(pixels, FlowState::kNothing), is_known(pixels, 0) {}
};

/// A picture's moment, where it was seen from, and what it shows.
struct SeenMoment {
  const Snapshot& snapshot;
  const SceneGeometry& geometry;
  const Projection& projection;
  const SeenPlaces& seen;
};

/// From the middle of each pixel of one picture to where its matter lands in another, exactly: by the matter's own
/// motion and the cameras', across cuts too. Hidden is what has another place of the scene before it on its ray,
/// wherever between the middles of pixels it lands.
OpticalFlow optical_flow(const SeenMoment& from, const SeenMoment& to);

}  // namespace thinwall

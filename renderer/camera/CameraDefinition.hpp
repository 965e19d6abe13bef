#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/camera/Lens.hpp"
#include "renderer/image/PictureCorner.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

enum class CameraKind {
  kPinhole,
  kEndoscope  // with a round field stop, darker towards it
};

/// How a camera goes from one state to the next: at constant speed, or from rest to rest with 3 t^2 - 2 t^3.
enum class CameraEase { kLinear, kSmooth };

/// Where a camera is at a time. What is absent is the camera's own.
struct CameraKeyframe {
  double time = 0;                           // seconds
  std::optional<Double3> position = {};      // metres
  std::optional<Double3> target = {};        // metres
  std::optional<Double3> up = {};            // direction
  std::optional<double> field_of_view = {};  // radians, vertical
  CameraEase ease = CameraEase::kSmooth;     // of the way from the keyframe before
};

/// Keeps a tool's tip in the middle of the picture.
struct CameraFollow {
  std::string tool = {};
  double smoothing = 0.4;  // seconds, how soft the camera is: it lags behind a steady tool by this time
  bool travels = true;     // moves along with the tool, its line of sight kept; else it stays where it is and turns
};

/// Goes nearer to the target by a factor over a span of time, and stays there.
struct CameraPushIn {
  double begin = 0;   // seconds
  double end = 1;     // seconds
  double factor = 1;  // distance to the target afterwards over the distance without it
  CameraEase ease = CameraEase::kSmooth;
};

/// What is absent is chosen so that the reference surfaces fill the picture, seen obliquely from above.
struct CameraDefinition {
  std::optional<Double3> position = {};  // metres
  std::optional<Double3> target = {};    // metres
  std::optional<Double3> facing = {};  // the sense in which a camera without position looks; obliquely down when absent
  std::optional<double> elevation = {};  // radians, down which a camera without both looks; 33 degrees when absent
  std::optional<Double3> up = {};        // direction
  double field_of_view = 0.5236;         // radians, vertical
  double orbit_speed = 0;                // radians / second around the upward axis through the target
  std::optional<double> orbit_end = {};  // seconds, when that is to be over, if it is known; set for each picture
  CameraKind kind = CameraKind::kPinhole;
  double exposure = 0;                         // brighter by this power of two
  std::vector<CameraKeyframe> keyframes = {};  // ascending in time
  std::optional<CameraFollow> follow = {};
  std::optional<Double3> followed_point = {};  // metres, where the followed tool is seen to be; set for each picture
  std::vector<CameraPushIn> push_ins = {};
  std::optional<double> lamp = {};  // strength of the lamp beside its lens; the light's `endoscope` when absent

  LensDistortion lens = {};
  double aperture = 0;               // metres, across the opening of its lens; 0: all is in focus
  std::optional<double> focus = {};  // metres along the line of sight; to the target when absent
  bool auto_exposure = false;        // by how bright the walls before it are lit
  double noise = 0;                  // of its sensor, standard deviation at mid-grey, 8-bit levels
  std::uint32_t seed = 1;            // of the noise

  /// Whether anything but an orbit moves it.
  bool is_moved() const { return !keyframes.empty() || follow || !push_ins.empty(); }
};

/// What is shown from a time on. Cameras by their names; `main` is the camera that needs no name.
struct CameraCut {
  double time = 0;  // seconds
  std::string camera = "main";
  std::optional<std::string> beside = {};    // fills the right half of the picture, the camera the left
  std::optional<std::string> inset = {};     // a small picture in a corner
  std::optional<PictureCorner> corner = {};  // of the inset; where it covers least of what is done when absent
};

struct Snapshot;
struct ViewDefinition;

/// What is shown at a moment.
struct Shot {
  CameraDefinition camera = {};
  std::optional<CameraDefinition> beside = {};
  std::optional<CameraDefinition> inset = {};
  PictureCorner corner = PictureCorner::kUpperRight;
  std::shared_ptr<const Snapshot> beside_snapshot = {};    // what `beside` sees; null: what the others see
  std::shared_ptr<const ViewDefinition> beside_view = {};  // the light and look there; null: those of the others
};

}  // namespace thinwall

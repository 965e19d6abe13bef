#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/camera/CameraDefinition.hpp"
#include "renderer/look/DataView.hpp"
#include "renderer/look/Ground.hpp"
#include "renderer/look/TissueLook.hpp"
#include "renderer/snapshot/Snapshot.hpp"
#include "renderer/wound/DrawnTopology.hpp"

namespace thinwall {

struct LightsDefinition {
  double key = 1;                        // strength of the key light, which casts the shadow
  double fill = 1;                       // strength of the fill light
  double environment = 1;                // strength of the light from all around
  double environment_contrast = 1;       // 0 to 1: from the same light from everywhere to a studio's ceiling and lamps
  std::optional<Double3> key_direction;  // from the scene to the key light
  double endoscope = 0;  // strength of a lamp beside the lens; above zero it shines instead of key and fill light
};

struct LookDefinition {
  Double3 background = {0.055, 0.065, 0.08};  // sRGB, 0 to 1
  bool floor = true;                          // whether anything lies below the scene
  std::optional<Ground> ground = {};          // what, in the open; as of ground_below() when absent
  std::map<std::string, TissueLook> bodies;   // by name; others have the default look
  std::optional<DataView> data = {};          // what colours show of walls instead of their tissue; with both ends
  bool mesh = false;                          // whether the edges of the triangles are drawn, those of cuts stronger
  bool flat_triangles = false;                // whether round walls are drawn as the mesh has them
};

/// In the open: sheets of tissue are seen as in an operation, unless their numbers or their mesh are shown.
inline Ground ground_below(const LookDefinition& look, bool has_sheet) {
  return look.ground.value_or(has_sheet && !look.data && !look.mesh ? Ground::kDrape : Ground::kFloor);
}

/// Numbers and edges of the mesh are shown as they are; everything else has curves for lips.
inline DrawnEdges drawn_edges(const LookDefinition& look) {
  if (look.data || look.mesh) return DrawnEdges::kStraight;
  return look.flat_triangles ? DrawnEdges::kCurvedLips : DrawnEdges::kCurves;
}

/// How much is done for a picture: draft without shadow and anti-aliasing; record with shadow and smoothed outlines,
/// made to be fast without graphics hardware; final moreover with finer shadows, and five samples where pixels differ.
enum class Tier { kDraft, kRecord, kFinal };

/// A part of a wall that is marked: tinted, with a ring around it.
struct HighlightDefinition {
  std::string body = {};
  Double3 center = {0, 0, 0};          // metres, on the stress-free surface
  double radius = 0.005;               // metres, of the ball of the stress-free shape that is marked
  Double3 color = {0.40, 0.82, 0.92};  // sRGB, 0 to 1
  double begin = 0;                    // seconds, from when it is shown
  double end = 1e300;                  // seconds, until when
};

struct TakeComparison;

/// All that a picture depends on besides the snapshot.
struct ViewDefinition {
  CameraDefinition camera;  // also decides where lamps in the open stand
  LightsDefinition lights;
  LookDefinition look;
  std::map<std::string, CameraDefinition> cameras = {};  // more of them, by name
  std::vector<CameraCut> cuts = {};                      // ascending in time
  std::vector<HighlightDefinition> highlights = {};
  std::shared_ptr<const TakeComparison> comparison = {};  // null: one take fills the picture
};

/// Two takes side by side.
struct TakeComparison {
  std::array<std::string, 2> captions = {};  // of the left and the right half
  ViewDefinition second = {};                // of the take in the right half
};

}  // namespace thinwall

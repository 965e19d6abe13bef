#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/body/BodyDefinition.hpp"
#include "engine/simulation/SimulationOptions.hpp"
#include "engine/tool/Tool.hpp"
#include "renderer/camera/View.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/overlay/OverlayChoice.hpp"
#include "studio/scenario/SourceLocation.hpp"
#include "studio/scenario/Teaching.hpp"
#include "studio/scenario/WallFields.hpp"

namespace thinwall {

/// Where a surface stands: turned about its own origin first, which is then brought to a place.
struct SurfacePlacement {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  // metres
  Eigen::AngleAxisd turned = Eigen::AngleAxisd::Identity();

  Eigen::Vector3d place_of(const Eigen::Vector3d& point) const { return at + turned * point; }
};

struct MeshFileSource {
  std::filesystem::path file = {};              // absolute or relative to the working directory
  double unit = 1;                              // metres per unit of the file
  bool repair = false;                          // mend what is safe to mend
  double edge_length = 0;                       // metres; above zero: remesh with edges of about this length
  std::optional<SurfacePlacement> placed = {};  // none: as the file has it
};

enum class Shape { kSphere, kHemisphere, kSemicylinder, kSheet, kDisc, kCylinder, kAnnulus, kStrip };

struct ShapeSource {
  Shape shape = Shape::kSphere;
  double radius = 0.02;                         // metres; disc, annulus: outer
  double inner_radius = 0.01;                   // metres; annulus
  bool slit = false;                            // annulus: cut open along +x
  double length = 0.04;                         // metres; semicylinder, cylinder, strip along y, sheet along y
  double width = 0.04;                          // metres; sheet, strip along x
  int triangles = 1280;                         // wanted number of wall triangles
  std::optional<SurfacePlacement> placed = {};  // none: about the origin
};

/// A load with how it changes.
struct LoadScenario {
  LoadDefinition load = {};
  std::vector<std::pair<double, double>> over = {};  // seconds and the part of the load; none: all of it, always
  SourceLocation location = {};
};

struct BodyScenario {
  std::string name = {};
  SourceLocation location = {};          // of the body's key
  SourceLocation surface_location = {};  // of its `surface`
  std::variant<MeshFileSource, ShapeSource> surface = {};
  WallModel model = WallModel::kMembrane;
  Field<double> thickness = {};  // metres
  double density = 1060;         // kg / metre^3, of the wall
  Material material = {};
  SourceLocation material_location = {};
  std::vector<ParameterField> parameter_fields = {};  // `material` has placeholders for these
  std::optional<Field<Eigen::Vector3d>> fibres = {};  // where the first axis of the law lies in the wall
  bool tension_field = false;
  Field<Prestretch> prestretch = {};            // in-plane stretch of the given surface over the rest shape
  std::optional<Field<double>> toughness = {};  // joule / metre^2; a wall without cannot be cut
  FluidDefinition fluid = {};
  std::vector<PronyTerm> viscosity = {};
  RayleighDamping damping = {};
  std::vector<FixedRegion> fixed = {};
  std::vector<LoadScenario> loads = {};
  std::vector<SourceLocation> fixed_locations = {};    // (fixed)
  std::vector<SourceLocation> chamber_locations = {};  // (chambers of `fluid`), of their points
};

enum class Ease { kLinear, kSmooth };

struct PalpateClip {
  std::string tool = {};
  std::string body = {};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();           // metres, a point of the line of approach
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // unit
  std::optional<Eigen::Vector3d> axis = {};               // y' of the tool frame, a direction
  double depth = 0;                                       // metres from first contact
  double speed = 0.01;                                    // metres / second
  double hold = 0;                                        // seconds
  double standoff = 0.005;                                // metres
  bool withdraw = true;
};

/// A needle that goes through the wall: the motion is that of a palpation.
struct PierceClip : PalpateClip {};

/// A blade that cuts along a path.
struct InciseClip {
  std::string tool = {};
  std::string body = {};
  std::vector<Eigen::Vector3d> path = {};           // (at least 2), metres, near the surface
  std::vector<SourceLocation> path_locations = {};  // (points of the path)
  std::optional<Eigen::Vector3d> direction = {};    // unit, along which points go to the surface; nearest when absent
  double reach = 0.01;                              // metres from a point to the surface at most
  double depth = 0;                                 // metres below the surface, along the inward normal
  double speed = 0.01;                              // metres / second
  double hold = 0;                                  // seconds at the end of the path
  double standoff = 0.005;                          // metres
  bool withdraw = true;
  bool marked = false;  // whether the path is drawn on the wall, which takes it along
};

struct MoveClip {
  std::string tool = {};
  std::optional<std::string> body = {};           // for readers alone: a tool touches each body in its way
  std::optional<Eigen::Vector3d> from = {};       // metres; where the tool is when absent
  Eigen::Vector3d to = Eigen::Vector3d::Zero();   // metres
  std::optional<Eigen::Vector3d> by = {};         // metres, from where it starts, instead of `to`
  std::optional<Eigen::Vector3d> direction = {};  // unit; that of the motion when absent
  std::optional<Eigen::Vector3d> axis = {};
  double duration = 1;  // seconds
  Ease ease = Ease::kSmooth;

  /// Metres.
  Eigen::Vector3d end_from(const Eigen::Vector3d& start) const { return by ? start + *by : to; }
};

/// Jaws that reach over a wall and close.
struct GraspClip {
  std::string tool = {};
  std::string body = {};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();           // metres, a point of the line of approach
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // unit
  std::optional<Eigen::Vector3d> axis = {};               // y' of the tool frame, a direction
  double depth = 0;                                       // metres beyond where the line of approach meets the wall
  double speed = 0.01;                                    // metres / second
  double standoff = 0.005;                                // metres
  double to = 0.0005;                                     // metres between the closed jaws
  double grip = 0;                                        // newton at which they stop; zero: they close all the way
  double duration = 1;                                    // seconds, of the closing
};

/// Jaws that open.
struct ReleaseClip {
  std::string tool = {};
  double duration = 0.5;  // seconds
};

/// Fluid filled in or taken out.
struct FillClip {
  std::string body = {};
  std::optional<std::string> chamber = {};  // the only one when absent
  double added = 0;                         // metres^3, less than zero when drained
  std::optional<double> pressure = {};      // pascal, to be reached, instead of `added`
  bool drains = false;                      // what its verb says
  double duration = 1;                      // seconds
};

struct WaitClip {
  double duration = 1;  // seconds
};

struct Clip {
  std::variant<PalpateClip, PierceClip, InciseClip, MoveClip, GraspClip, ReleaseClip, FillClip, WaitClip> action = {};
  SourceLocation location = {};
  int number = 1;                           // in the timeline, from 1
  std::optional<double> start = {};         // seconds; after the clip before it when absent
  std::optional<std::string> caption = {};  // shown while the clip lasts
  std::optional<std::string> chapter = {};  // title of a chapter that begins with the clip
};

/// A point of a wall whose motion is recorded.
struct RecordedPoint {
  std::string name = {};
  std::string body = {};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  // metres, near its stress-free position
};

/// What must come out of a run.
struct Expectation {
  std::string quantity = {};         // a word of expectation_words()
  std::string subject = {};          // the name of the tool, body or point
  std::string chamber = {};          // of the body; "" for the body itself
  std::optional<double> at = {};     // seconds
  std::optional<double> from = {};   // seconds
  std::optional<double> until = {};  // seconds
  double lowest = 0;                 // SI
  double highest = 0;                // SI
  SourceLocation location = {};
};

struct RecordOptions {
  ImageSize size = {};
  double frames_per_second = 30;
  bool video = true;
  Tier tier = Tier::kRecord;
  std::vector<RecordedPoint> points = {};  // in the order of the file
};

struct GoldenDefinition {
  double at = 0;     // seconds; of a video 0
  int video = 0;     // above zero: not a moment but the whole video, of which so many pictures are kept
  double max = 0;    // largest allowed difference, 8-bit levels
  double mean = 0;   // largest allowed mean difference, 8-bit levels
  double drift = 1;  // largest allowed change of a colour's mean level, relative to itself
  std::optional<double> failing = {};     // largest allowed fraction of pixels that fail
  int level = 0;                          // by which a pixel may differ without failing, 8-bit levels
  int shift = 0;                          // by which what it shows may lie elsewhere, pixels
  std::optional<double> similarity = {};  // least structural similarity (SSIM)
  std::optional<double> flip = {};        // largest mean of FLIP
  std::string why = {};
  SourceLocation location = {};
};

struct Scenario;

/// A second take that is shown beside the first.
struct ComparisonScenario {
  std::array<std::string, 2> captions = {};  // of the left and the right half
  std::shared_ptr<const Scenario> second = {};
};

/// Where the `position` of a camera is written, or that of one of its keyframes.
struct CameraPlace {
  std::string name = {};                     // of `cameras`; "" of `camera`
  std::optional<std::size_t> keyframe = {};  // its number, counted from 0
  SourceLocation location = {};
};

/// A checked scenario: every quantity in SI, every reference resolved, every value in range.
struct Scenario {
  std::filesystem::path file = {};
  std::string name = {};                   // the file's name without directory and extension
  std::string title = {};                  // the name when absent
  std::vector<BodyScenario> bodies = {};   // in the order of the file
  std::vector<ToolDefinition> tools = {};  // in the order of the file
  std::vector<Clip> timeline = {};
  SimulationOptions simulation = {};
  ViewDefinition view = {};
  std::vector<CameraPlace> camera_places = {};  // all that are written
  OverlayChoice overlays = {};
  Teaching teaching = {};
  RecordOptions record = {};
  std::optional<ComparisonScenario> comparison = {};
  std::vector<GoldenDefinition> goldens = {};
  std::vector<Expectation> expectations = {};
  std::vector<std::string> warnings = {};  // what a user should know: `file:line:column: warning: message`
  std::string resolved =
      {};  // the whole scenario as JSON text with parameters and defaults filled in, keys in schema order
};

}  // namespace thinwall

#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/cutting/Cut.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/equilibrium/ShaftContact.hpp"
#include "engine/tool/FirstContact.hpp"
#include "engine/tool/Tool.hpp"

namespace thinwall {

/// Part of a needle's cone from the tip on, on which a wall no longer lies on it: it is too thin there to be felt.
inline constexpr double kNeedleTip = 0.1;

/// A hole that a needle has made.
struct Puncture {
  std::optional<int> tool = {};         // that is in it, or so near that the wall around it must still be let be
  double spread = 1;                    // part of the needle's radius by which it is spread
  double reach = 0;                     // metres, rest: the wall this near is free on the needle
  std::vector<ShaftPoint> points = {};  // its lips
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // newton, on the needle
  double due = 0;   // joule, that the needle pays for a slit in a wall that is held, while its cone spreads it
  double paid = 0;  // part of that

  /// Whether the needle is in it and lets nothing through.
  bool is_sealed() const;
};

/// How hard a tool has pressed since it touched last.
struct Pressing {
  double work = 0;       // joule, by the tool on the wall
  double awaited = 0;    // joule, before which no puncture by a needle can be worth its cost
  bool recedes = false;  // whether the tool has gone back in the last step
};

/// A wall that has given way.
struct Rupture {
  Cut cut;
  double released = 0;  // joule, by wall, fluid and weight
  double cost = 0;      // joule, of the new cut area
};

/// Where the line of a needle's axis meets a triangle.
struct AxisMeeting {
  Eigen::Vector3d weights;  // of the corners
  double ahead = 0;         // metres before the tip, negative behind it
};

/// Nothing where it passes beside the triangle or lies in its plane.
std::optional<AxisMeeting> where_axis_meets(const std::array<Eigen::Vector3d, 3>& corners, const ToolPose& pose);

/// Where a needle's point is on the wall: where its axis meets it nearest to the tip, within two radii. Nothing where
/// it does not, or where `is_free` says that the wall there is on its shaft already. `is_free`: (triangles).
std::optional<SurfacePoint> pressed_place(const BodyModel& model, const Eigen::VectorXd& position, const ToolPose& pose,
                                          double radius, const std::vector<char>& is_free);

/// Goes through slits of a needle's width around a place, on the rest shape, until `fits` takes one; false where it
/// takes none. First along y' of the needle, then along x'; where cuts or borders leave no room for either, beside the
/// place, by two radii at most, where the wall is whole around them.
bool try_slits(const BodyModel& model, const SurfacePoint& place, const ToolPose& pose, double radius,
               const std::function<bool(const CutPath&)>& fits);

/// The lips of a slit on the shaft that made it. `model`: as cut.
Puncture puncture_of(const BodyModel& model, const Cut& slit, int tool, const ToolPose& pose, double radius);

/// Whether needles that are in punctures keep an opening shut.
bool is_shut(const BodyModel& model, std::span<const Puncture> punctures, int opening);

/// The triangles around a puncture that are free on the needle in it are marked. `marks`: (triangles).
void mark_free(const BodyModel& model, const Puncture& puncture, std::vector<char>& marks);

/// Whether the wall is free on a needle, (triangles).
std::vector<char> free_triangles(const BodyModel& model, std::span<const Puncture> punctures, int tool);

}  // namespace thinwall

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "renderer/snapshot/CarriedSurface.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {
namespace {

double blend(double earlier, double later, double weight) {
  // What stays as it is does so to the last bit: a tool that is smaller by a rounding might be drawn otherwise.
  if (earlier == later) return earlier;
  // At weight 1 this gives the later value to the last bit, which earlier + weight * (later - earlier) does not.
  return (1 - weight) * earlier + weight * later;
}

Double3 blend(const Double3& earlier, const Double3& later, double weight) {
  return {blend(earlier[0], later[0], weight), blend(earlier[1], later[1], weight),
          blend(earlier[2], later[2], weight)};
}

/// Blended component by component and brought back to length one; opposite directions keep the earlier one.
Double3 blend_direction(const Double3& earlier, const Double3& later, double weight) {
  if (earlier == later) return earlier;
  const Double3 mean = blend(earlier, later, weight);
  const double length = std::sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
  if (length < 1e-9) return earlier;
  return {mean[0] / length, mean[1] / length, mean[2] / length};
}

void blend(std::vector<float>& values, const std::vector<float>& later, double weight) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(blend(values[i], later[i], weight));
}

void require(bool equal, const std::string& what) {
  if (!equal) throw std::invalid_argument("snapshots of unequal layout cannot be interpolated: " + what);
}

void blend(SnapshotSurface& surface, const SnapshotSurface& later, double weight) {
  require(surface.body == later.body, "body '" + surface.body + "' is followed by '" + later.body + "'");
  if (surface.topology != later.topology) {
    if (weight == 0) return;
    const std::size_t vertices = surface.topology->rest_positions.size();
    require(later.topology->rest_positions.size() >= vertices, "body '" + surface.body + "' loses vertices");
    surface = carried_over(surface, later);
  }
  require(surface.positions.size() == later.positions.size(), "the vertices of body '" + surface.body + "'");
  require(surface.fields.size() == later.fields.size(), "the fields of body '" + surface.body + "'");
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      surface.positions[i][axis] =
          static_cast<float>(blend(surface.positions[i][axis], later.positions[i][axis], weight));
    }
  }
  for (std::size_t i = 0; i < surface.fields.size(); ++i) {
    SnapshotField& field = surface.fields[i];
    const SnapshotField& next = later.fields[i];
    require(field.name == next.name && field.location == next.location && field.values.size() == next.values.size(),
            "field '" + field.name + "' of body '" + surface.body + "'");
    blend(field.values, next.values, weight);
  }
}

void blend(SnapshotTool& tool, const SnapshotTool& later, double weight) {
  require(tool.name == later.name && tool.kind == later.kind, "tool '" + tool.name + "'");
  tool.radius = blend(tool.radius, later.radius, weight);
  tool.length = blend(tool.length, later.length, weight);
  tool.width = blend(tool.width, later.width, weight);
  tool.thickness = blend(tool.thickness, later.thickness, weight);
  tool.opening = blend(tool.opening, later.opening, weight);
  tool.tip = blend(tool.tip, later.tip, weight);
  tool.direction = blend_direction(tool.direction, later.direction, weight);
  tool.axis = blend_direction(tool.axis, later.axis, weight);
  tool.depth = blend(tool.depth, later.depth, weight);
  tool.force = blend(tool.force, later.force, weight);
}

}  // namespace

Snapshot interpolate(const Snapshot& earlier, const Snapshot& later, double time) {
  const double span = later.time - earlier.time;
  const double weight = span > 0 ? std::clamp((time - earlier.time) / span, 0.0, 1.0) : 0.0;
  require(earlier.surfaces.size() == later.surfaces.size(), "the number of surfaces");
  require(earlier.tools.size() == later.tools.size(), "the number of tools");
  require(earlier.scalars.size() == later.scalars.size(), "the number of scalars");

  Snapshot result = earlier;
  result.time = blend(earlier.time, later.time, weight);
  for (std::size_t i = 0; i < result.surfaces.size(); ++i) blend(result.surfaces[i], later.surfaces[i], weight);
  for (std::size_t i = 0; i < result.tools.size(); ++i) {
    blend(result.tools[i], later.tools[i], weight);
    if (weight > 0.5) result.tools[i].phase = later.tools[i].phase;
  }
  for (std::size_t i = 0; i < result.scalars.size(); ++i) {
    require(result.scalars[i].name == later.scalars[i].name, "scalar '" + result.scalars[i].name + "'");
    result.scalars[i].value = blend(earlier.scalars[i].value, later.scalars[i].value, weight);
  }
  return result;
}

}  // namespace thinwall

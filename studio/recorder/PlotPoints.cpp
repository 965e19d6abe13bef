#include "studio/recorder/PlotPoints.hpp"

#include <cstddef>

namespace thinwall {
namespace {

EnergyPoint energies_of(const StepRecord& record) {
  EnergyPoint point{.time = record.time};
  for (const BodyRecord& body : record.bodies) {
    point.stored += body.elastic + body.bending + body.kinetic + body.fluid + body.gravity + body.contact;
    point.friction += body.friction;
    point.fracture += body.fracture;
    point.viscous += body.viscous;
    point.leak += body.leak;
    point.jump += body.jump;
    point.numerical += body.numerical;
    point.tool_work += body.tool_work;
    point.script_work += body.script_work;
  }
  return point;
}

}  // namespace

void PlotPoints::add(const StepRecord& record) {
  if (!energies_.empty() && record.time <= energies_.back().time) return;
  energies_.push_back(energies_of(record));
  forces_.resize(record.tools.size());
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    const ToolRecord& tool = record.tools[i];
    forces_[i].tool = tool.tool;
    forces_[i].points.push_back({.time = record.time,
                                 .force = {tool.force.x(), tool.force.y(), tool.force.z()},
                                 .depth = tool.depth,
                                 .phase = tool.phase});
  }
}

std::vector<ToolForces> compared_forces(const PlotPoints& first, const PlotPoints& second,
                                        const std::array<std::string, 2>& captions) {
  std::vector<ToolForces> all;
  const std::array takes{&first, &second};
  for (std::size_t take = 0; take < takes.size(); ++take) {
    for (ToolForces tool : takes[take]->forces()) {
      const bool is_alone = takes[take]->forces().size() == 1;
      tool.tool = is_alone ? captions[take] : tool.tool + ", " + captions[take];
      all.push_back(std::move(tool));
    }
  }
  return all;
}

}  // namespace thinwall

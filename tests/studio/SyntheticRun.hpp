#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/SimulationFailure.hpp"
#include "studio/record/Moment.hpp"

namespace thinwall {

/// A stand-in for a simulation: a sheet that a probe dents and releases, given by formulas, so that recorder, takes and
/// goldens are tested without an engine.
struct SyntheticRunOptions {
  double time_step = 0.005;  // seconds
  std::size_t steps = 41;    // moments, the one at time zero included
  std::size_t side = 9;      // vertices along an edge of the sheet
  double depth = 0.004;      // metres, largest
  std::size_t fail_at = 0;   // the step that cannot be saved; 0: none
  bool waits = false;        // whether there is a second tool, which no clip drives
};

class SyntheticRun final : public MomentSource {
 public:
  explicit SyntheticRun(SyntheticRunOptions options = {}) : options_(options), topology_(make_topology()) {}

  std::optional<Moment> next() override {
    if (step_ == options_.steps) return std::nullopt;
    if (options_.fail_at > 0 && step_ == options_.fail_at) {
      throw SimulationFailure("step " + std::to_string(step_) + " cannot be saved");
    }
    return moment(step_++);
  }
  std::vector<std::string> warnings() const override { return {"the sheet is a formula"}; }
  /// Differs from step to step and from depth to depth.
  std::string state_digest() const override {
    const std::string number =
        std::to_string(step_ * 100'000 + static_cast<std::size_t>(std::lround(options_.depth * 1e6)));
    return std::string(32 - number.size(), '0') + number;
  }

  double duration() const { return static_cast<double>(options_.steps - 1) * options_.time_step; }

  Moment moment(std::size_t step) const {
    const double time = static_cast<double>(step) * options_.time_step;
    const double dent = options_.depth * std::pow(std::sin(M_PI * time / duration()), 2);
    Moment moment;
    moment.planned_duration = duration();
    moment.captions = {{0, duration() / 2, "Pressing"}, {duration() / 2, duration(), "Releasing"}};
    moment.chapters = {{0, duration(), "Palpation"}};
    moment.snapshot = {.time = time, .surfaces = {surface(dent)}, .tools = {tool(dent)}, .scalars = {}};
    moment.snapshot.scalars = {{.name = "organ.pressure", .unit = "Pa", .value = 1e5 * dent}};
    moment.record = record(time, dent);
    if (options_.waits) {
      moment.snapshot.tools.push_back({.name = "needle", .tip = {0, 0, 0.01}, .phase = "idle"});
      moment.record.tools.push_back({.tool = "needle", .phase = "idle"});
    }
    return moment;
  }

 private:
  std::shared_ptr<const SnapshotTopology> make_topology() const {
    auto topology = std::make_shared<SnapshotTopology>();
    const auto side = static_cast<std::uint32_t>(options_.side);
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const float spacing = 0.04F / static_cast<float>(side - 1);
      const std::uint32_t row = i / side;
      topology->rest_positions.push_back(
          {static_cast<float>(i % side) * spacing - 0.02F, static_cast<float>(row) * spacing - 0.02F, 0});
    }
    for (std::uint32_t row = 0; row + 1 < side; ++row) {
      for (std::uint32_t column = 0; column + 1 < side; ++column) {
        const std::uint32_t corner = row * side + column;
        topology->triangles.push_back({corner, corner + 1, corner + side});
        topology->triangles.push_back({corner + 1, corner + side + 1, corner + side});
      }
    }
    topology->thickness.assign(topology->triangles.size(), 0.001F);
    return topology;
  }

  SnapshotSurface surface(double dent) const {
    SnapshotSurface surface{
        .body = "organ", .topology = topology_, .positions = topology_->rest_positions, .fields = {}};
    SnapshotField stretch{.name = "stretch", .unit = "", .location = FieldLocation::kVertex, .values = {}};
    for (Float3& p : surface.positions) {
      const double radius_squared = static_cast<double>(p[0]) * p[0] + static_cast<double>(p[1]) * p[1];
      p[2] = static_cast<float>(-dent * std::exp(-radius_squared / 1e-4));
      stretch.values.push_back(1 - 50 * p[2]);
    }
    surface.fields.push_back(std::move(stretch));
    return surface;
  }

  static SnapshotTool tool(double dent) {
    return {.name = "probe",
            .kind = SnapshotToolKind::kPoint,
            .tip = {0, 0, -dent},
            .phase = dent > 0 ? "contact" : "idle",
            .depth = dent,
            .force = {0, 0, 100 * dent}};
  }

  static StepRecord record(double time, double dent) {
    ToolRecord probe{.tool = "probe", .phase = dent > 0 ? "contact" : "idle"};
    probe.position.z() = -dent;
    probe.depth = dent;
    probe.force.z() = 100 * dent;
    BodyRecord organ{.body = "organ", .volume = 1e-5 - dent * 1e-6, .fluid_volume = 1e-5, .pressure = 1e5 * dent};
    organ.newton_iterations = 3;
    organ.residual = 1.0 / 3;
    return {.time = time, .tools = {probe}, .bodies = {organ}};
  }

  SyntheticRunOptions options_;
  std::shared_ptr<const SnapshotTopology> topology_;
  std::size_t step_ = 0;
};

}  // namespace thinwall

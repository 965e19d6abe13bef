// Bodies drawn at random: shape, membrane or shell, law, fluid, tool, friction, speed, step, gravity and what is done
// to them. None may fail, pass through itself, or leave its books of energy open. Each is a function of the seed and
// its number alone.
//
// With --open each has an opening through which its contents run out for half a second, with air coming in.
//
// usage: random_bodies [--open] [--count N] [--seed S] [--only K]

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>

#include "engine/mesh/Shapes.hpp"
#include "engine/simulation/SimulationFailure.hpp"
#include "tests/engine/contact/SurfaceIntersections.hpp"
#include "tests/engine/simulation/OpenBodies.hpp"
#include "tests/engine/simulation/RandomMaterials.hpp"
#include "tests/engine/simulation/RandomNumbers.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

enum class Treatment { kPalpate, kDrain, kInflate, kLeave };

struct Recipe {
  BodyDefinition body;
  ToolDefinition tool;
  SimulationOptions options;
  Treatment treatment = Treatment::kPalpate;
  Eigen::Vector3d aim = Eigen::Vector3d::Zero();  // metres, beside the axis
  double depth = 0;                               // metres
  double lowest_tip = -1;                         // metres, above what the body is held by, with room for its wall
  double speed = 0;                               // metres / second
  double filling = 1;                             // of the fluid volume, drained or inflated to
  int steps = 20;
  std::string kind, words;
};

class Drawer : RandomNumbers {
 public:
  Drawer(unsigned seed, unsigned number, bool open) : RandomNumbers(seed, number), open_(open) {}

  Recipe draw() {
    Recipe recipe;
    draw_body(recipe);
    draw_fluid(recipe);
    draw_tool(recipe);
    if (open_) draw_opening(recipe);
    words_ << ", " << (recipe.options.analysis == Analysis::kDynamic ? "dynamic" : "quasi-static") << ", step "
           << recipe.options.time_step * 1e3 << " ms";
    if (recipe.options.gravity.norm() > 0) words_ << ", gravity " << recipe.options.gravity.transpose() << " m/s^2";
    recipe.words = words_.str();
    return recipe;
  }

 private:
  void draw_body(Recipe& recipe) {
    static constexpr const char* kShapes[] = {"sphere", "hemisphere", "semicylinder", "cylinder", "sheet"};
    shape_ = pick(open_ ? 4 : 5);
    triangles_ = 60 + pick(240);
    modulus_ = between(5e3, 100e3);
    thickness_ = between(0.3e-3, 2e-3);
    const SurfaceMesh mesh = shape_ == 0   ? make_sphere(kRadius, triangles_)
                             : shape_ == 1 ? make_hemisphere(kRadius, triangles_)
                             : shape_ == 2 ? make_semicylinder(kRadius, 30e-3, triangles_)
                             : shape_ == 3 ? make_cylinder(kRadius, 40e-3, triangles_)
                                           : make_sheet(40e-3, 40e-3, triangles_);
    const Material material = random_material(modulus_, engine);
    recipe.body = make_body(mesh, thickness_, material);
    if (shape_ == 1 || shape_ == 2) recipe.body.fixed.push_back(fixed_group("base"));
    if (shape_ == 2 || shape_ == 3) recipe.body.fixed.push_back(fixed_group("ends"));
    if (shape_ == 4) {
      recipe.body.fixed.push_back({.region = BoundaryRegion{}});
      const double stretch = between(1.05, 1.3);
      recipe.body.prestretch = {{.first = stretch, .second = stretch}};
    }
    // A sphere lies free, on a bed that holds its lower part, or hangs from its top.
    if (shape_ == 0 && pick(3) > 0) {
      recipe.body.fixed.push_back({.region = BelowRegion{.axis = 2, .at = between(-0.8, -0.3) * kRadius}});
      in_bed_ = true;
    }
    if (pick(4) == 0) recipe.body.model = WallModel::kShell;
    if (pick(4) == 0) recipe.body.viscosity = {{.fraction = between(0.1, 0.6), .time = between(0.02, 0.5)}};
    recipe.options.analysis = pick(2) == 0 ? Analysis::kQuasiStatic : Analysis::kDynamic;
    recipe.options.time_step = between(2e-3, 20e-3);
    const bool held = !recipe.body.fixed.empty();
    // A wall that cannot hold the fluid's weight bursts as a balloon does: no equilibrium is there to be found.
    const double weight = 1010 * 9.81 * 2 * kRadius;  // pascal, at the bottom
    const bool bears = shape_ == 4 || weight < 0.6 * burst_pressure();
    if (held && bears && pick(2) == 0) recipe.options.gravity = {0, 0, -9.81};
    recipe.kind = kShapes[shape_];
    words_ << kShapes[shape_] << " of " << mesh.triangles.size() << " triangles, " << material.law->name;
    for (const double parameter : material.parameters) words_ << " " << parameter;
    words_ << ", " << thickness_ * 1e3 << " mm thick";
    if (recipe.body.model == WallModel::kShell) words_ << ", shell";
    if (!recipe.body.prestretch.empty()) words_ << ", prestretched by " << recipe.body.prestretch[0].first;
    if (!recipe.body.viscosity.empty()) words_ << ", viscous " << recipe.body.viscosity[0].fraction;
  }

  void draw_fluid(Recipe& recipe) {
    FluidDefinition& fluid = recipe.body.fluid;
    static constexpr const char* kFluids[] = {"incompressible", "compressible", "no fluid"};
    const int kind = shape_ == 4 ? 2 : open_ ? pick(2) : pick(5) % 3;
    fluid.kind = kind == 0 ? FluidKind::kIncompressible : kind == 1 ? FluidKind::kCompressible : FluidKind::kNone;
    fluid.bulk_modulus = between(20e3, 500e3);
    // Up to a third of what a balloon of that wall holds.
    const double pressure = pick(4) == 0 ? 0 : between(0.02, 0.33) * burst_pressure();
    if (kind < 2) fluid.initial_pressure = pressure;
    words_ << ", " << kFluids[kind];
    if (kind < 2) words_ << " at " << pressure << " Pa";
    if (kind == 1) words_ << ", bulk modulus " << fluid.bulk_modulus << " Pa";
    const int treatment = kind == 2 ? 0 : pick(4);
    if (open_ && treatment > 1) {
      recipe.treatment = Treatment::kLeave;
      recipe.kind += " left alone";
    } else if (!open_ && treatment == 1) {
      recipe.treatment = Treatment::kDrain;
      recipe.filling = between(0.15, 0.95);
      recipe.kind += " drained";
      words_ << ", drained to " << recipe.filling;
    } else if (!open_ && treatment == 2) {
      recipe.treatment = Treatment::kInflate;
      recipe.filling = between(1.02, 1.4);
      recipe.kind += " inflated";
      words_ << ", inflated to " << recipe.filling;
    } else {
      recipe.kind += " palpated";
    }
  }

  void draw_tool(Recipe& recipe) {
    const int tool = pick(6);
    recipe.tool = tool == 0   ? point_tool()
                  : tool == 1 ? line_tool(between(5e-3, 25e-3))
                              : sphere_tool(between(2e-3, 10e-3));
    if (tool > 2) shape_solid(tool, recipe.tool);
    if (tool > 1 && pick(2) == 0) recipe.tool.friction = between(0.05, 0.6);
    if (recipe.treatment != Treatment::kPalpate) return;
    const double height = shape_ == 0 || shape_ == 3 ? 2 * kRadius : kRadius;
    recipe.aim = {between(-6e-3, 6e-3), between(-6e-3, 6e-3), 0};
    recipe.depth = between(0.05, deepest(tool, recipe.body.materials[0])) * height;
    recipe.speed = between(5e-3, 200e-3);
    recipe.steps = 10 + pick(25);
    if (shape_ == 1 || shape_ == 2) recipe.lowest_tip = kRoom;
    if (in_bed_) {
      // A tool within the ball that the bed is part of.
      const double room = kRadius - recipe.tool.radius - kRoom;
      const double across =
          recipe.tool.kind == ToolKind::kNeedle ? 0 : std::hypot(recipe.tool.length, recipe.tool.width);
      const double aside = recipe.aim.norm() + 0.5 * across;
      recipe.lowest_tip = -recipe.tool.radius - std::sqrt(std::max(0.0, room * room - aside * aside));
    }
    words_ << ", " << recipe.tool.name << " (length " << recipe.tool.length * 1e3 << ", radius "
           << recipe.tool.radius * 1e3 << " mm, friction " << recipe.tool.friction << "), aim "
           << recipe.aim.head<2>().transpose() * 1e3 << " mm, depth " << recipe.depth * 1e3 << " mm at "
           << recipe.speed * 1e3 << " mm/s";
  }

  /// A hole somewhere on the upper part, clear of what is held and of caps.
  void draw_opening(Recipe& recipe) {
    const double around = between(-1, 1), along = between(-1, 1);
    Eigen::Vector3d point(0.7 * around, 0.7 * along, 1);
    if (shape_ == 2 || shape_ == 3) point = {around, 0, 1};
    point = kRadius * point.normalized();
    if (shape_ == 2 || shape_ == 3) point.y() = 5e-3 * along;
    const int rings = triangles_ > 200 && shape_ < 2 ? 1 + pick(2) : 1;
    open_at(point, rings, recipe.body);
    recipe.body.fluid.leaks = pick(8) > 0;
    recipe.kind = "open " + recipe.kind;
    words_ << ", open at " << point.transpose() * 1e3 << " mm over " << rings << " rings"
           << (recipe.body.fluid.leaks ? "" : ", a gel");
  }

  /// How deep a tool may go, as a part of the body's height: a ball as deep as there is room; a point or a line pulls a
  /// spike out of the wall. A line also prescribes the stretch between itself and a border that is held, which a law
  /// that stiffens without bound answers with forces that no wall bears, or not at all.
  static double deepest(int tool, const Material& material) {
    static constexpr std::array<std::string_view, 3> kStiffening = {"fung", "holzapfel", "gent"};
    if (tool == 1 && std::ranges::count(kStiffening, material.law->name) > 0) return 0.15;
    return tool == 2 ? 0.9 : tool == 5 ? 0.3 : 0.5;
  }

  /// A capsule, a plate or a needle.
  void shape_solid(int tool, ToolDefinition& solid) {
    solid.name = tool == 3 ? "capsule" : tool == 4 ? "plate" : "needle";
    solid.kind = tool == 3 ? ToolKind::kCapsule : tool == 4 ? ToolKind::kPlate : ToolKind::kNeedle;
    if (tool == 3) solid.length = between(4e-3, 20e-3);
    if (tool == 4) {
      solid.radius = 0;
      solid.length = between(5e-3, 15e-3);
      solid.width = between(5e-3, 15e-3);
      solid.thickness = between(2e-3, 4e-3);
    }
    if (tool == 5) {
      solid.radius = between(0.3e-3, 1.2e-3);
      solid.length = 60e-3;
    }
  }

  /// What a balloon of that wall holds, pascal, roughly.
  double burst_pressure() const { return 1.2 * modulus_ * thickness_ / kRadius; }

  static constexpr double kRadius = 20e-3;  // metres
  static constexpr double kRoom = 3e-3;     // metres, that two walls want between a tool and what holds them
  std::ostringstream words_;
  int shape_ = 0, triangles_ = 0;
  bool in_bed_ = false, open_ = false;
  double modulus_ = 0, thickness_ = 0;
};

/// How often the closed surface winds around a point: 0 outside, 1 inside; by solid angles (Van Oosterom and Strackee).
double winding(const Body& body, const Eigen::Vector3d& point) {
  const BodyModel& model = body.model();
  double angle = 0;
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    std::array<Eigen::Vector3d, 3> r = corners_of(model.surface[t], body.state().equilibrium.position);
    for (Eigen::Vector3d& corner : r) corner = (corner - point).normalized();
    const double size = 1 + r[0].dot(r[1]) + r[1].dot(r[2]) + r[2].dot(r[0]);
    angle += 2 * model.share[t] * std::atan2(r[0].dot(r[1].cross(r[2])), size);
  }
  return angle / (4 * std::numbers::pi);
}

struct Outcome {
  int steps = 0, halvings = 0, most_iterations = 0, intersections = 0, passed = 0;
  std::size_t most_folds = 0;
  double worst_imbalance = 0, largest_energy = 0;  // joule
  std::string failure;

  void note(const Body& body) {
    ++steps;
    halvings += body.report().halvings;
    most_iterations = std::max(most_iterations, body.report().newton_iterations);
    most_folds = std::max(most_folds, body.fold_count());
    const EnergyBooks& books = body.state().books;
    worst_imbalance = std::max(worst_imbalance, std::abs(books.imbalance()));
    for (const double term : {books.elastic, books.kinetic, books.fluid, books.gravity, books.contact, books.viscous,
                              books.leak, books.numerical, books.tool_work, books.script_work}) {
      largest_energy = std::max(largest_energy, std::abs(term));
    }
    if (body.model().has_open_chambers()) note_opening(body);
    intersections +=
        surface_intersections(body.model().definition.mesh.triangles, body.state().equilibrium.position).empty() ? 0
                                                                                                                 : 1;
  }
  void note_opening(const Body& body) {
    const BodyState& state = body.state();
    if (whole == 0) whole = state.fluid_volume[0] + state.leaked[0];
    lost = std::max(lost, std::abs((state.fluid_volume[0] + state.leaked[0]) / whole - 1));
    leaked = state.leaked[0] / whole;
    most_air = std::max(most_air, state.air[0] / whole);
    if (state.air[0] < 0 || state.leaked[0] < 0) failure = "air or leak below zero";
  }
  double whole = 0, lost = 0, leaked = 0, most_air = 0;  // metres^3, and parts of it
  double imbalance() const { return worst_imbalance / std::max(largest_energy, 1e-12); }
};

void palpate(const Recipe& recipe, Body& body, Outcome& outcome) {
  const ToolPose far = pose_at(recipe.aim + Eigen::Vector3d(0, 0, 80e-3));
  const auto travel = travel_to_contact(body.surface(), recipe.tool, far, far.direction);
  if (!travel) return;
  const Eigen::Vector3d start = far.tip + (*travel - 0.5e-3) * far.direction;
  Eigen::Vector3d deep = start + (0.5e-3 + recipe.depth) * far.direction;
  deep.z() = std::min(start.z(), std::max(deep.z(), recipe.lowest_tip));
  const double step_time = (recipe.depth + 0.5e-3) / recipe.speed / recipe.steps;
  // Through an opening a tool may go in and out.
  const bool closed = !body.model().has_open_chambers() &&
                      (!body.model().definition.mesh.cap_triangles.empty() || recipe.kind.starts_with("sphere"));
  const auto note = [&](const ToolPose& pose) {
    outcome.note(body);
    const bool ball = closed && recipe.tool.kind == ToolKind::kSphere;
    if (ball && winding(body, pose.tip - recipe.tool.radius * pose.direction) > 0.5) ++outcome.passed;
  };
  ToolPose pose = move(body, pose_at(start), deep, recipe.steps, step_time, note);
  pose = move(body, pose, deep, 3, recipe.options.time_step, note);
  move(body, pose, start, recipe.steps, step_time, note);
}

void fill(const Recipe& recipe, Body& body, Outcome& outcome) {
  const double part = (recipe.filling - 1) * body.state().fluid_volume[0] / recipe.steps;
  const ToolPose away = pose_at({0, 0, 1});
  const std::array<ToolPose, 1> poses = {away};
  for (int step = 0; step < recipe.steps; ++step) {
    body.advance(poses, poses, recipe.options.time_step,
                 {.load_factors = {}, .fluids = {{.added = part, .pressure = {}}}});
    outcome.note(body);
  }
}

/// Nothing touches the body for half a second.
void leave(const Recipe& recipe, Body& body, Outcome& outcome) {
  const std::array<ToolPose, 1> poses = {pose_at({0, 0, 1})};
  const int steps = static_cast<int>(std::ceil(0.5 / recipe.options.time_step));
  for (int step = 0; step < steps; ++step) {
    body.advance(poses, poses, recipe.options.time_step);
    outcome.note(body);
  }
}

Outcome run(const Recipe& recipe) {
  Outcome outcome;
  try {
    Body body(recipe.body, {recipe.tool}, recipe.options);
    body.settle();
    if (recipe.treatment == Treatment::kPalpate) {
      palpate(recipe, body, outcome);
    } else if (recipe.treatment != Treatment::kLeave) {
      fill(recipe, body, outcome);
    }
    if (body.model().has_open_chambers()) leave(recipe, body, outcome);
    if (outcome.lost > 1e-9) outcome.failure = "fluid is lost";
    if (outcome.passed > 0) outcome.failure = "the ball passes through the wall";
    if (outcome.intersections > 0) outcome.failure = "the wall passes through itself";
    // Books that close to round-off show any term that is missing.
    if (outcome.imbalance() > 1e-6) outcome.failure = "the books are open by " + std::to_string(outcome.imbalance());
  } catch (const SimulationFailure& failure) {
    outcome.failure = failure.what();
  }
  return outcome;
}

struct Tally {
  int bodies = 0, failed = 0;
};

int run_all(unsigned seed, int first, int count, bool open) {
  std::map<std::string, Tally> tallies;
  Tally all;
  int steps = 0, halvings = 0, folded = 0;
  double worst_imbalance = 0, slowest = 0;
  for (int number = first; number < first + count; ++number) {
    const Recipe recipe = Drawer(seed, number, open).draw();
    const std::clock_t begin = std::clock();
    const Outcome outcome = run(recipe);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    slowest = std::max(slowest, seconds);
    Tally& tally = tallies[recipe.kind];
    for (Tally* each : {&tally, &all}) {
      ++each->bodies;
      each->failed += outcome.failure.empty() ? 0 : 1;
    }
    steps += outcome.steps;
    halvings += outcome.halvings;
    folded += outcome.most_folds > 0 ? 1 : 0;
    worst_imbalance = std::max(worst_imbalance, outcome.imbalance());
    if (!outcome.failure.empty()) {
      std::printf("FAILED %s--seed %u --only %d: %s\n  %s; after %d steps\n", open ? "--open " : "", seed, number,
                  outcome.failure.c_str(), recipe.words.c_str(), outcome.steps);
    } else if (outcome.halvings > 0 || seconds > 10) {
      std::printf("--only %d: %d halvings, up to %d iterations a step, %.1f s: %s\n", number, outcome.halvings,
                  outcome.most_iterations, seconds, recipe.words.c_str());
    }
    std::fflush(stdout);
  }
  for (const auto& [kind, tally] : tallies) {
    std::printf("%-24s %4d bodies, %d failed\n", kind.c_str(), tally.bodies, tally.failed);
  }
  std::printf(
      "seed %u: %d bodies from number %d on, %d failed; %d steps, %d halvings, %d bodies lay on themselves, "
      "largest imbalance of the books %.1e, slowest body %.1f s\n",
      seed, all.bodies, first, all.failed, steps, halvings, folded, worst_imbalance, slowest);
  return all.failed == 0 && all.bodies > 0 ? 0 : 1;
}

}  // namespace
}  // namespace thinwall

int main(int argc, char** argv) {
  unsigned seed = 1;
  int first = 0, count = 1000;
  bool open = false;
  for (int k = 1; k < argc; ++k) {
    open = open || std::strcmp(argv[k], "--open") == 0;
    if (k + 1 == argc) break;
    const int value = std::atoi(argv[k + 1]);
    if (std::strcmp(argv[k], "--seed") == 0) seed = static_cast<unsigned>(value);
    if (std::strcmp(argv[k], "--count") == 0) count = value;
    if (std::strcmp(argv[k], "--only") == 0) first = value, count = 1;
  }
  return thinwall::run_all(seed, first, count, open);
}

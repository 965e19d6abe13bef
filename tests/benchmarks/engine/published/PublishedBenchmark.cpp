// The published comparison: a hemisphere as a membrane around a fluid (64 triangles, 41 vertices) against the same
// solid of linear tetrahedra (328 vertices), with the same sparse solver, indentation and tolerance; then at twice,
// four and eight times the resolution. Operations are counted in two ways: by the solver's analysis, and by executing.

#include <fmt/format.h>
#include <malloc.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/LU>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/mesh/Shapes.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/overlay/ForcePlotImage.hpp"
#include "tests/benchmarks/engine/published/OperationCount.hpp"
#include "tests/benchmarks/engine/published/TetrahedralSolid.hpp"
#include "tests/engine/simulation/TestBodies.hpp"

namespace thinwall {
namespace {

constexpr double kRadius = 20e-3;         // metres
constexpr double kDepth = 2e-3;           // metres
constexpr int kSteps = 10;                // of the indentation
constexpr double kTolerance = 1e-9;       // residual over the largest single force, of both
constexpr double kPressure = 500;         // pascal, in the membrane
constexpr double kPoisson = 0.45;         // of the solid, whose modulus is found so that both end at the same force
constexpr double kMostCounted = 3e8;      // operations up to which the work is executed step by step to count them
constexpr double kMostFactorized = 2e12;  // operations up to which a matrix is factorised at all
constexpr int kMostPressed = 3000;        // vertices up to which the whole path is gone

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Least time of some turns, seconds.
double time_of(const std::function<void()>& work) {
  double least = INFINITY, spent = 0;
  for (int turn = 0; turn < 20 && (turn < 2 || spent < 0.5); ++turn) {
    const double begin = now();
    work();
    least = std::min(least, now() - begin);
    spent += now() - begin;
  }
  return least;
}

/// Memory that the program has asked for and holds, bytes.
double held_bytes() {
  const auto held = mallinfo2();
  return static_cast<double>(held.uordblks + held.hblkhd);
}

/// Of one model at one resolution. Operations; seconds.
struct Figures {
  int vertices = 0, elements = 0, unknowns = 0;
  double dense = 0;          // LU of all unknowns, 2/3 n^3
  double factorization = 0;  // by the solver's analysis
  double factorization_executed = NAN;
  double assembly_executed = NAN;
  double factor_seconds = NAN, assembly_seconds = NAN, path_seconds = NAN;
  double memory = NAN;  // bytes, of the solver's factor and what else the model takes
  int iterations = -1;  // of the whole path
  std::vector<ForcePoint> path = {};
};

double dense_operations(double unknowns) {
  return 2.0 / 3 * std::pow(unknowns, 3);
}

ForcePoint point_at(int step, double force) {
  return {.time = 0.01 * step, .force = {0, 0, force}, .depth = kDepth * step / kSteps, .phase = "press"};
}

Figures measure_membrane(int n, bool counts) {
  const double before = held_bytes();
  Body body(pressurised_hemisphere(4 * n * n, kPressure), {point_tool()}, quasi_static());
  body.settle();
  const BodyModel& model = body.model();
  Figures figures{.vertices = model.vertices(), .elements = model.triangles(), .unknowns = model.unknowns()};
  figures.dense = dense_operations(figures.unknowns);
  EquilibriumProblem problem;
  problem.fluids = {{.fluid_volume = body.state().fluid_volume[0]}};
  EquilibriumTerms terms;
  const auto assemble = [&] {
    evaluate(model, problem, body.state().equilibrium.position, body.state().equilibrium.pressure, true, terms);
  };
  assemble();
  SparseFactor factor(model.pattern);
  figures.factorization = factor.operations();
  std::vector<double> values = terms.values;
  for (const int entry : model.fixed_entries) values[entry] = 0;
  for (std::size_t k = 0; k < model.diagonal_entries.size(); ++k) {
    // Held, and stiff enough to be factorised without the border that makes the whole convex.
    values[model.diagonal_entries[k]] += model.wall_stiffness;
  }
  factor.factorize(values);
  figures.memory = held_bytes() - before;
  figures.assembly_seconds = time_of(assemble);
  figures.factor_seconds = time_of([&] { factor.factorize(values); });
  if (counts) {
    figures.assembly_executed = count_operations(assemble);
    if (figures.factorization < kMostCounted) {
      figures.factorization_executed = count_operations([&] { factor.factorize(values); });
    }
  }
  const double crown = body.state().equilibrium.position.reshaped(3, model.vertices()).row(2).maxCoeff();
  figures.iterations = 0;
  figures.path.push_back(point_at(0, 0));
  figures.path_seconds = 0;
  ToolPose pose = pose_at({0, 0, crown + 1e-9});
  for (int step = 1; step <= kSteps; ++step) {
    ToolPose next = pose;
    next.tip.z() = crown - kDepth * step / kSteps;
    const double begin = now();
    body.advance(std::vector{pose}, std::vector{next}, 0.01);
    figures.path_seconds += now() - begin;
    pose = next;
    figures.iterations += body.report().newton_iterations;
    figures.path.push_back(point_at(step, body.state().contacts[0].force.z()));
  }
  return figures;
}

/// `mu`: pascal.
Figures measure_solid(int n, double mu, bool counts) {
  const double before = held_bytes();
  const double lambda = 2 * mu * kPoisson / (1 - 2 * kPoisson);
  TetrahedralSolid solid(make_half_ball(kRadius, n), {.mu = mu, .lambda = lambda});
  Figures figures{.vertices = static_cast<int>(solid.mesh().vertices.size()),
                  .elements = static_cast<int>(solid.mesh().tetrahedra.size()),
                  .unknowns = solid.pattern().unknowns()};
  figures.dense = dense_operations(figures.unknowns);
  figures.factorization = solid.factor().operations();
  const Eigen::VectorXd rest = solid.position();
  figures.assembly_seconds = time_of([&] { solid.assemble(rest); });
  if (figures.factorization < kMostFactorized) {
    figures.factor_seconds = time_of([&] { solid.factorize(); });
    figures.memory = held_bytes() - before;
  }
  if (counts) {
    // Every element takes as many; a smaller solid takes less time to be executed step by step.
    TetrahedralSolid small(make_half_ball(kRadius, 2), {.mu = mu, .lambda = lambda});
    const Eigen::VectorXd small_rest = small.position();
    figures.assembly_executed = count_operations([&] { small.assemble(small_rest); }) * figures.elements /
                                static_cast<double>(small.mesh().tetrahedra.size());
    if (figures.factorization < kMostCounted) {
      figures.factorization_executed = count_operations([&] { solid.factorize(); });
    }
  }
  if (figures.vertices > kMostPressed) return figures;
  figures.path.push_back(point_at(0, 0));
  const double begin = now();
  figures.iterations = 0;
  for (int step = 1; step <= kSteps; ++step) {
    const int iterations = solid.press(kRadius - kDepth * step / kSteps, kTolerance);
    if (iterations < 0) {
      figures.iterations = -1;
      return figures;
    }
    figures.iterations += iterations;
    figures.path.push_back(point_at(step, solid.crown_force().z()));
  }
  figures.path_seconds = now() - begin;
  return figures;
}

std::string number(double value, double unit = 1) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value / unit) : "-";
}

/// All operations of the path, as far as known: each iteration assembles and factorises.
double path_operations(const Figures& figures) {
  return figures.iterations < 0 ? NAN : figures.iterations * (figures.factorization + figures.assembly_executed);
}

struct Row {
  const char* name;
  double (*of)(const Figures&);
  double unit;
};

const Row kRows[] = {
    {"vertices", [](const Figures& f) { return double(f.vertices); }, 1},
    {"elements", [](const Figures& f) { return double(f.elements); }, 1},
    {"unknowns", [](const Figures& f) { return double(f.unknowns); }, 1},
    {"dense LU of all unknowns, Mflop", [](const Figures& f) { return f.dense; }, 1e6},
    {"dense inversion (n^3), Mflop", [](const Figures& f) { return 1.5 * f.dense; }, 1e6},
    {"sparse factorisation, analysed, Mflop", [](const Figures& f) { return f.factorization; }, 1e6},
    {"sparse factorisation, executed, Mflop", [](const Figures& f) { return f.factorization_executed; }, 1e6},
    {"assembly, executed, Mflop", [](const Figures& f) { return f.assembly_executed; }, 1e6},
    {"whole path, Mflop", path_operations, 1e6},
    {"iterations of the path", [](const Figures& f) { return f.iterations < 0 ? NAN : double(f.iterations); }, 1},
    {"sparse factorisation, ms", [](const Figures& f) { return f.factor_seconds; }, 1e-3},
    {"assembly, ms", [](const Figures& f) { return f.assembly_seconds; }, 1e-3},
    {"whole path, ms", [](const Figures& f) { return f.path_seconds; }, 1e-3},
    {"memory, MB", [](const Figures& f) { return f.memory; }, 1e6},
};

void print_table(int resolution, const Figures& membrane, const Figures& solid) {
  fmt::print("\nresolution x{}\n{:<40}{:>12}{:>14}{:>12}\n", resolution, "", "membrane", "tetrahedra", "ratio");
  for (const Row& row : kRows) {
    const double one = row.of(membrane), other = row.of(solid);
    fmt::print("{:<40}{:>12}{:>14}{:>12}\n", row.name, number(one, row.unit), number(other, row.unit),
               number(other / one));
  }
}

nlohmann::ordered_json json_of(const Figures& figures) {
  nlohmann::ordered_json json;
  for (const Row& row : kRows) {
    const double value = row.of(figures) / row.unit;
    json[row.name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  }
  return json;
}

/// Operations of a dense LU by executing it, to hold the formula against.
void check_dense_count() {
  const int n = 60;
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) * n + Eigen::MatrixXd::Random(n, n);
  const double executed = count_operations([&] {
    const Eigen::PartialPivLU<Eigen::MatrixXd> factors(matrix);
    if (!std::isfinite(factors.matrixLU()(0, 0))) throw std::runtime_error("not factorised");
  });
  fmt::print("dense LU of {} unknowns: 2/3 n^3 = {:.0f} operations, executed {:.0f}\n", n, dense_operations(n),
             executed);
}

int run(const std::string& folder, int resolutions) {
  // The copy that executes step by step has one thread.
  const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
  fmt::print(stderr, "counting operations by executing them takes minutes\n");
  check_dense_count();
  std::fflush(stdout);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  double mu = 1e3;  // pascal
  for (int k = 0, n = 4, resolution = 1; k < resolutions; ++k, n *= 2, resolution *= 2) {
    const Figures membrane = measure_membrane(n, k < 2);
    if (k == 0) {
      const Figures trial = measure_solid(n, mu, false);
      mu *= membrane.path.back().force[2] / trial.path.back().force[2];
      fmt::print("solid: neo-Hookean, mu {:.4g} Pa, Poisson's ratio {}, so that both end at the same force\n", mu,
                 kPoisson);
    }
    const Figures solid = measure_solid(n, mu, k < 1);
    print_table(resolution, membrane, solid);
    json.push_back({{"resolution", resolution}, {"membrane", json_of(membrane)}, {"tetrahedra", json_of(solid)}});
    if (k > 0) continue;
    write_png(folder + "/force_displacement.png",
              force_plot_image("Indentation of a hemisphere",
                               {{.tool = fmt::format("membrane {}", membrane.vertices), .points = membrane.path},
                                {.tool = fmt::format("solid {}", solid.vertices), .points = solid.path}}));
  }
  std::ofstream(folder + "/published.json") << json.dump(2) << "\n";
  return 0;
}

}  // namespace
}  // namespace thinwall

int main(int count, char** arguments) {
  if (count < 2 || std::string(arguments[1]) == "--help") {
    fmt::print("usage: published_benchmark FOLDER [RESOLUTIONS]\nleaves published.json and force_displacement.png\n");
    return count < 2 ? 2 : 0;
  }
  return thinwall::run(arguments[1], count > 2 ? std::stoi(arguments[2]) : 4);
}

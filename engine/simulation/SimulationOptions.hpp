#pragma once

#include <Eigen/Core>
#include <functional>

namespace thinwall {

enum class Analysis { kDynamic, kQuasiStatic };

struct SimulationOptions {
  Analysis analysis = Analysis::kDynamic;
  double time_step = 0.005;                           // seconds
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // metres / second^2
  double step_error = 0;    // metres, allowed error of a step in dynamics, which is divided to keep it; 0: not judged
  double tolerance = 1e-9;  // residual force over the largest force
  // Whether a quasi-static step begins where the one before leads on to: for tools that go on as a hand does. Of
  // several equilibria another one may be found.
  bool extrapolates = false;
  int maximum_iterations = 60;  // Newton iterations before a step is halved
  int maximum_halvings = 10;    // how often in a row a step may be halved before the run fails
  // All Newton iterations of a step and its parts after which one that still cannot be solved fails the run. Steps that
  // come to an end have been seen to take some ten thousand.
  int maximum_step_iterations = 40'000;
  // Called before each iteration. It may throw to end a long solution; the body is not to be used after that.
  std::function<void()> between_iterations = {};
};

}  // namespace thinwall

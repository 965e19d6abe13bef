#pragma once

namespace thinwall {

enum class Analysis { kDynamic, kQuasiStatic };

struct SimulationOptions {
  Analysis analysis = Analysis::kDynamic;
  double time_step = 0.005;     // seconds
  double tolerance = 1e-9;      // residual force over the largest force
  int maximum_iterations = 60;  // Newton iterations before a step is halved
  int maximum_halvings = 10;    // how often a step may be halved before the run fails
};

}  // namespace thinwall

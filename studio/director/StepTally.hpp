#pragma once

#include <string>
#include <vector>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// What a run had to do to solve its steps, that its reader should know of.
class StepTally {
 public:
  /// Counts what one body's step took. `time`: seconds, at its end.
  void note(const std::string& body, const BodyStepReport& report, double time);

  /// A sentence for each thing that happened. `steps`: of the run.
  std::vector<std::string> warnings(long steps) const;

 private:
  struct Count {
    long steps = 0;
    double first = 0, last = 0;  // seconds
    std::string body;            // of the first

    void add(const std::string& body_of_step, double time);
  };
  Count divided_, slowed_, loose_, unstable_, held_, crumpled_, laborious_;
};

}  // namespace thinwall

#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/simulation/Body.hpp"

namespace thinwall {

/// Watches what the integrator spends of each body's energies, or gives, as books that close by it alone prove nothing.
class IntegratorEnergy {
 public:
  /// Takes in a body's books, after a step.
  void note(const Body& body, double time);

  /// The same. `none`: joule, up to which an energy is round-off. `time`: seconds, at the end of a step; the first are
  /// those before the first step.
  void note(const std::string& body, const EnergyBooks& books, double none, double time);

  /// A sentence for each body whose integrator has at any time taken or given more than a tenth of the most that any
  /// other term came to in the run, that of gravity counted from the start. By names. What helps depends on the
  /// analysis, and on whether there are tools to move more slowly.
  std::vector<std::string> warnings(Analysis analysis, bool has_tools) const;

 private:
  struct Watch {
    double gravity = 0;         // joule, in the first books
    double none = 0;            // joule
    double last = 0, most = 0;  // joule, the integrator's term: at last; where it was farthest from zero
    double largest = 0;         // joule, the most of any other term so far
    double jump = 0, at = 0;    // joule, most in one step; seconds, its end
  };
  std::map<std::string, Watch> watches_;
};

}  // namespace thinwall

#pragma once

#include <array>
#include <string>
#include <vector>

#include "renderer/overlay/EnergyPlotImage.hpp"
#include "renderer/overlay/ForcePlotImage.hpp"
#include "studio/record/StepRecord.hpp"

namespace thinwall {

/// What the plots of a recording show of its steps.
class PlotPoints {
 public:
  /// The next step, in order of time; one that is there already is passed over.
  void add(const StepRecord& record);

  const std::vector<ToolForces>& forces() const { return forces_; }       // (tools), each with a point per step
  const std::vector<EnergyPoint>& energies() const { return energies_; }  // (steps), of all bodies together

 private:
  std::vector<ToolForces> forces_;
  std::vector<EnergyPoint> energies_;
};

/// The forces of two takes that are compared, under the captions of their halves and, where there are several, the
/// names of the tools.
std::vector<ToolForces> compared_forces(const PlotPoints& first, const PlotPoints& second,
                                        const std::array<std::string, 2>& captions);

}  // namespace thinwall

#pragma once

#include <string>
#include <vector>

#include "renderer/image/Image.hpp"
#include "renderer/overlay/ForcePlotImage.hpp"

namespace thinwall {

/// The energies of all bodies at a time, joule. The books close: stored plus spent is the work put in.
struct EnergyPoint {
  double time = 0;    // seconds
  double stored = 0;  // in walls, fluids, motion, height and contacts
  double friction = 0;
  double fracture = 0;
  double viscous = 0;
  double leak = 0;       // pressure work and motion of fluid that left
  double jump = 0;       // where a wall gave way by more than its cut cost
  double numerical = 0;  // by the integrator
  double tool_work = 0;
  double script_work = 0;

  double spent() const { return friction + fracture + viscous + leak + jump + numerical; }
  double imbalance() const { return stored + spent() - tool_work - script_work; }
  double largest_term() const;
};

/// The page `energies.png`: where the work put in since time zero went, over the phases of each tool, and what the
/// integrator has spent and the books leave open, in per cent of the largest term so far. What never is more than a
/// thousandth of the largest curve is not drawn. All numbers must be finite; without any points the page says so.
/// `points`: ascending in time. Throws PictureFailure when the font is missing.
Image energy_plot_image(const std::string& title, const std::vector<EnergyPoint>& points,
                        const std::vector<ToolForces>& tools, ImageSize size = {1600, 900});

}  // namespace thinwall

#include "studio/commands/MisplacedNotes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "studio/commands/CameraPlaces.hpp"
#include "studio/recorder/FarPlaces.hpp"
#include "studio/scenario/LateTimes.hpp"

namespace thinwall {

std::vector<std::string> misplaced_notes(const Scenario& scenario, const Moment& first, double second_duration) {
  const double planned = first.planned_duration;
  std::vector<std::string> notes = late_times(scenario, planned);
  std::ranges::copy(far_places(scenario, first.snapshot), std::back_inserter(notes));
  std::ranges::copy(cameras_within_bodies(scenario, first.snapshot), std::back_inserter(notes));
  if (second_duration <= planned + scenario.simulation.time_step) return notes;
  notes.push_back(fmt::format(
      "the second take lasts {:.4g} s, and the pictures end with the first, planned for {:.4g} s: what it does later "
      "is in its records alone; let the first wait for it",
      second_duration, planned));
  return notes;
}

}  // namespace thinwall

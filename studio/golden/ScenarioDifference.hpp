#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace thinwall {

/// Which part of the way from a scenario to a picture a key of it belongs to.
enum class ScenarioStage {
  kPhysics,
  kLook,
  kOverlay,
  kTiming,      // which moment a frame of a video shows: freezes, slow motion, cards
  kSecondTake,  // a parameter of the take that this one is compared with: of its physics or its look
  kNone,
};

/// A value of a scenario that is not what it was.
struct ScenarioChange {
  ScenarioStage stage = ScenarioStage::kNone;
  std::string key;     // "bodies.organ.wall.thickness", "timeline[1].palpate.depth"
  std::string before;  // as a scenario has it, with its unit; empty when it is new
  std::string after;   // likewise; empty when it is gone
};

/// "bodies.organ.wall.thickness 1 mm instead of 0.8 mm"
std::string to_text(const ScenarioChange& change);

/// The first changes of some stages, one after the other: "lights.key 0.9 instead of 1 and 2 more". Empty when there
/// are none. What the second take has otherwise is listed with physics and with look: its state tells which it is.
std::string list_changes(const std::vector<ScenarioChange>& changes, std::initializer_list<ScenarioStage> stages);

/// What differs between two resolved scenarios (JSON texts), in order of their keys. A key that the format did not have
/// when one of them was resolved stands there with its default. Items that have come at the end of a list, or gone from
/// there, are a change each. Nothing when one of them is none.
std::vector<ScenarioChange> compare_scenarios(const std::string& before, const std::string& after);

}  // namespace thinwall

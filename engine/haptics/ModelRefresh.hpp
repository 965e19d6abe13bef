#pragma once

#include <functional>
#include <optional>

#include "engine/haptics/HandFollower.hpp"
#include "engine/haptics/LocalModel.hpp"
#include "engine/haptics/TripleBuffer.hpp"

namespace thinwall {

/// What a full solution gives.
struct FullAnswer {
  ToolResponse response;
  bool event = false;  // whether the wall was cut or pierced on the way there
};

/// Brings the body to where the hand is at that time, and tells what it feels there. Time goes on from call to call.
using FullSolver = std::function<FullAnswer(double time, const ToolPose& pose)>;

struct RefreshOptions {
  double reach = 0;         // metres, of a model
  double shortest_way = 0;  // metres, see LocalModelMaker
  double most_way = 0;   // metres, that the tool goes in a solution: a long one is solved in longer than two short ones
  double foresight = 0;  // seconds, most by which the hand's motion is foreseen, to where a solution will be ready
  double foreseen_way = 0;  // metres, most that it may be foreseen to go
};

/// The slow side of a haptic loop: a thread that solves fully for where the hand is, again and again, and leaves the
/// local model of each solution where the fast side finds it. Neither waits for the other.
class ModelRefresh {
 public:
  /// Begins with a model of where the hand is at time zero, found before the constructor returns.
  ModelRefresh(FullSolver solver, const HandState& begin, const RefreshOptions& options);

  // Of the fast side.
  void tell(const HandState& hand) { follower_->tell(hand); }
  bool has_newer() const { return models_.has_fresh(); }
  bool take_newer() { return models_.take(); }
  const LocalModel& model() const { return models_.front(); }
  bool has_failed() const { return follower_->has_failed(); }

  /// Waits for the solution under way, and throws what a solution threw.
  void finish() { follower_->finish(); }
  /// After `finish`.
  const RefreshFigures& figures() const { return figures_; }

 private:
  void refresh(const HandState& hand);

  FullSolver solver_;
  RefreshOptions options_;
  LocalModelMaker maker_;
  TripleBuffer<LocalModel> models_;
  RefreshFigures figures_;
  ToolPose reached_;                      // of the last solution
  double last_duration_ = 0;              // seconds
  double solved_until_ = 0;               // seconds
  std::optional<HandFollower> follower_;  // last, so that it ends first
};

}  // namespace thinwall

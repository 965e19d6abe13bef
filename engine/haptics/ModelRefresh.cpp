#include "engine/haptics/ModelRefresh.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/tool/PoseBetween.hpp"

namespace thinwall {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

ModelRefresh::ModelRefresh(FullSolver solver, const HandState& begin, const RefreshOptions& options)
    : solver_(std::move(solver)), options_(options), maker_(options.reach, options.shortest_way) {
  refresh(begin);
  models_.take();
  follower_.emplace([this](const HandState& hand) { refresh(hand); });
}

void ModelRefresh::refresh(const HandState& hand) {
  const Clock::time_point begin = Clock::now();
  // The solution is wanted when it is ready, not when it begins.
  double ahead = std::min(last_duration_, options_.foresight);
  const double speed = hand.velocity.norm();
  if (ahead * speed > options_.foreseen_way) ahead = options_.foreseen_way / speed;
  ToolPose pose = hand.pose;
  pose.tip += ahead * hand.velocity;
  const double way = (pose.tip - reached_.tip).norm();
  if (figures_.solutions > 0 && way > options_.most_way) pose = between(reached_, pose, options_.most_way / way);
  reached_ = pose;
  const double time = std::max(hand.time + ahead, solved_until_);
  const FullAnswer answer = solver_(time, pose);
  solved_until_ = time;
  maker_.make(answer.response, hand.time, answer.event, models_.back());
  models_.publish();
  last_duration_ = seconds_since(begin);
  figures_.note(last_duration_);
}

}  // namespace thinwall

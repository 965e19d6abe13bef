#include "studio/recorder/VideoClock.hpp"

#include <algorithm>
#include <set>

namespace thinwall {
namespace {

double speed_from(double time, const std::vector<SlowMotion>& slow_motions) {
  for (const SlowMotion& slow : slow_motions) {
    if (slow.begin <= time && time < slow.end) return slow.speed;
  }
  return 1;
}

double freeze_at(double time, const std::vector<Freeze>& freezes) {
  double duration = 0;
  for (const Freeze& freeze : freezes) {
    if (freeze.at == time) duration += freeze.duration;
  }
  return duration;
}

}  // namespace

VideoClock::VideoClock(const std::vector<Freeze>& freezes, const std::vector<SlowMotion>& slow_motions) {
  std::set<double> bends = {0};
  for (const Freeze& freeze : freezes) bends.insert(freeze.at);
  for (const SlowMotion& slow : slow_motions) bends.insert({slow.begin, slow.end});
  double video = 0;
  double before = 0;
  for (const double bend : bends) {
    if (!pieces_.empty()) video += (bend - before) / pieces_.back().speed;
    const double frozen = freeze_at(bend, freezes);
    if (frozen > 0) pieces_.push_back({video, bend, 0});
    video += frozen;
    pieces_.push_back({video, bend, speed_from(bend, slow_motions)});
    before = bend;
  }
}

VideoMoment VideoClock::at(double video_time) const {
  const auto next = std::ranges::find_if(pieces_, [&](const Piece& piece) { return piece.video > video_time; });
  const Piece& piece = next == pieces_.begin() ? pieces_.front() : *(next - 1);
  const double since = std::max(0.0, video_time - piece.video);
  double simulation = piece.simulation + piece.speed * since;
  // What rounding adds must not reach beyond the piece.
  if (next != pieces_.end()) simulation = std::min(simulation, next->simulation);
  return {.simulation = simulation, .speed = piece.speed, .held = piece.speed > 0 ? 0 : since};
}

double VideoClock::first_shown(double simulation_time) const {
  const auto next =
      std::ranges::find_if(pieces_, [&](const Piece& piece) { return piece.simulation >= simulation_time; });
  if (next == pieces_.begin()) return pieces_.front().video;
  const Piece& piece = *(next - 1);
  return piece.video + (simulation_time - piece.simulation) / piece.speed;
}

double VideoClock::last_shown(double simulation_time) const {
  const auto next =
      std::ranges::find_if(pieces_, [&](const Piece& piece) { return piece.simulation > simulation_time; });
  if (next == pieces_.begin()) return pieces_.front().video;
  const Piece& piece = *(next - 1);
  return piece.video + (simulation_time - piece.simulation) / piece.speed;
}

}  // namespace thinwall

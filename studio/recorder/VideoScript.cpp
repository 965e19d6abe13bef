#include "studio/recorder/VideoScript.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/snapshot/SameTime.hpp"

namespace thinwall {
namespace {

constexpr double kFade = 0.4;  // seconds

/// A title card is a freeze at the beginning.
std::vector<Freeze> with_title(std::vector<Freeze> freezes, const std::optional<CardScenario>& title) {
  if (title) freezes.push_back({.at = 0, .duration = title->duration});
  return freezes;
}

Card card_of(const CardScenario& card, double since_it_came_or_until_it_goes) {
  return {
      .title = card.title, .text = card.text, .opacity = std::clamp(since_it_came_or_until_it_goes / kFade, 0.0, 1.0)};
}

std::string badge_of(double speed) {
  if (speed == 1) return "";
  if (speed == 0) return "Paused";
  return fmt::format("{} \u00d7{:.3g}", speed < 1 ? "Slow motion" : "Time lapse", speed);
}

/// Title cards, which cover the badge, apart.
std::vector<double> speeds_of(const Teaching& teaching) {
  std::vector<double> speeds(teaching.freezes.size(), 0.0);
  for (const SlowMotion& slow : teaching.slow_motions) speeds.push_back(slow.speed);
  return speeds;
}

}  // namespace

VideoScript::VideoScript(const Teaching& teaching)
    : title_card_(teaching.title_card),
      end_card_(teaching.end_card),
      speeds_(speeds_of(teaching)),
      clock_(with_title(teaching.freezes, teaching.title_card), teaching.slow_motions) {}

std::optional<VideoCue> VideoScript::at(double video_time, std::optional<double> end) const {
  const VideoMoment moment = clock_.at(video_time);
  if (!end || moment.simulation <= *end + kSameTime) {
    const double left = title_card_ && moment.simulation <= 0 ? title_card_->duration - video_time : 0;
    if (left > 0) return VideoCue{.card = card_of(*title_card_, left)};
    return VideoCue{.simulation = moment.simulation, .badge = badge_of(moment.speed)};
  }
  const double since = video_time - clock_.last_shown(*end);
  if (!end_card_ || since >= end_card_->duration) return std::nullopt;
  return VideoCue{.simulation = *end, .card = card_of(*end_card_, since)};
}

std::vector<std::string> VideoScript::badges() const {
  std::vector<std::string> badges;
  for (const double speed : speeds_) {
    const std::string badge = badge_of(speed);
    if (!badge.empty() && std::ranges::find(badges, badge) == badges.end()) badges.push_back(badge);
  }
  return badges;
}

}  // namespace thinwall

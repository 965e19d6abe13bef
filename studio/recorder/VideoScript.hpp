#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/annotation/Card.hpp"
#include "studio/recorder/VideoClock.hpp"
#include "studio/scenario/Teaching.hpp"

namespace thinwall {

/// What a frame of a video shows.
struct VideoCue {
  double simulation = 0;   // seconds
  std::string badge = {};  // that the time does not run as it does
  std::optional<Card> card = {};
  friend bool operator==(const VideoCue&, const VideoCue&) = default;
};

/// Tells for each time of a video what is shown: freezes, slow motion, and cards before and after. Cards take 0.4 s to
/// come or go. A pure function of the teaching layer.
class VideoScript {
 public:
  explicit VideoScript(const Teaching& teaching);

  /// What is shown at `video_time` (seconds). `end` is the last moment of the simulation, where it is known already;
  /// nothing is shown when all is over then.
  std::optional<VideoCue> at(double video_time, std::optional<double> end = {}) const;

  /// All badges that frames have at some time, each once.
  std::vector<std::string> badges() const;

  const VideoClock& clock() const { return clock_; }
  double title_duration() const { return title_card_ ? title_card_->duration : 0; }  // seconds

 private:
  std::optional<CardScenario> title_card_;
  std::optional<CardScenario> end_card_;
  std::vector<double> speeds_;  // of freezes and slow motions
  VideoClock clock_;
};

}  // namespace thinwall

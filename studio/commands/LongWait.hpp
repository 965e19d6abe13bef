#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace thinwall {

/// Work of unknown length that shows no progress: says that it goes on after five seconds, and again each time that it
/// has taken twice as long.
class LongWait {
 public:
  using Tell = std::function<void(const std::string& note)>;
  using Clock = std::function<std::chrono::steady_clock::time_point()>;

  /// `doing`: "finding the equilibrium"; `advice`: what the sentence ends with
  LongWait(std::string doing, Tell tell, std::string advice = "", Clock clock = std::chrono::steady_clock::now);

  /// To be called now and then while the work goes on.
  void look();

 private:
  std::string doing_;
  Tell tell_;
  std::string advice_;
  Clock clock_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::seconds next_{5};
};

}  // namespace thinwall

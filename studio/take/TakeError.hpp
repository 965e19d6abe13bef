#pragma once

#include <stdexcept>
#include <string>

namespace thinwall {

/// A take that cannot be read: the message names the file, what is wrong with it, and the cure. Exit code 2.
class TakeError : public std::runtime_error {
 public:
  explicit TakeError(const std::string& problem) : TakeError(problem, "") {}
  /// The cure is that of a take which a run has left.
  TakeError(const std::string& problem, const std::string& cure)
      : std::runtime_error(cure.empty() ? problem : problem + "; " + cure), problem_(problem) {}

  /// Without the cure, for takes that are kept for something else.
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

}  // namespace thinwall

#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace thinwall {

// What the program's exit code says.
inline constexpr int kExitGood = 0;
inline constexpr int kExitRegression = 1;  // a comparison, expectation or regression failed
inline constexpr int kExitBadInput = 2;    // bad usage or bad input
inline constexpr int kExitSimulationFailed = 3;
inline constexpr int kExitNoPicture = 4;  // no picture or file could be made: driver, codec, disk

/// Arguments that make no sense; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class FailureAs { kMessage, kMessageAndJson };

/// As the command's arguments ask for it by `--json`.
FailureAs failure_as(const std::vector<std::string>& arguments);

/// Runs a command, says on stderr why it could not do its work, where wanted on stdout as JSON too, and gives the exit
/// code. Standard streams that are closed are replaced by /dev/null before.
int exit_code_of(const std::function<int()>& command, FailureAs as = FailureAs::kMessage);

}  // namespace thinwall

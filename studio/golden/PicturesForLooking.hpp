#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "studio/golden/GoldenRun.hpp"

namespace thinwall {

/// The pictures of a test that are to be looked at, in a folder for one scenario; nothing of them is a golden.
class PicturesForLooking {
 public:
  explicit PicturesForLooking(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes today's picture of a golden that failed or is missing, and what helps to see why; gives a line for each
  /// file: "today's picture: FILE". `goldens`: the scenario's. Throws PictureFailure, GoldenError.
  std::vector<std::string> keep(const JudgedScenario& judged, std::size_t index, const std::filesystem::path& goldens);

  /// Removes pictures that an earlier test has left, and the folder when nothing else is in it. Files that are none of
  /// these stay.
  void remove_others() const;

 private:
  void write(std::vector<std::string>& lines, const std::string& words, const std::string& name, const Image& image);

  std::filesystem::path folder_;
  std::set<std::string> written_;
};

}  // namespace thinwall

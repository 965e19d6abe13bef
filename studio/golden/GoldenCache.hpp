#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studio/golden/GoldenComparison.hpp"

namespace thinwall {

/// Remembers which scenarios were good, by the hash of everything that goes in: program, resolved scenario, the files
/// that it and the scenario of its second take name, and the goldens. What has failed is never remembered.
class GoldenCache {
 public:
  /// `program`: a hash of what simulates and draws, device and driver included. A file that cannot be read counts as
  /// empty.
  GoldenCache(const std::filesystem::path& file, std::string program);

  /// Empty when a file that the scenario names is not found: then nothing is remembered.
  std::string key(const Scenario& scenario, const std::filesystem::path& goldens) const;

  /// The results of the run of that key; none when there was none.
  std::vector<GoldenResult> find(const Scenario& scenario, const std::string& key) const;

  /// Keeps them when all are ok.
  void keep(const Scenario& scenario, const std::string& key, const std::vector<GoldenResult>& results);

  /// So that it is made anew.
  void forget(const Scenario& scenario);

  /// Takes over what another cache of the same program has kept.
  void take_over(const std::filesystem::path& file);

  /// Throws PictureFailure.
  void write_to(const std::filesystem::path& file) const;

 private:
  struct Entry {
    std::string key;
    std::vector<GoldenResult> results;
  };
  std::string program_;
  std::map<std::string, Entry> entries_;  // by scenario
};

/// 32 hexadecimal digits of the content of a file; empty when it cannot be read.
std::string file_hash(const std::filesystem::path& file);

}  // namespace thinwall

#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "studio/take/TakeReader.hpp"

namespace thinwall {

/// One approved picture of a scenario.
struct GoldenApproval {
  double at = 0;             // seconds
  std::string driver;        // what drew it, as it names itself
  std::string image;         // file name in the scenario's golden folder
  std::string state;         // likewise: the moment it shows, as a take of one step
  std::string state_digest;  // of the simulation at that time
  std::string who;
  std::string why;
  // What tells later which stage has changed; empty in approvals of earlier versions.
  std::string history = {};     // file name: the main quantities step by step
  std::string scene_hash = {};  // of the picture without overlays
  std::string overlay = {};     // JSON: what is written over the picture
  // Of two takes that are compared, as `state` and `state_digest`; empty when there is one.
  std::string second_state = {};
  std::string second_state_digest = {};
  std::string picture_hash = {};  // of the approved picture; empty in approvals of earlier versions
  std::string files = {};         // JSON: hashes of the files that the scenario names; empty likewise
  // Names of the tools that are out of the picture, of both takes; none in approvals of earlier versions.
  std::optional<std::vector<std::string>> set_aside = {}, second_set_aside = {};
};

/// A golden folder that cannot be read: the message names file and reason. Exit code 2.
class GoldenError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// For a file of a golden that is damaged: `what` is wrong with it, and what helps.
GoldenError damaged_golden(const std::string& what);

/// The first of these files of a golden, by their names, that is not in `folder`, with what helps: "at_1s.state.h5 is
/// missing, ...". Empty when all are there; names may be empty, of files that were never kept.
std::string lost_file(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// For the picture in `file` that is not the one that was approved, as its hash is not that of the approval.
GoldenError exchanged_picture(const std::filesystem::path& file);

/// Whether a golden's state is the one whose digest the approval tells, as it is not after an approval that was killed.
bool is_approved_state(const TakeReader& state, const std::string& digest);

/// What `folder`/approval.json holds, in its order; nothing when there is none. Throws GoldenError.
std::vector<GoldenApproval> read_approvals(const std::filesystem::path& folder);

/// Throws PictureFailure.
void write_approvals(const std::filesystem::path& folder, const std::vector<GoldenApproval>& approvals);

/// The approval to compare with: of that time and driver; else the last of that time, of another driver; else null.
const GoldenApproval* find_approval(const std::vector<GoldenApproval>& approvals, double at, const std::string& driver);

/// The name, without extension, of the files of a golden: time and a short hash of the driver.
std::string golden_stem(double at, const std::string& driver);

}  // namespace thinwall

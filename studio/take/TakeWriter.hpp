#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "studio/record/Moment.hpp"

namespace thinwall {

/// What a take says of itself before its first step.
struct TakeDescription {
  std::string name;      // of the scenario
  std::string title;     // of the scenario
  std::string resolved;  // the scenario as JSON text, parameters and defaults filled in
};

/// What is known of a take only at its end.
struct TakeEnding {
  bool complete = false;  // whether the run reached its end
  std::vector<std::string> warnings;
  std::string state_digest;  // of the last step
};

/// Writes a take as TakeLayout.hpp describes it, under its unfinished name until it is whole. Equal calls give equal
/// bytes.
class TakeWriter {
 public:
  /// Throws PictureFailure when the file cannot be made.
  TakeWriter(std::filesystem::path target, const TakeDescription& description);
  /// Without finish(): what was written stays, readable, under the unfinished name and marked incomplete.
  ~TakeWriter();

  /// Adds a step. Bodies, tools, scalars and fields must be those of the first step; a surface may change its topology.
  /// Throws PictureFailure when it cannot be written, SimulationFailure when a number is not finite (then nothing is).
  void write(const Moment& moment);

  /// Gives the file its name. Throws PictureFailure; then there is no file of that name.
  void finish(const TakeEnding& ending);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace thinwall

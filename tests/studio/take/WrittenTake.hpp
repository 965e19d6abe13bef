#pragma once

#include <filesystem>
#include <string>

#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"
#include "studio/take/TakeWriter.hpp"
#include "tests/studio/SyntheticRun.hpp"

namespace thinwall {

/// What write_take writes beside the moments.
inline const TakeDescription kDescription{.name = "sheet", .title = "A sheet", .resolved = R"({"thinwall":1})"};

/// A whole take of a synthetic run.
inline void write_take(const std::filesystem::path& file, SyntheticRunOptions options = {}) {
  SyntheticRun run(options);
  TakeWriter writer(file, kDescription);
  while (const auto moment = run.next()) writer.write(*moment);
  writer.finish({.complete = true, .warnings = run.warnings(), .state_digest = run.state_digest()});
}

/// What reading all of a take ends with; empty where nothing is wrong.
inline std::string complaint_about(const std::filesystem::path& file) {
  try {
    const TakeReader reader(file);
    for (std::size_t step = 0; step < reader.times().size(); ++step) static_cast<void>(reader.moment(step));
  } catch (const TakeError& error) {
    return error.what();
  }
  return "";
}

}  // namespace thinwall

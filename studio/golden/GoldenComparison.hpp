#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/image/ImageDifference.hpp"
#include "renderer/metric/Ladder.hpp"
#include "studio/golden/GoldenApproval.hpp"
#include "studio/golden/GoldenPicture.hpp"

namespace thinwall {

enum class GoldenOutcome {
  kOk,
  kFailed,
  kResultMissing,
  kGoldenMissing,
  kSkipped,
  kBroken,  // the scenario cannot be run as it is, or what is approved cannot be read
};

/// "ok", "failed", "result missing", "golden missing", "skipped", "broken"
std::string outcome_name(GoldenOutcome outcome);

/// What became of the simulated state since the approval, from good to bad.
enum class StateVerdict {
  kEqual,    // to the last bit
  kClose,    // no vertex has moved by more than kCloseState of the surface's size
  kUnknown,  // nothing to compare
  kChanged,
};

/// A hundredth of a pixel when a surface fills a picture of a thousand pixels: nobody sees it, while other machines and
/// compilers stay below it.
inline constexpr double kCloseState = 1e-5;

struct StateComparison {
  StateVerdict verdict = StateVerdict::kUnknown;
  std::string explanation;  // "the state is the same to the last bit", "vertex 12 of organ has moved by 0.3 mm", ...
};

/// Positions of all surfaces, and whether the digests are equal; where no wall has moved, the places of tools.
StateComparison compare_states(const Snapshot& golden, const Snapshot& today, bool equal_digests);

/// One picture of one scenario, judged.
struct GoldenResult {
  std::string scenario;
  double at = 0;             // seconds
  bool is_video = false;     // the whole of it; then `at` has no meaning
  bool is_scenario = false;  // which cannot be read, so that nobody knows its goldens; likewise
  GoldenOutcome outcome = GoldenOutcome::kOk;
  bool cannot_be_made = false;  // of a result that is missing: for want of device or disk
  std::string rung;  // of the ladder, that decided: "bytes", "size", "pixels", "structure", "flip"; empty when nothing
                     // was compared
  std::string message;        // one line
  std::string details;        // many lines: map and worst pixels; for failures
  std::string driver;         // of today's picture
  std::string golden_driver;  // of the approved one
  ImageDifference difference;
  Drift drift;
  std::optional<double> failing = {};     // fraction of pixels, where the scenario limits it
  std::optional<double> similarity = {};  // likewise
  std::optional<double> flip = {};        // likewise
  StateComparison state;
  std::vector<std::size_t> different_frames = {};  // of a video, in order
};

/// "at 1.5 s", "the video" or "as a whole"
std::string moment_name(const GoldenResult& result);

/// As commands take it: "sheet@0.1s", "sheet@video", or "sheet" of a scenario as a whole; quoted where a shell needs
/// it.
std::string golden_argument(const GoldenResult& result);

/// The limits of a golden as the ladder of comparisons has them.
PictureLimits picture_limits(const GoldenDefinition& definition);

/// With the limits for a picture that `driver` draws beside a golden of `golden_driver`. Between two drivers a pixel in
/// ten differs by a level or two where they round, and along edges single pixels show what lies on the other side, so
/// the scenario's limits hold only where they allow more than that.
GoldenDefinition with_limits_between(GoldenDefinition definition, const std::string& golden_driver,
                                     const std::string& driver);

/// Pixels that differ by more are counted in what is told of a difference, 8-bit levels.
int counted_level(const GoldenDefinition& definition);

/// "largest 8, mean 0.2, drift 0.001", and what else is limited.
std::string limits_text(const GoldenDefinition& definition);

/// Compares a picture with what is approved in `folder`. First rung: equal bytes. Then: the limits of the
/// scenario, cheap ones first; also when the golden was drawn by another driver, which the message then says. A golden
/// whose state or history is lost is missing, also where the picture is within its limits. Throws GoldenError, also
/// when the golden's picture is not the approved one.
GoldenResult compare_with_golden(const std::string& scenario, const GoldenDefinition& definition,
                                 const GoldenPicture& picture, const std::string& driver,
                                 const std::filesystem::path& folder);

}  // namespace thinwall

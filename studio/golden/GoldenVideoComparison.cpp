#include "studio/golden/GoldenVideoComparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PngFile.hpp"
#include "studio/comparison/FrameSequence.hpp"
#include "studio/golden/VideoAttribution.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

// What rounding of means leaves between two drivers, in 8-bit levels.
constexpr double kSameSquare = 2;
// What the same encoder loses more on frames that differ a little, or another version of it on the same frames.
constexpr double kMoreLoss = 1.25;
constexpr double kLossFloor = 0.1;     // 8-bit levels
constexpr double kDriftFloor = 0.002;  // relative

std::vector<std::string> hashes_of(const GoldenVideo& video) {
  std::vector<std::string> hashes;
  for (const VideoFrameRecord& frame : video.frames) hashes.push_back(frame.hash);
  return hashes;
}

int level_at(const std::string& squares, std::size_t k) {
  int level = 0;
  std::from_chars(squares.data() + 2 * k, squares.data() + 2 * k + 2, level, 16);
  return level;
}

/// The largest difference of a square's mean, 8-bit levels.
int square_difference(const std::string& first, const std::string& second) {
  if (first.size() != second.size()) return 255;
  int largest = 0;
  for (std::size_t k = 0; 2 * k + 1 < first.size(); ++k) {
    largest = std::max(largest, std::abs(level_at(first, k) - level_at(second, k)));
  }
  return largest;
}

/// The first line that two texts do not share: "\"Presing\" instead of \"Pressing\""
std::string first_other_line(const std::string& before, const std::string& after) {
  std::istringstream a(before), b(after);
  std::string line_a, line_b;
  while (true) {
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (!more_a && !more_b) return "";
    if (!more_a) line_a.clear();
    if (!more_b) line_b.clear();
    if (line_a != line_b) return fmt::format("\"{}\" instead of \"{}\"", line_b, line_a);
  }
}

class VideoComparer {
 public:
  VideoComparer(const GoldenDefinition& definition, const GoldenVideoApproval& golden, const RecordedVideo& today,
                const std::filesystem::path& folder, GoldenResult& result)
      : definition_(definition), golden_(golden), today_(today), folder_(folder), result_(result) {}

  VideoFindings compare() {
    compare_frames();
    if (golden_.video.captions != today_.video.captions) {
      found_.texts.push_back("caption " + first_other_line(golden_.video.captions, today_.video.captions));
    }
    compare_files();
    return found_;
  }

 private:
  void compare_frames() {
    const GoldenVideo& before = golden_.video;
    const GoldenVideo& now = today_.video;
    if (before.size != now.size) {
      found_.frames.push_back(fmt::format("{} x {} pixels instead of {} x {}", now.size.width, now.size.height,
                                          before.size.width, before.size.height));
      return;
    }
    if (before.frames_per_second != now.frames_per_second) {
      found_.frames.push_back(
          fmt::format("{:g} frames per second instead of {:g}", now.frames_per_second, before.frames_per_second));
    }
    const std::string length = length_difference(hashes_of(before), hashes_of(now));
    if (!length.empty()) found_.frames.push_back(length);
    const std::size_t count = std::min(before.frames.size(), now.frames.size());
    for (std::size_t frame = 0; frame < count; ++frame) {
      if (before.frames[frame].hash != now.frames[frame].hash) result_.different_frames.push_back(frame);
    }
    if (result_.different_frames.empty() || !length.empty()) return;
    judge_kept();
    judge_squares();
  }

  void judge_kept() {
    double worst = -1;
    for (std::size_t i = 0; i < golden_.video.kept.size(); ++i) {
      const std::size_t frame = golden_.video.kept[i];
      const auto place = std::find(today_.video.kept.begin(), today_.video.kept.end(), frame);
      if (place == today_.video.kept.end()) continue;
      const Image approved = read_png(folder_ / golden_.pictures[i]);
      const Image& picture = today_.pictures[static_cast<std::size_t>(place - today_.video.kept.begin())];
      PictureOptions options;
      options.limits = picture_limits(definition_);
      const PictureComparison comparison = climb_ladder(approved, picture, options);
      if (comparison.difference.mean > worst) {
        worst = comparison.difference.mean;
        result_.difference = compare_images(approved, picture, counted_level(definition_));
        result_.drift = comparison.drift;
        result_.rung = comparison.rung;
      }
      if (comparison.within) continue;
      if (result_.details.empty()) {
        result_.details = describe(comparison.difference) + "\n" + difference_text(approved, picture);
      }
      found_.frames.push_back(fmt::format("frame {} at {:.3f} s: {}", frame, time_of(frame), comparison.verdict));
    }
  }

  void judge_squares() {
    const double allowed = std::max(kSameSquare, definition_.mean);
    for (const std::size_t frame : result_.different_frames) {
      const int difference = square_difference(golden_.video.frames[frame].squares, today_.video.frames[frame].squares);
      if (difference <= allowed) continue;
      found_.frames.push_back(
          fmt::format("frame {} at {:.3f} s: a twelfth of it differs by {} levels on average (allowed {:g})", frame,
                      time_of(frame), difference, allowed));
      return;
    }
  }

  void compare_files() {
    if (!today_.encoder_failure.empty()) {
      found_.encoder.push_back("there is no video: " + today_.encoder_failure);
      return;
    }
    const EncodedVideo& before = golden_.video.encoded;
    const EncodedVideo& now = today_.video.encoded;
    if (now.frames != today_.video.frames.size()) {
      found_.encoder.push_back(fmt::format("the file holds {} frames of {}", now.frames, today_.video.frames.size()));
    }
    if (!now.times.empty()) found_.encoder.push_back(now.times);
    if (now.tags != before.tags) {
      found_.encoder.push_back(fmt::format("the file is tagged \"{}\" instead of \"{}\"", now.tags, before.tags));
    }
    if (found_.texts.empty() && now.captions != before.captions) {
      found_.encoder.push_back("captions of the file: " + first_other_line(before.captions, now.captions));
    }
    if (now.chapters != before.chapters) {
      const auto asked = compare_scenarios(golden_.video.resolved, today_.video.resolved);
      const bool are_the_encoders = result_.different_frames.empty() && found_.frames.empty() &&
                                    list_changes(asked, {ScenarioStage::kOverlay}).empty();
      (are_the_encoders ? found_.encoder : found_.texts)
          .push_back("chapters: " + first_other_line(before.chapters, now.chapters));
    }
    compare_decoded(before, now);
  }

  void compare_decoded(const EncodedVideo& before, const EncodedVideo& now) {
    const bool same_input = result_.different_frames.empty() && found_.frames.empty();
    if (same_input && before.program == now.program) {
      if (before.decoded == now.decoded) return;
      found_.encoder.push_back(
          fmt::format("the decoded pixels differ; the encoder loses {:.3f} levels instead of {:.3f} in the worst frame",
                      now.loss, before.loss));
      return;
    }
    const double allowed_loss = kMoreLoss * before.loss + kLossFloor;
    if (now.loss > allowed_loss) {
      found_.encoder.push_back(fmt::format("the encoder loses {:.3f} levels instead of {:.3f} (allowed {:.3f})",
                                           now.loss, before.loss, allowed_loss));
    }
    const double allowed_drift = kMoreLoss * before.drift + kDriftFloor;
    if (now.drift > allowed_drift) {
      found_.encoder.push_back(fmt::format("the encoder changes colours by {:.4f} instead of {:.4f} (allowed {:.4f})",
                                           now.drift, before.drift, allowed_drift));
    }
  }

  double time_of(std::size_t frame) const { return static_cast<double>(frame) / golden_.video.frames_per_second; }

  const GoldenDefinition& definition_;
  const GoldenVideoApproval& golden_;
  const RecordedVideo& today_;
  const std::filesystem::path& folder_;
  GoldenResult& result_;
  VideoFindings found_;
};

/// Throws GoldenError when a picture that is kept is not that of its frame.
void refuse_exchanged_pictures(const GoldenVideoApproval& golden, const std::filesystem::path& folder) {
  for (std::size_t i = 0; i < golden.pictures.size(); ++i) {
    const std::filesystem::path file = folder / golden.pictures[i];
    if (image_hash(read_png(file)) != golden.video.frames.at(golden.video.kept[i]).hash) throw exchanged_picture(file);
  }
}

/// What is not there of what an approval keeps, with what helps; empty where all of it is. A history that is damaged is
/// none: the next failure could not be told.
std::string lost_of(const GoldenVideoApproval& golden, const std::filesystem::path& folder) {
  std::string lost = lost_file(folder, golden.files);
  if (!lost.empty()) return lost;
  try {
    parse_history(golden.video.history, (folder / golden.history).string());
  } catch (const GoldenError& error) {
    lost = std::string(error.what()) + "; restore it from version control, or approve anew";
  }
  return lost;
}

std::string good_message(const GoldenResult& result, const GoldenVideo& today) {
  if (result.different_frames.empty()) return fmt::format("{} frames are equal", today.frames.size());
  return fmt::format("{} of {} frames differ within the limits", result.different_frames.size(), today.frames.size());
}

}  // namespace

VideoJudgement compare_with_golden_video(const std::string& scenario, const GoldenDefinition& definition,
                                         const RecordedVideo& recorded, const std::filesystem::path& folder) {
  VideoJudgement judgement;
  GoldenResult& result = judgement.result;
  result.scenario = scenario;
  result.is_video = true;
  result.driver = recorded.video.driver;
  if (!recorded.no_device.empty() || !recorded.missing.empty()) {
    result.outcome = recorded.no_device.empty() ? GoldenOutcome::kResultMissing : GoldenOutcome::kSkipped;
    result.message = recorded.no_device.empty() ? recorded.missing : recorded.no_device;
    result.cannot_be_made = recorded.cannot_be_made;
    return judgement;
  }
  const std::optional<GoldenVideoApproval> golden = find_video_approval(folder, recorded.video.driver);
  if (!golden) {
    result.outcome = GoldenOutcome::kGoldenMissing;
    result.message = fmt::format("no video is approved; look at today's, then: thinwall golden approve {} --why ...",
                                 shell_argument(scenario));
    return judgement;
  }
  const std::string lost = lost_of(*golden, folder);
  if (!lost.empty()) {
    result.outcome = GoldenOutcome::kGoldenMissing;
    result.message = lost;
    return judgement;
  }
  result.golden_driver = golden->video.driver;
  result.rung = "bytes";
  VideoFindings found;
  try {
    refuse_exchanged_pictures(*golden, folder);
    const GoldenDefinition limited = with_limits_between(definition, golden->video.driver, recorded.video.driver);
    found = VideoComparer(limited, *golden, recorded, folder, result).compare();
  } catch (const ImageUnreadable& error) {
    throw damaged_golden(error.what());
  }
  if (have_same_last_state(golden->video, recorded.video)) {
    result.state = {.verdict = StateVerdict::kEqual, .explanation = "the last state is the same to the last bit"};
  }
  if (found.all().empty()) {
    result.message = good_message(result, recorded.video);
  } else {
    result.outcome = GoldenOutcome::kFailed;
    judgement.attribution = attribute_video(golden->video, recorded.video, found);
    result.message = one_after_the_other(found.all());
  }
  if (golden->video.driver != recorded.video.driver) {
    result.message += fmt::format("; approved on another driver ({}), so compared by tolerance", golden->video.driver);
  }
  return judgement;
}

}  // namespace thinwall

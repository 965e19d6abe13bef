#include "studio/golden/GoldenComparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/image/ImageHash.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/snapshot/SameTime.hpp"
#include "studio/golden/GoldenHistory.hpp"
#include "studio/schema/Wording.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {
namespace {

constexpr double kMillimetre = 1e3;  // per metre

template <typename Point>
double distance(const Point& a, const Point& b) {
  return std::hypot(static_cast<double>(a[0]) - b[0], static_cast<double>(a[1]) - b[1],
                    static_cast<double>(a[2]) - b[2]);
}

/// The diagonal of the box around all points, metres.
double extent(const std::vector<Float3>& points) {
  if (points.empty()) return 0;
  Float3 low = points.front();
  Float3 high = points.front();
  for (const Float3& point : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  return distance(low, high);
}

struct Movement {
  std::string body;
  std::size_t vertex = 0;
  double distance = 0;  // metres
  double extent = 0;    // metres, of the surface
  double relative() const { return extent > 0 ? distance / extent : distance; }
};

Movement largest_movement(const SnapshotSurface& golden, const SnapshotSurface& today) {
  Movement largest{.body = golden.body, .vertex = 0, .distance = 0, .extent = extent(golden.positions)};
  for (std::size_t vertex = 0; vertex < golden.positions.size(); ++vertex) {
    const double moved = distance(golden.positions[vertex], today.positions[vertex]);
    if (moved > largest.distance) {
      largest.distance = moved;
      largest.vertex = vertex;
    }
  }
  return largest;
}

StateComparison compare_walls(const Snapshot& golden, const Snapshot& today, bool equal_digests) {
  if (equal_digests) return {.verdict = StateVerdict::kEqual, .explanation = "the state is the same to the last bit"};
  if (golden.surfaces.size() != today.surfaces.size()) {
    return {
        .verdict = StateVerdict::kChanged,
        .explanation = fmt::format("there are {} bodies instead of {}", today.surfaces.size(), golden.surfaces.size())};
  }
  Movement largest;
  for (std::size_t i = 0; i < golden.surfaces.size(); ++i) {
    const SnapshotSurface& before = golden.surfaces[i];
    const SnapshotSurface& now = today.surfaces[i];
    if (before.positions.size() != now.positions.size() || before.topology->triangles != now.topology->triangles) {
      return {.verdict = StateVerdict::kChanged, .explanation = "the mesh of " + before.body + " has changed"};
    }
    const Movement movement = largest_movement(before, now);
    if (i == 0 || movement.relative() > largest.relative()) largest = movement;
  }
  if (largest.relative() <= kCloseState) {
    return {.verdict = StateVerdict::kClose,
            .explanation = largest.distance == 0
                               ? "no vertex has moved"
                               : fmt::format("no vertex has moved by more than {:.2g} mm, {:.2g} of the surface's size",
                                             kMillimetre * largest.distance, largest.relative())};
  }
  return {.verdict = StateVerdict::kChanged,
          .explanation = fmt::format("vertex {} of {} has moved by {:.3g} mm, {:.2g} of the surface's size",
                                     largest.vertex, largest.body, kMillimetre * largest.distance, largest.relative())};
}

/// How a tool stands otherwise than in the golden: "rod is 1 mm from where it was"; empty when it stands as before, but
/// for less than `close`, metres.
std::string tool_movement(const SnapshotTool& before, const SnapshotTool& now, double close) {
  constexpr double kDegrees = 180 / std::numbers::pi;  // per radian
  const double way = distance(before.tip, now.tip);
  if (way > close) return fmt::format("{} is {:.3g} mm from where it was", now.name, kMillimetre * way);
  const double chord = std::max(distance(before.direction, now.direction), distance(before.axis, now.axis));
  const double turn = 2 * std::asin(std::min(1.0, chord / 2));
  if (turn > kCloseState) return fmt::format("{} is turned by {:.3g} deg", now.name, kDegrees * turn);
  const double opening = std::abs(now.opening - before.opening);
  return opening > close ? fmt::format("{} is {:.3g} mm otherwise open", now.name, kMillimetre * opening) : "";
}

/// Of the first tool that both have and that stands otherwise.
std::string tool_movement(const Snapshot& golden, const Snapshot& today) {
  const double close = golden.surfaces.empty() ? 0 : kCloseState * extent(golden.surfaces.front().positions);
  for (const SnapshotTool& now : today.tools) {
    const auto before = std::find_if(golden.tools.begin(), golden.tools.end(),
                                     [&](const SnapshotTool& tool) { return tool.name == now.name; });
    if (before == golden.tools.end()) continue;
    std::string movement = tool_movement(*before, now, close);
    if (!movement.empty()) return movement;
  }
  return "";
}

/// `approved`, `reached`: the digests of the approval and of today.
StateComparison compare_with_stored_state(const std::filesystem::path& file, const Snapshot& today,
                                          const std::string& approved, const std::string& reached) {
  try {
    const TakeReader take(file);
    if (take.times().empty()) throw TakeError(file.string() + ": holds no step");
    if (!is_approved_state(take, approved)) throw TakeError(file.string() + ": is not the state that was approved");
    return compare_states(take.moment(0).snapshot, today, approved == reached);
  } catch (const TakeError& error) {
    return {.verdict = StateVerdict::kUnknown,
            .explanation = error.problem() + "; restore it from version control, or approve the picture anew"};
  }
}

/// What is to be told of two takes: the worse of both, in the order of the verdicts.
StateComparison both_of(const StateComparison& first, const StateComparison& second) {
  if (first.verdict == StateVerdict::kChanged && second.verdict == StateVerdict::kChanged) {
    return {.verdict = StateVerdict::kChanged, .explanation = first.explanation + ", and " + second.explanation};
  }
  return second.verdict > first.verdict ? second : first;
}

/// Of both takes where two are compared.
StateComparison compare_with_approval(const std::filesystem::path& folder, const GoldenApproval& approval,
                                      const GoldenPicture& picture) {
  StateComparison state = compare_with_stored_state(folder / approval.state, picture.moment.snapshot,
                                                    approval.state_digest, picture.state_digest);
  if (!picture.moment.second) return state;
  StateComparison second = {.explanation = "nothing is approved; approve anew"};
  if (!approval.second_state.empty()) {
    second = compare_with_stored_state(folder / approval.second_state, picture.moment.second->snapshot,
                                       approval.second_state_digest, picture.second_state_digest);
  }
  second.explanation = "in the second take " + second.explanation;
  return both_of(state, second);
}

void judge(GoldenResult& result, const GoldenDefinition& definition, const Image& golden, const Image& today) {
  PictureOptions options;
  options.limits = picture_limits(definition);
  const PictureComparison comparison = climb_ladder(golden, today, options);
  result.rung = comparison.rung;
  result.message = comparison.verdict;
  result.outcome = comparison.within ? GoldenOutcome::kOk : GoldenOutcome::kFailed;
  result.difference = compare_images(golden, today, counted_level(definition));
  if (result.difference.verdict != ImageVerdict::kDifferent) return;
  result.drift = comparison.drift;
  if (comparison.failing) result.failing = comparison.failing->fraction();
  if (comparison.structure) result.similarity = comparison.structure->mean;
  if (comparison.flip) result.flip = comparison.flip->mean;
  if (!comparison.within) result.details = describe(result.difference) + "\n" + difference_text(golden, today);
}

/// The approved picture. Throws GoldenError, also when it has been exchanged.
Image approved_picture(const GoldenApproval& approval, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / approval.image;
  try {
    Image picture = read_png(file);
    const bool is_exchanged = !approval.picture_hash.empty() && approval.picture_hash != image_hash(picture);
    if (is_exchanged) throw exchanged_picture(file);
    return picture;
  } catch (const ImageUnreadable& error) {
    throw damaged_golden(error.what());
  }
}

/// What is wrong with the history that an approval has, with what helps; empty where it is whole.
std::string lost_history(const std::filesystem::path& folder, const GoldenApproval& approval) {
  if (approval.history.empty()) return "";
  const std::filesystem::path file = folder / approval.history;
  std::string lost = lost_file(folder, {approval.history});
  if (!lost.empty()) return lost;
  try {
    const GoldenHistory history = parse_history(bytes_of_file(file), file.string());
    // It is written in nine digits, and ends with the step that reaches the moment.
    const bool is_whole = !history.rows.empty() && history.rows.back().time >= approval.at * (1 - 1e-8) - kSameTime;
    if (!is_whole) lost = file.string() + ": is cut short";
  } catch (const GoldenError& error) {
    lost = error.what();
  }
  return lost.empty() ? "" : lost + "; restore it from version control, or approve anew";
}

/// A golden whose evidence is lost is no whole golden, however good the picture is: the next failure could not be told.
void mention_lost_evidence(GoldenResult& result, const GoldenApproval& approval, const std::filesystem::path& folder) {
  const std::string history = lost_history(folder, approval);
  std::string lost = lost_file(folder, {approval.state, approval.second_state});
  if (lost.empty()) lost = history;
  if (result.outcome != GoldenOutcome::kOk) {
    if (!history.empty()) result.message += "; " + history;
    return;
  }
  const bool is_state_unreadable = !approval.state.empty() && result.state.verdict == StateVerdict::kUnknown;
  if (lost.empty() && is_state_unreadable) lost = result.state.explanation;
  if (lost.empty()) return;
  result.outcome = GoldenOutcome::kGoldenMissing;
  result.message = "the picture is good, but what tells later what has changed is not there: " + lost;
}

}  // namespace

std::string outcome_name(GoldenOutcome outcome) {
  switch (outcome) {
    case GoldenOutcome::kOk:
      return "ok";
    case GoldenOutcome::kFailed:
      return "failed";
    case GoldenOutcome::kResultMissing:
      return "result missing";
    case GoldenOutcome::kGoldenMissing:
      return "golden missing";
    case GoldenOutcome::kSkipped:
      return "skipped";
    case GoldenOutcome::kBroken:
      return "broken";
  }
  return "";
}

PictureLimits picture_limits(const GoldenDefinition& definition) {
  return {.largest = definition.max,
          .mean = definition.mean,
          .drift = definition.drift,
          .failing = definition.failing,
          .tolerance = {.level = definition.level, .shift = definition.shift},
          .structure = definition.similarity,
          .flip = definition.flip};
}

GoldenDefinition with_limits_between(GoldenDefinition definition, const std::string& golden_driver,
                                     const std::string& driver) {
  if (golden_driver == driver) return definition;
  // Of 23 pictures that an NVIDIA H200 and llvmpipe had drawn of equal states the means differed by 0.047 levels, the
  // colours by 0.0009, and 5 of 230 400 pixels by more than 8 levels at the most.
  constexpr double kMean = 0.1;          // 8-bit levels
  constexpr double kDrift = 0.002;       // relative
  constexpr double kLevel = 8;           // 8-bit levels
  constexpr double kStrayPixels = 5e-5;  // fraction
  constexpr double kLargest = 255;       // 8-bit levels
  definition.mean = std::max(definition.mean, kMean);
  definition.drift = std::max(definition.drift, kDrift);
  if (!definition.failing) {
    definition.failing = kStrayPixels;
    definition.level = static_cast<int>(std::max(definition.max, kLevel));
  }
  definition.max = kLargest;
  return definition;
}

int counted_level(const GoldenDefinition& definition) {
  return definition.failing ? definition.level : static_cast<int>(definition.max);
}

std::string limits_text(const GoldenDefinition& definition) {
  std::string text =
      fmt::format("largest {:g}, mean {:g}, drift {:g}", definition.max, definition.mean, definition.drift);
  if (definition.failing) {
    text += fmt::format(", failing fraction {:g} by {} levels within {} pixels", *definition.failing, definition.level,
                        definition.shift);
  }
  if (definition.similarity) text += fmt::format(", SSIM {:g}", *definition.similarity);
  if (definition.flip) text += fmt::format(", FLIP {:g}", *definition.flip);
  return text;
}

std::string moment_name(const GoldenResult& result) {
  if (result.is_scenario) return "as a whole";
  return result.is_video ? "the video" : fmt::format("at {:.9g} s", result.at);
}

std::string golden_argument(const GoldenResult& result) {
  const std::string moment = result.is_video ? "@video" : fmt::format("@{:.9g}s", result.at);
  return shell_argument(result.scenario + (result.is_scenario ? "" : moment));
}

StateComparison compare_states(const Snapshot& golden, const Snapshot& today, bool equal_digests) {
  StateComparison state = compare_walls(golden, today, equal_digests);
  // A digest is of the walls alone.
  const std::string tools = state.verdict == StateVerdict::kChanged ? "" : tool_movement(golden, today);
  if (tools.empty()) return state;
  return {.verdict = StateVerdict::kChanged, .explanation = tools + ", though no wall has moved"};
}

GoldenResult compare_with_golden(const std::string& scenario, const GoldenDefinition& definition,
                                 const GoldenPicture& picture, const std::string& driver,
                                 const std::filesystem::path& folder) {
  GoldenResult result;
  result.scenario = scenario;
  result.at = definition.at;
  result.driver = driver;
  if (!picture.missing.empty()) {
    result.outcome = GoldenOutcome::kResultMissing;
    result.message = picture.missing;
    result.cannot_be_made = picture.cannot_be_made;
    return result;
  }
  const std::vector<GoldenApproval> approvals = read_approvals(folder);
  const GoldenApproval* approval = find_approval(approvals, definition.at, driver);
  const std::string lost = approval == nullptr ? "" : lost_file(folder, {approval->image});
  if (approval == nullptr || !lost.empty()) {
    result.outcome = GoldenOutcome::kGoldenMissing;
    result.message = fmt::format("{}; look at today's, then: thinwall golden approve {} --why ...",
                                 lost.empty() ? "no picture is approved" : lost, shell_argument(scenario));
    return result;
  }
  result.golden_driver = approval->driver;
  judge(result, with_limits_between(definition, approval->driver, driver), approved_picture(*approval, folder),
        picture.image);
  result.state = compare_with_approval(folder, *approval, picture);
  if (result.outcome == GoldenOutcome::kFailed) result.message += "; " + result.state.explanation;
  mention_lost_evidence(result, *approval, folder);
  if (approval->driver != driver) {
    result.message += fmt::format("; approved on another driver ({}), so compared by tolerance", approval->driver);
  }
  return result;
}

}  // namespace thinwall

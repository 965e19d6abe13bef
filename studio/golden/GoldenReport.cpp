#include "studio/golden/GoldenReport.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "renderer/image/PngFile.hpp"
#include "renderer/image/Resize.hpp"
#include "renderer/image/WholeFile.hpp"
#include "renderer/metric/ErrorPicture.hpp"
#include "renderer/metric/Flip.hpp"
#include "studio/golden/GoldenVideoApproval.hpp"
#include "studio/golden/ReportPage.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

constexpr ImageSize kThumbnail{.width = 160, .height = 120};

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16;
    if (left > 1) group |= static_cast<std::uint32_t>(bytes[i + 1]) << 8;
    if (left > 2) group |= bytes[i + 2];
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kLetters[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string as_url(const Image& image) {
  return "data:image/png;base64," + base64(encode_png(image, PngEffort::kSmall));
}

std::string thumbnail(const Image& image) {
  return as_url(resize(image, size_that_fits(image.size, kThumbnail)));
}

/// A picture of a golden; an empty one when it is lost.
Image golden_picture(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  try {
    return read_png(file);
  } catch (const ImageUnreadable& error) {
    throw damaged_golden(error.what());
  }
}

/// The approved picture of a result; an empty one when there is none.
Image approved_picture(const GoldenResult& result, const std::vector<GoldenApproval>& approvals,
                       const std::filesystem::path& folder) {
  const std::string& driver = result.golden_driver.empty() ? result.driver : result.golden_driver;
  const GoldenApproval* approval = find_approval(approvals, result.at, driver);
  return approval == nullptr ? Image{} : golden_picture(folder / approval->image);
}

Json pictures_to_compare(const Image& golden, const Image& today, const std::optional<Attribution>& attribution) {
  Json pictures = Json::object();
  if (!golden.pixels.empty()) pictures["golden"] = as_url(golden);
  if (!today.pixels.empty()) pictures["today"] = as_url(today);
  if (!golden.pixels.empty() && golden.size == today.size) {
    pictures["difference"] = as_url(difference_picture(golden, today));
    pictures["flip"] = as_url(error_picture(golden, flip(golden, today).map));
  }
  if (attribution && attribution->golden_state) pictures["golden_state"] = as_url(*attribution->golden_state);
  for (const StateLayer& layer : attribution ? attribution->layers : std::vector<StateLayer>{}) {
    pictures[layer.name + " golden"] = as_url(layer.golden);
    if (!layer.today.pixels.empty()) pictures[layer.name + " today"] = as_url(layer.today);
  }
  if (attribution && attribution->golden_look) pictures["golden_look"] = as_url(*attribution->golden_look);
  return pictures;
}

std::string file_url(const std::filesystem::path& file, const std::string& type) {
  const std::string bytes = bytes_of_file(file);
  return bytes.empty() ? "" : "data:" + type + ";base64," + base64(as_numbers(bytes));
}

/// Of a video: which frames differ, the pictures that are kept of the golden one beside today's, and today's file.
Json frames_to_compare(const JudgedScenario& judged, const GoldenResult& result,
                       const std::optional<GoldenVideoApproval>& golden, const std::filesystem::path& folder) {
  const RecordedVideo& today = *judged.video;
  Json json = {{"frames", today.video.frames.size()},
               {"frames_per_second", today.video.frames_per_second},
               {"different", result.different_frames},
               {"kept", Json::array()},
               {"file", file_url(today.file, "video/mp4")}};
  for (std::size_t i = 0; i < today.video.kept.size(); ++i) {
    const std::size_t frame = today.video.kept[i];
    Image approved;
    if (golden) {
      const auto place = std::find(golden->video.kept.begin(), golden->video.kept.end(), frame);
      const std::size_t k = static_cast<std::size_t>(place - golden->video.kept.begin());
      if (k < golden->pictures.size()) approved = golden_picture(folder / golden->pictures[k]);
    }
    json["kept"].push_back(
        {{"frame", frame}, {"pictures", pictures_to_compare(approved, today.pictures[i], std::nullopt)}});
  }
  return json;
}

/// What a video's entry has beside that of a picture.
void add_video(Json& json, const JudgedScenario& judged, const GoldenResult& result,
               const std::filesystem::path& folder) {
  const std::optional<GoldenVideoApproval> golden = find_video_approval(folder, result.driver);
  json["approvals"] = Json::array();
  for (const GoldenVideoApproval& approval : read_video_approvals(folder)) {
    json["approvals"].push_back({{"who", approval.who}, {"why", approval.why}, {"driver", approval.video.driver}});
  }
  if (golden && !golden->pictures.empty()) {
    const Image middle = golden_picture(folder / golden->pictures[golden->pictures.size() / 2]);
    if (!middle.pixels.empty()) json["thumbnail"] = thumbnail(middle);
  }
  if (result.outcome == GoldenOutcome::kOk || !judged.video || judged.video->pictures.empty()) return;
  const std::vector<Image>& pictures = judged.video->pictures;
  json["thumbnail"] = thumbnail(pictures[pictures.size() / 2]);
  json["video"] = frames_to_compare(judged, result, golden, folder);
}

Json history_of(const std::vector<GoldenApproval>& approvals, double at) {
  Json list = Json::array();
  for (const GoldenApproval& approval : approvals) {
    if (std::abs(approval.at - at) > 1e-9) continue;
    list.push_back({{"who", approval.who}, {"why", approval.why}, {"driver", approval.driver}});
  }
  return list;
}

void add_changes(Json& json, const std::optional<Attribution>& attribution) {
  if (!attribution) return;
  json["layers"] = Json::object();
  for (const StateLayer& layer : attribution->layers) json["layers"][layer.name] = layer.verdict;
  Json changes = Json::array();
  for (const ScenarioChange& change : attribution->scenario) changes.push_back(to_text(change));
  json["scenario_changes"] = changes;
}

Json entry(const JudgedScenario& judged, std::size_t index, const std::filesystem::path& folder) {
  const GoldenResult& result = judged.results[index];
  const std::string& golden_driver = result.golden_driver.empty() ? result.driver : result.golden_driver;
  const GoldenDefinition definition = with_limits_between(judged.scenario.goldens[index], golden_driver, result.driver);
  const std::optional<Attribution>& attribution = judged.attributions[index];
  // What is approved may be the very thing that cannot be read; a video has approvals of its own.
  const bool is_broken = result.outcome == GoldenOutcome::kBroken;
  const std::vector<GoldenApproval> approvals =
      is_broken || result.is_video ? std::vector<GoldenApproval>() : read_approvals(folder);
  const Image golden = result.is_video ? Image{} : approved_picture(result, approvals, folder);
  Json json = {{"scenario", result.scenario},
               {"title", judged.scenario.title},
               {"at", result.at},
               {"name", result.scenario + " " + moment_name(result)},
               {"argument", golden_argument(result)},
               {"outcome", outcome_name(result.outcome)},
               {"message", result.message},
               {"cause", result.outcome == GoldenOutcome::kOk ? "" : cause_line(judged, index)},
               {"stage", attribution ? stage_name(attribution->stage) : ""},
               {"details", result.details},
               {"max", definition.max},
               {"mean", definition.mean},
               {"limits", limits_text(definition)},
               {"why", definition.why},
               {"largest", result.difference.largest},
               {"mean_difference", result.difference.mean},
               {"drift", result.drift.largest()},
               {"driver", result.driver},
               {"approvals", history_of(approvals, result.at)}};
  if (is_broken) return json;
  if (result.is_video) {
    add_video(json, judged, result, folder);
    add_changes(json, attribution);
    return json;
  }
  if (result.outcome == GoldenOutcome::kOk) {
    if (!golden.pixels.empty()) json["thumbnail"] = thumbnail(golden);
    return json;
  }
  const bool has_today = index < judged.pictures.pictures.size();
  const Image today = has_today ? judged.pictures.pictures[index].image : Image{};
  if (!golden.pixels.empty() || !today.pixels.empty()) {
    json["thumbnail"] = thumbnail(today.pixels.empty() ? golden : today);
  }
  json["pictures"] = pictures_to_compare(golden, today, attribution);
  add_changes(json, attribution);
  return json;
}

}  // namespace

std::string golden_report(const std::vector<JudgedScenario>& scenarios, const std::filesystem::path& goldens) {
  Json list = Json::array();
  for (const JudgedScenario& judged : scenarios) {
    for (std::size_t i = 0; i < judged.results.size(); ++i) {
      list.push_back(entry(judged, i, goldens / judged.scenario.name));
    }
  }
  std::string data = list.dump(-1, ' ', true, Json::error_handler_t::replace);
  // Nothing in the data may end the script that holds it.
  for (std::size_t at = data.find("</"); at != std::string::npos; at = data.find("</", at)) data.replace(at, 2, "<\\/");
  std::string page(report_page());
  const std::string mark = "/*DATA*/[]";
  page.replace(page.find(mark), mark.size(), data);
  return page;
}

}  // namespace thinwall

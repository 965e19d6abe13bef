#include "studio/golden/GoldenVideoApproval.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVideoApprovalVersion = 1;

std::string driver_hash(const std::string& driver) {
  return fmt::format("{:08x}", static_cast<std::uint32_t>(XXH3_64bits(driver.data(), driver.size())));
}

std::filesystem::path file_of(const std::filesystem::path& folder, const std::string& driver) {
  return folder / ("video." + driver_hash(driver) + ".json");
}

Json to_json(const EncodedVideo& encoded) {
  return {{"program", encoded.program},  {"decoded", encoded.decoded},   {"tags", encoded.tags},
          {"frames", encoded.frames},    {"captions", encoded.captions}, {"chapters", encoded.chapters},
          {"loss_levels", encoded.loss}, {"drift", encoded.drift}};
}

EncodedVideo to_encoded(const Json& json) {
  EncodedVideo encoded;
  encoded.program = json.at("program");
  encoded.decoded = json.at("decoded");
  encoded.tags = json.at("tags");
  encoded.frames = json.at("frames");
  encoded.captions = json.at("captions");
  encoded.chapters = json.at("chapters");
  encoded.loss = json.at("loss_levels");
  encoded.drift = json.at("drift");
  return encoded;
}

Json to_json(const GoldenVideoApproval& approval, const std::string& history) {
  const GoldenVideo& video = approval.video;
  Json frames = Json::array();
  for (const VideoFrameRecord& frame : video.frames) frames.push_back(frame.hash + " " + frame.squares);
  Json kept = Json::array();
  for (std::size_t i = 0; i < video.kept.size(); ++i) {
    kept.push_back({{"frame", video.kept[i]}, {"image", approval.pictures[i]}});
  }
  return {{"video_approval_version", kVideoApprovalVersion},
          {"driver", video.driver},
          {"who", approval.who},
          {"why", approval.why},
          {"size", {video.size.width, video.size.height}},
          {"frames_per_second", video.frames_per_second},
          {"state_digest", video.state_digest},
          {"second_state_digest", video.second_state_digest},
          {"scene_hash", video.scene_hash},
          {"history", history},
          {"files", video.files.empty() ? Json::object() : Json::parse(video.files)},
          {"captions", video.captions},
          {"kept", kept},
          {"encoded", to_json(video.encoded)},
          {"frames", frames},
          {"resolved", Json::parse(video.resolved, nullptr, false)}};
}

/// One of so many frames.
std::size_t to_frame(const Json& number, std::size_t frames, const std::filesystem::path& file) {
  const bool is_there = number.is_number_unsigned() && number.get<std::size_t>() < frames;
  if (!is_there) throw damaged_golden(file.string() + ": is damaged (it keeps a frame " + number.dump() + ")");
  return number;
}

GoldenVideoApproval to_approval(const Json& json, const std::filesystem::path& file) {
  GoldenVideoApproval approval;
  GoldenVideo& video = approval.video;
  video.driver = json.at("driver");
  approval.who = json.at("who");
  approval.why = json.at("why");
  video.size = {.width = json.at("size").at(0), .height = json.at("size").at(1)};
  video.frames_per_second = json.at("frames_per_second");
  video.state_digest = json.at("state_digest");
  video.second_state_digest = json.value("second_state_digest", "");
  video.scene_hash = json.at("scene_hash");
  video.history = bytes_of_file(file.parent_path() / json.at("history").get<std::string>());
  if (json.contains("files")) video.files = json.at("files").dump();
  video.captions = json.at("captions");
  video.encoded = to_encoded(json.at("encoded"));
  for (const Json& frame : json.at("frames")) {
    const std::string text = frame;
    const std::size_t space = text.find(' ');
    video.frames.push_back({.hash = text.substr(0, space), .squares = text.substr(std::min(text.size(), space + 1))});
  }
  for (const Json& kept : json.at("kept")) {
    video.kept.push_back(to_frame(kept.at("frame"), video.frames.size(), file));
    approval.pictures.push_back(kept.at("image"));
  }
  video.resolved = json.at("resolved").dump();
  return approval;
}

GoldenVideoApproval read_approval(const std::filesystem::path& file) {
  try {
    const Json json = Json::parse(approval_text(file));
    if (json.at("video_approval_version") != kVideoApprovalVersion) {
      throw GoldenError(file.string() + ": written by another version of the program");
    }
    GoldenVideoApproval approval = to_approval(json, file);
    approval.files = approval.pictures;
    approval.history = json.at("history");
    approval.files.push_back(approval.history);
    approval.files.push_back(file.filename().string());
    return approval;
  } catch (const Json::exception& error) {
    throw damaged_golden(file.string() + ": is damaged (" + error.what() + ")");
  }
}

}  // namespace

std::vector<GoldenVideoApproval> read_video_approvals(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("video.") && name.ends_with(".json")) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<GoldenVideoApproval> approvals;
  for (const std::filesystem::path& file : files) approvals.push_back(read_approval(file));
  return approvals;
}

std::optional<GoldenVideoApproval> find_video_approval(const std::filesystem::path& folder, const std::string& driver) {
  const std::vector<GoldenVideoApproval> approvals = read_video_approvals(folder);
  if (approvals.empty()) return std::nullopt;
  const auto same = std::find_if(approvals.begin(), approvals.end(),
                                 [&](const GoldenVideoApproval& one) { return one.video.driver == driver; });
  return same != approvals.end() ? *same : approvals.front();
}

void renew_golden_video(const RecordedVideo& recorded, const std::filesystem::path& folder, const std::string& who,
                        const std::string& why) {
  make_folder(folder);
  const GoldenVideo& video = recorded.video;
  const std::string hash = driver_hash(video.driver);
  std::vector<std::string> outdated;
  for (const GoldenVideoApproval& before : read_video_approvals(folder)) {
    if (before.video.driver == video.driver) outdated = before.pictures;
  }
  GoldenVideoApproval approval{.video = video, .pictures = {}, .who = who, .why = why};
  for (std::size_t i = 0; i < video.kept.size(); ++i) {
    approval.pictures.push_back(fmt::format("video_{:06}.{}.png", video.kept[i], hash));
    write_png(folder / approval.pictures.back(), recorded.pictures[i], PngEffort::kSmall);
    std::erase(outdated, approval.pictures.back());
  }
  const std::string history = "video." + hash + ".history.csv";
  write_whole_file(folder / history, video.history);
  write_whole_file(file_of(folder, video.driver),
                   to_json(approval, history).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  std::error_code ignored;
  for (const std::string& name : outdated) std::filesystem::remove(folder / name, ignored);
}

}  // namespace thinwall

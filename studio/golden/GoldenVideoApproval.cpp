#include "studio/golden/GoldenVideoApproval.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "renderer/image/Folder.hpp"
#include "renderer/image/PngFile.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/golden/ApprovalFile.hpp"

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

EncodedVideo to_encoded(const ApprovalValue& value) {
  EncodedVideo encoded;
  encoded.program = value.text("program");
  encoded.decoded = value.text("decoded");
  encoded.tags = value.text("tags");
  encoded.frames = value.count("frames");
  encoded.captions = value.text("captions");
  encoded.chapters = value.text("chapters");
  encoded.loss = value.number("loss_levels");
  encoded.drift = value.number("drift");
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

ImageSize to_size(const ApprovalValue& value) {
  const std::vector<ApprovalValue> sides = value.as_list();
  if (sides.size() != 2) value.refuse("expected width and height");
  return {.width = static_cast<int>(sides[0].as_count()), .height = static_cast<int>(sides[1].as_count())};
}

/// One of so many frames.
std::size_t to_frame(const ApprovalValue& value, std::size_t frames) {
  const std::size_t frame = value.as_count();
  if (frame >= frames) value.refuse(fmt::format("it keeps frame {} of {}, counted from 0", frame, frames));
  return frame;
}

VideoFrameRecord to_frame_record(const std::string& text) {
  const std::size_t space = text.find(' ');
  return {.hash = text.substr(0, space), .squares = text.substr(std::min(text.size(), space + 1))};
}

GoldenVideoApproval to_approval(const ApprovalValue& root, const std::filesystem::path& folder) {
  GoldenVideoApproval approval;
  GoldenVideo& video = approval.video;
  video.driver = root.text("driver");
  approval.who = root.text("who");
  approval.why = root.text("why");
  video.size = to_size(root.at("size"));
  video.frames_per_second = root.number("frames_per_second");
  video.state_digest = root.text("state_digest");
  video.second_state_digest = root.text_if_there("second_state_digest");
  video.scene_hash = root.text("scene_hash");
  approval.history = root.text("history");
  video.history = bytes_of_file(folder / approval.history);
  if (root.has("files")) video.files = root.dump("files");
  video.captions = root.text("captions");
  video.encoded = to_encoded(root.at("encoded"));
  for (const std::string& frame : root.texts("frames")) video.frames.push_back(to_frame_record(frame));
  for (const ApprovalValue& kept : root.list("kept")) {
    video.kept.push_back(to_frame(kept.at("frame"), video.frames.size()));
    approval.pictures.push_back(kept.text("image"));
  }
  video.resolved = root.dump("resolved");
  return approval;
}

GoldenVideoApproval read_approval(const std::filesystem::path& file) {
  const ApprovalFile approved(file, "video_approval_version", kVideoApprovalVersion);
  GoldenVideoApproval approval = to_approval(approved.root(), file.parent_path());
  approval.files = approval.pictures;
  approval.files.push_back(approval.history);
  approval.files.push_back(file.filename().string());
  return approval;
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

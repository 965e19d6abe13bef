#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "renderer/device/DeviceSurvey.hpp"
#include "renderer/video/VideoSurvey.hpp"
#include "studio/commands/Commands.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/commands/JsonAnswer.hpp"
#include "studio/commands/StandardOutput.hpp"
#include "studio/recorder/Versions.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const SurveyedDevice& device) {
  return {{"index", device.index},          {"file", device.file},
          {"vendor", device.vendor},        {"renderer", device.renderer},
          {"version", device.version},      {"software", device.software},
          {"usable", device.usable},        {"used", device.used},
          {"refusal", device.refusal},      {"cure", device.cure},
          {"extensions", device.extensions}};
}

Json to_json(const DeviceSurvey& devices, const VideoSurvey& video, int exit_code) {
  Json list = Json::array();
  for (const SurveyedDevice& device : devices.devices) list.push_back(to_json(device));
  Json versions = Json::object();
  for (const auto& [name, version] : component_versions()) versions[name] = version;
  return {{"pictures",
           {{"egl", devices.egl_present}, {"devices", list}, {"problem", devices.problem}, {"cure", devices.cure}}},
          {"video",
           {{"ffmpeg", video.ffmpeg_version},
            {"ffprobe", video.ffprobe_version},
            {"libx264", video.libx264},
            {"problem", video.problem}}},
          {"versions", versions},
          {"licence", effective_licence()},
          {"exit_code", exit_code}};
}

void print_for_people(const DeviceSurvey& devices, const VideoSurvey& video) {
  say_result(describe(devices));
  if (video.problem.empty()) {
    say_result(fmt::format("Video: {}, with libx264\n", video.ffmpeg_version));
  } else {
    say_result(fmt::format("Video: {}\n", video.problem));
  }
  for (const auto& [name, version] : component_versions()) say_result(fmt::format("{}: {}\n", name, version));
  say_result(fmt::format("Licence of this build: {}\n", effective_licence()));
}

}  // namespace

int examine_machine(const DoctorOptions& options) {
  const DeviceSurvey devices = survey_devices(options.device);
  const VideoSurvey video = survey_video();
  const int exit_code = devices.problem.empty() && video.problem.empty() ? kExitGood : kExitNoPicture;
  if (options.json) {
    print_json(to_json(devices, video, exit_code));
  } else {
    print_for_people(devices, video);
  }
  return exit_code;
}

}  // namespace thinwall

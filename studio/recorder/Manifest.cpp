#include "studio/recorder/Manifest.hpp"

#include <sys/resource.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "studio/recorder/Versions.hpp"
#include "studio/schema/ExpectationQuantity.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kManifestVersion = 1;

Json scenario_part(const TakeDescription& description) {
  Json scenario = {{"name", description.name}, {"title", description.title}};
  scenario["hash"] = text_hash(description.resolved);
  scenario["resolved"] = Json::parse(description.resolved);
  return scenario;
}

Json version_part(const RecordingReport& report) {
  Json versions = Json::object();
  for (const auto& [name, version] : component_versions()) versions[name] = version;
  if (!report.encoder.empty()) versions["ffmpeg"] = report.encoder;
  return versions;
}

Json option_part(const ManifestContext& context, const RecordingPlan& plan) {
  Json overrides = Json::object();
  for (const auto& [name, value] : context.overrides) overrides[name] = value;
  return {{"set", overrides},
          {"device", context.device},
          {"size", {plan.size.width, plan.size.height}},
          {"fps", plan.frames_per_second},
          {"render", plan.pictures},
          {"video", plan.pictures && plan.video},
          {"frames", plan.pictures && plan.frames},
          {"surfaces", plan.surfaces},
          {"ground_truth", plan.pictures && plan.ground_truth}};
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double processor_seconds(int whose) {
  struct rusage usage = {};
  getrusage(whose, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Json time_part(const ManifestContext& context, const RecordingReport& report) {
  const auto stage = [](const StageTime& time) { return Json{{"wall_s", time.wall}, {"processor_s", time.processor}}; };
  const RecordingTimes& times = report.times;
  return {{"prepare", {{"wall_s", context.preparation}}},
          {"simulate", stage(times.simulate)},
          {"write", stage(times.write)},
          {"render", stage(times.render)},
          {"ground_truth", stage(times.truth)},
          {"encode", stage(times.encode)},
          {"total",
           {{"wall_s", times.total},
            {"processor_s", processor_seconds(RUSAGE_SELF)},
            {"encoder_processor_s", processor_seconds(RUSAGE_CHILDREN)}}},
          {"wall_s_per_simulated_s", report.simulated > 0 ? Json(times.total / report.simulated) : Json(nullptr)}};
}

/// Nothing but the noise of cameras draws random numbers.
Json seed_part(const ViewDefinition& view) {
  std::map<std::string, const CameraDefinition*> cameras = {{"main", &view.camera}};
  for (const auto& [name, camera] : view.cameras) cameras[name] = &camera;
  std::erase_if(cameras, [](const auto& camera) { return camera.second->noise == 0; });
  if (cameras.empty()) return nullptr;
  Json seeds = Json::object();
  for (const auto& [name, camera] : cameras) seeds[name] = camera->seed;
  const bool is_one = std::ranges::all_of(seeds, [&](const Json& seed) { return seed == seeds.front(); });
  return is_one ? seeds.front() : seeds;
}

Json file_part(const std::filesystem::path& folder) {
  constexpr std::array kNames = {"forces.csv",   "body.csv",     "points.csv", "chambers.csv",      "take.h5",
                                 "video.mp4",    "captions.vtt", "poster.png", "contact_sheet.png", "forces.png",
                                 "energies.png", "frames",       "surfaces",   "ground_truth",      "second_take"};
  Json files = Json::array();
  for (const char* name : kNames) {
    if (std::filesystem::exists(folder / name)) files.push_back(name);
  }
  return files;
}

}  // namespace

std::string result_words(const ManifestContext& context, const RecordingReport& report) {
  if (!report.failure.empty()) return "the simulation failed";
  if (!context.take_complete) return "the take ends early";
  const bool met = std::ranges::all_of(context.expectations, &ExpectationResult::passed);
  return met ? "ok" : "an expectation failed";
}

std::vector<std::string> all_warnings(const ManifestContext& context, const RecordingReport& report) {
  std::vector<std::string> all = context.warnings;
  all.insert(all.end(), report.warnings.begin(), report.warnings.end());
  return all;
}

Json expectation_part(const std::vector<ExpectationResult>& results) {
  Json part = Json::array();
  for (const ExpectationResult& result : results) {
    const Expectation& expectation = result.expectation;
    const MeasuredQuantity& measured = *find_expectation_quantity(expectation.quantity).measured;
    Json row = {{"quantity", expectation.quantity}};
    row[std::string(subject_word(measured.subject))] = expectation.subject;
    if (!expectation.chamber.empty()) row["chamber"] = expectation.chamber;
    if (expectation.at) row["at_s"] = *expectation.at;
    if (expectation.from) row["from_s"] = *expectation.from;
    if (expectation.until) row["until_s"] = *expectation.until;
    row["unit"] = si_unit(measured.dimension);
    row["value"] = result.value ? Json(*result.value) : Json(nullptr);
    row["within"] = {expectation.lowest, expectation.highest};
    row["passed"] = result.passed;
    part.push_back(std::move(row));
  }
  return part;
}

std::string text_hash(const std::string& text) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(text.data(), text.size()));
  std::string digits;
  for (const unsigned char byte : canonical.digest) {
    constexpr const char* kDigits = "0123456789abcdef";
    digits += kDigits[byte >> 4];
    digits += kDigits[byte & 15];
  }
  return digits;
}

std::string manifest(const ManifestContext& context, const RecordingPlan& plan, const RecordingReport& report) {
  Json manifest;
  manifest["manifest_version"] = kManifestVersion;
  manifest["command"] = context.command;
  manifest["source"] = context.source.generic_string();
  manifest["result"] = result_words(context, report);
  manifest["complete"] = report.failure.empty() && context.take_complete;
  if (!report.failure.empty()) manifest["failure"] = report.failure;
  manifest["steps"] = report.steps;
  manifest["simulated_s"] = report.simulated;
  manifest["frames"] = report.frame_hashes.size();
  manifest["warnings"] = all_warnings(context, report);
  manifest["expectations"] = expectation_part(context.expectations);
  manifest["state_digest"] = report.state_digest;
  manifest["files"] = file_part(plan.folder);
  manifest["times"] = time_part(context, report);
  manifest["options"] = option_part(context, plan);
  manifest["seed"] = seed_part(plan.view);
  manifest["driver"] = report.driver.empty() ? Json(nullptr) : Json(report.driver);
  manifest["versions"] = version_part(report);
  manifest["licence"] = effective_licence();
  manifest["scenario"] = scenario_part(plan.description);
  manifest["frame_hashes"] = report.frame_hashes;
  // Names of the user may hold bytes that are no UTF-8.
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace thinwall

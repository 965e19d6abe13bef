#include "studio/golden/GoldenCache.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer/image/Folder.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/golden/NamedFiles.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

std::string hash_of(const std::string& bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

Json to_json(const GoldenResult& result) {
  return {{"at_s", result.at},
          {"is_video", result.is_video},
          {"rung", result.rung},
          {"message", result.message},
          {"driver", result.driver},
          {"golden_driver", result.golden_driver},
          {"largest", result.difference.largest},
          {"mean", result.difference.mean},
          {"drift", result.drift.channels}};
}

GoldenResult to_result(const Json& json, const std::string& scenario) {
  GoldenResult result;
  result.scenario = scenario;
  result.at = json.at("at_s");
  result.is_video = json.at("is_video");
  result.rung = json.at("rung");
  result.message = json.at("message");
  result.driver = json.at("driver");
  result.golden_driver = json.at("golden_driver");
  result.difference.largest = json.at("largest");
  result.difference.mean = json.at("mean");
  result.drift.channels = json.at("drift");
  return result;
}

}  // namespace

std::string file_hash(const std::filesystem::path& file) {
  const std::string bytes = bytes_of_file(file);
  return bytes.empty() ? "" : hash_of(bytes);
}

GoldenCache::GoldenCache(const std::filesystem::path& file, std::string program) : program_(std::move(program)) {
  take_over(file);
}

void GoldenCache::take_over(const std::filesystem::path& file) {
  const Json json = Json::parse(bytes_of_file(file), nullptr, false);
  if (!json.is_object()) return;
  std::map<std::string, Entry> entries;
  try {
    for (const auto& [scenario, stored] : json.items()) {
      Entry entry{.key = stored.at("key"), .results = {}};
      for (const Json& result : stored.at("results")) entry.results.push_back(to_result(result, scenario));
      entries[scenario] = std::move(entry);
    }
  } catch (const Json::exception&) {
    // Of another version: everything is made anew.
    return;
  }
  for (auto& [scenario, entry] : entries) entries_[scenario] = std::move(entry);
}

std::string GoldenCache::key(const Scenario& scenario, const std::filesystem::path& goldens) const {
  std::string parts = program_ + "\n" + scenario.resolved + "\n";
  for (const auto& [name, hash] : named_files(scenario)) {
    if (hash.empty()) return "";
    parts += name + " " + hash + "\n";
  }
  std::set<std::filesystem::path> approved;
  if (std::filesystem::is_directory(goldens)) {
    for (const auto& entry : std::filesystem::directory_iterator(goldens)) approved.insert(entry.path());
  }
  for (const std::filesystem::path& path : approved) parts += path.filename().string() + " " + file_hash(path) + "\n";
  return hash_of(parts);
}

std::vector<GoldenResult> GoldenCache::find(const Scenario& scenario, const std::string& key) const {
  const auto entry = entries_.find(scenario.name);
  if (key.empty() || entry == entries_.end() || entry->second.key != key) return {};
  return entry->second.results;
}

void GoldenCache::keep(const Scenario& scenario, const std::string& key, const std::vector<GoldenResult>& results) {
  entries_.erase(scenario.name);
  const bool all_ok = std::all_of(results.begin(), results.end(),
                                  [](const GoldenResult& result) { return result.outcome == GoldenOutcome::kOk; });
  if (!key.empty() && all_ok) entries_[scenario.name] = {.key = key, .results = results};
}

void GoldenCache::forget(const Scenario& scenario) {
  entries_.erase(scenario.name);
}

void GoldenCache::write_to(const std::filesystem::path& file) const {
  Json json = Json::object();
  for (const auto& [scenario, entry] : entries_) {
    Json results = Json::array();
    for (const GoldenResult& result : entry.results) results.push_back(to_json(result));
    json[scenario] = {{"key", entry.key}, {"results", results}};
  }
  if (file.has_parent_path()) make_folder(file.parent_path());
  write_whole_file(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace thinwall

#include "studio/golden/NamedFiles.hpp"

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer/image/WholeFile.hpp"
#include "studio/golden/GoldenCache.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

/// Every file that a scenario names stands under one of these keys.
void collect_files(const Json& json, std::set<std::string>& files) {
  if (!json.is_structured()) return;
  for (const auto& [name, value] : json.items()) {
    if (value.is_string() && (name == "mesh" || name == "file")) files.insert(value.get<std::string>());
    collect_files(value, files);
  }
}

/// "organ%20one.bin" -> "organ one.bin"
std::string without_escapes(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    int letter = 0;
    const char* digits = uri.data() + i + 1;
    const bool is_escape =
        uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, letter, 16).ptr == digits + 2;
    name += is_escape ? static_cast<char>(letter) : uri[i];
    if (is_escape) i += 2;
  }
  return name;
}

/// The numbers of a glTF mesh may stand in files of their own.
std::set<std::string> buffers_of(const std::string& name, const std::filesystem::path& file) {
  std::set<std::string> files;
  if (file.extension() != ".gltf") return files;
  const Json json = Json::parse(bytes_of_file(file), nullptr, false);
  if (!json.is_object() || !json.contains("buffers") || !json["buffers"].is_array()) return files;
  for (const Json& buffer : json["buffers"]) {
    if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
    const auto uri = buffer["uri"].get<std::string>();
    if (!uri.starts_with("data:"))
      files.insert((std::filesystem::path(name).parent_path() / without_escapes(uri)).string());
  }
  return files;
}

/// The names of those whose content is not that of the record before, separated by commas; of all where that is empty.
std::string changed_files(const std::string& before, const std::string& today) {
  if (today.empty()) return "";
  const Json known = before.empty() ? Json::object() : Json::parse(before, nullptr, false);
  const Json now = Json::parse(today);
  std::string text;
  for (const auto& [name, hash] : now.items()) {
    // One that the golden's scenario did not name is a change of the scenario.
    if (!before.empty() && (!known.contains(name) || known[name] == hash)) continue;
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

std::map<std::string, std::string> named_files(const Scenario& scenario) {
  std::set<std::string> names;
  collect_files(Json::parse(scenario.resolved, nullptr, false), names);
  if (scenario.comparison) collect_files(Json::parse(scenario.comparison->second->resolved, nullptr, false), names);
  // An absolute name stays what it is.
  const auto place = [&](const std::string& name) { return scenario.file.parent_path() / name; };
  for (const std::string& name : std::set<std::string>(names)) names.merge(buffers_of(name, place(name)));
  std::map<std::string, std::string> files;
  for (const std::string& name : names) files[name] = file_hash(place(name));
  return files;
}

std::string named_files_record(const Scenario& scenario) {
  const std::map<std::string, std::string> files = named_files(scenario);
  return files.empty() ? "" : Json(files).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string told_cause_of_physics(const std::string& files_before, const std::string& files_today,
                                  const std::string& asked) {
  const std::string files = changed_files(files_before, files_today);
  if (!files.empty() && !files_before.empty()) {
    return "; " + files + ", which the scenario names, has changed" +
           (asked.empty() ? "" : "; the scenario has changed: " + asked);
  }
  if (!asked.empty()) return "; the scenario has changed: " + asked;
  return "; the scenario asks for the same, so the engine has changed" + (files.empty() ? "" : ", or " + files);
}

}  // namespace thinwall

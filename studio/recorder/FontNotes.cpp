#include "studio/recorder/FontNotes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "renderer/overlay/Letters.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

using Json = nlohmann::ordered_json;

/// The keys whose texts are written over pictures. Those of chapters and of goldens' reasons are not.
constexpr std::array<std::string_view, 4> kShown{"title", "caption", "captions", "text"};

void look_through(const std::string& file, const Json& value, const std::string& path, bool is_shown,
                  std::vector<std::string>& notes) {
  if (value.is_string() && is_shown) {
    const std::string missing = letters_without_shape(value.get<std::string>());
    if (missing.empty()) return;
    notes.push_back(fmt::format("{}: warning: {}: the font of pictures has no shape for {}, so boxes stand there", file,
                                path, spelled_out(missing)));
  }
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      look_through(file, value[i], fmt::format("{}[{}]", path, i + 1), is_shown, notes);
    }
  }
  if (!value.is_object()) return;
  for (const auto& [key, part] : value.items()) {
    look_through(file, part, path.empty() ? key : path + "." + key, std::ranges::find(kShown, key) != kShown.end(),
                 notes);
  }
}

}  // namespace

std::vector<std::string> font_notes(const Scenario& scenario) {
  std::vector<std::string> notes;
  look_through(scenario.file.string(), Json::parse(scenario.resolved, nullptr, false), "", false, notes);
  return notes;
}

}  // namespace thinwall

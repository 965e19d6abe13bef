#include "studio/scenario/ResolvedScenario.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace thinwall {
namespace {

nlohmann::ordered_json to_json(const CheckedValue& value, const std::filesystem::path& folder) {
  switch (value.kind) {
    case CheckedKind::kBoolean:
      return value.boolean;
    case CheckedKind::kInteger:
      return static_cast<std::int64_t>(value.number);
    case CheckedKind::kNumber:
      return value.number;
    case CheckedKind::kText:
      return value.text;
    case CheckedKind::kPath: {
      const std::filesystem::path path(value.text);
      const bool is_elsewhere = path.is_absolute() != folder.is_absolute();
      return is_elsewhere ? path.generic_string() : path.lexically_relative(folder).generic_string();
    }
    case CheckedKind::kList: {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const CheckedValue& item : value.items) list.push_back(to_json(item, folder));
      return list;
    }
    case CheckedKind::kMapping:
      break;
  }
  nlohmann::ordered_json mapping = nlohmann::ordered_json::object();
  for (const CheckedMember& member : value.members) mapping[member.key] = to_json(member.value, folder);
  return mapping;
}

}  // namespace

std::string resolved_scenario(const CheckedValue& root, const std::filesystem::path& folder) {
  const std::filesystem::path base = folder.empty() ? std::filesystem::path(".") : folder.lexically_normal();
  return to_json(root, base).dump(2) + "\n";
}

}  // namespace thinwall

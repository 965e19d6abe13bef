#include "studio/scenario/NameCheck.hpp"

#include <algorithm>

#include "studio/scenario/Wording.hpp"

namespace thinwall {

std::vector<std::string> names_in(const CheckedValue& root, std::string_view section) {
  std::vector<std::string> names;
  const CheckedValue* mapping = root.find(section);
  if (mapping == nullptr) return names;
  for (const CheckedMember& member : mapping->members) names.push_back(member.key);
  return names;
}

void check_name(const WrittenName& name, const std::string& what, const std::vector<std::string>& names,
                const std::string& path, Diagnostics& diagnostics) {
  if (std::ranges::find(names, name.text) != names.end()) return;
  std::string hint = did_you_mean(name.text, names);
  if (hint.empty()) hint = names.empty() ? "; there is none" : "; there is " + list_in_backticks(names);
  diagnostics.absence(name.location, path, "there is no " + what + " " + in_backticks(name.text) + hint);
}

void resolve_name(CheckedValue& mapping, const std::string& key, const std::vector<std::string>& names,
                  const std::string& path, Diagnostics& diagnostics) {
  if (mapping.has_wrong(key)) return;
  if (const CheckedValue* name = mapping.find(key)) {
    check_name({name->text, name->location}, key, names, path + "." + key, diagnostics);
  } else if (names.size() == 1) {
    const CheckedValue only{
        .kind = CheckedKind::kText, .location = mapping.location, .given = false, .text = names.front()};
    mapping.members.insert(mapping.members.begin(), {key, mapping.location, only});
  } else {
    diagnostics.absence(mapping.location, path,
                        names.empty() ? "needs a " + key + ", but there is none"
                                      : in_backticks(key) + " is missing; there is " + list_in_backticks(names));
  }
}

}  // namespace thinwall

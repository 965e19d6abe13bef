#include "studio/scenario/NameCheck.hpp"

#include <algorithm>
#include <utility>

#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

bool is_scenery(const CheckedValue& body) {
  const CheckedValue* fixed = body.find("fixed");
  return fixed != nullptr && std::ranges::any_of(fixed->items, [](const CheckedValue& part) {
           const CheckedValue *region = part.find("region"), *axes = part.find("axes");
           return region != nullptr && region->find("all") != nullptr && axes != nullptr && axes->text == "xyz";
         });
}

}  // namespace

NameChoice choice_of(std::vector<std::string> names) {
  NameChoice choice{.names = std::move(names)};
  if (choice.names.size() == 1) choice.meant = choice.names.front();
  return choice;
}

NameChoice choice_of_bodies(const CheckedValue& root) {
  NameChoice choice = choice_of(names_in(root, "bodies"));
  if (choice.names.size() < 2) return choice;
  std::vector<std::string> others;
  for (const CheckedMember& body : root.find("bodies")->members) {
    if (!is_scenery(body.value)) others.push_back(body.key);
  }
  choice.meant = choice_of(std::move(others)).meant;
  return choice;
}

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

void resolve_name(CheckedValue& mapping, const std::string& key, const NameChoice& choice, const std::string& path,
                  Diagnostics& diagnostics) {
  if (mapping.has_wrong(key)) return;
  if (const CheckedValue* name = mapping.find(key)) {
    check_name({name->text, name->location}, key, choice.names, path + "." + key, diagnostics);
  } else if (!choice.meant.empty()) {
    const CheckedValue only{
        .kind = CheckedKind::kText, .location = mapping.location, .given = false, .text = choice.meant};
    mapping.members.insert(mapping.members.begin(), {key, mapping.location, only});
  } else {
    diagnostics.absence(mapping.location, path,
                        choice.names.empty()
                            ? "needs a " + key + ", but there is none"
                            : in_backticks(key) + " is missing; there is " + list_in_backticks(choice.names));
  }
}

}  // namespace thinwall

#include "studio/scenario/TeachingReferences.hpp"

#include "studio/scenario/NameCheck.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {
namespace {

void check_span(const CheckedValue& shown, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* from = shown.find("from");
  const CheckedValue* until = shown.find("until");
  if (from == nullptr || until == nullptr || until->number >= from->number) return;
  diagnostics.error(until->location, path + ".until", "must not be before `from`");
}

void check_slow_motions(const CheckedValue& slow_motions, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < slow_motions.items.size(); ++i) {
    const CheckedValue* from = slow_motions.items[i].find("from");
    const CheckedValue* until = slow_motions.items[i].find("until");
    if (from == nullptr || until == nullptr) continue;
    const std::string path = item_path("teaching.slow_motion", i);
    if (until->number <= from->number) {
      diagnostics.error(until->location, path + ".until", "must be later than `from`");
    }
    const CheckedValue* before = i > 0 ? slow_motions.items[i - 1].find("until") : nullptr;
    if (before != nullptr && from->number < before->number) {
      diagnostics.error(from->location, path + ".from", "must not be before the end of the one before it");
    }
  }
}

}  // namespace

void teaching_references(CheckedValue& root, Diagnostics& diagnostics) {
  CheckedValue* teaching = root.find("teaching");
  if (teaching == nullptr) return;
  const NameChoice bodies = choice_of_bodies(root), tools = choice_of(names_in(root, "tools"));
  for (const char* kind : {"labels", "arrows", "highlights", "force_arrows"}) {
    CheckedValue* list = teaching->find(kind);
    if (list == nullptr) continue;
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      CheckedValue& item = list->items[i];
      if (item.members.empty()) continue;
      const std::string path = item_path(std::string("teaching.") + kind, i);
      const bool is_of_tool = kind == std::string("force_arrows");
      resolve_name(item, is_of_tool ? "tool" : "body", is_of_tool ? tools : bodies, path, diagnostics);
      check_span(item, path, diagnostics);
    }
  }
  if (const CheckedValue* slow = teaching->find("slow_motion")) check_slow_motions(*slow, diagnostics);
}

}  // namespace thinwall

#include "studio/scenario/CheckedReading.hpp"

namespace thinwall {

Eigen::Vector3d to_vector(const CheckedValue& list) {
  return {list.items[0].number, list.items[1].number, list.items[2].number};
}

std::optional<Eigen::Vector3d> find_vector(const CheckedValue& mapping, std::string_view key) {
  const CheckedValue* list = mapping.find(key);
  return list == nullptr || list->items.size() != 3 ? std::nullopt : std::optional(to_vector(*list));
}

std::optional<std::string> find_text(const CheckedValue& mapping, std::string_view key) {
  const CheckedValue* text = mapping.find(key);
  return text == nullptr ? std::nullopt : std::optional(text->text);
}

std::optional<double> find_number(const CheckedValue& mapping, std::string_view key) {
  const CheckedValue* number = mapping.find(key);
  return number == nullptr ? std::nullopt : std::optional(number->number);
}

}  // namespace thinwall

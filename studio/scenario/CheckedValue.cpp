#include "studio/scenario/CheckedValue.hpp"

#include <algorithm>
#include <cassert>

namespace thinwall {

const CheckedValue* CheckedValue::find(std::string_view key) const {
  for (const CheckedMember& member : members) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

CheckedValue* CheckedValue::find(std::string_view key) {
  return const_cast<CheckedValue*>(static_cast<const CheckedValue*>(this)->find(key));
}

const CheckedValue& CheckedValue::at(std::string_view key) const {
  const CheckedValue* value = find(key);
  assert(value != nullptr);
  return *value;
}

bool CheckedValue::has_wrong(std::string_view key) const {
  return std::ranges::find(wrong_keys, key) != wrong_keys.end();
}

}  // namespace thinwall

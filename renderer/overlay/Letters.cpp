#include "renderer/overlay/Letters.hpp"

#include "renderer/overlay/Text.hpp"

namespace thinwall {

std::string letters_without_shape(const std::string& text) {
  if (g_utf8_validate(text.c_str(), -1, nullptr) == FALSE || Text(text, {}).unknown_letters() == 0) return "";
  std::string found;
  for (const char* at = text.c_str(); *at != '\0'; at = g_utf8_next_char(at)) {
    const std::string letter(at, static_cast<const char*>(g_utf8_next_char(at)));
    if (Text(letter, {}).unknown_letters() > 0 && found.find(letter) == std::string::npos) found += letter;
  }
  return found;
}

}  // namespace thinwall

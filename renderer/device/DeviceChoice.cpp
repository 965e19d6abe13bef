#include "renderer/device/DeviceChoice.hpp"

#include <charconv>
#include <stdexcept>

namespace thinwall {

DeviceChoice parse_device_choice(const std::string& text) {
  if (text == "auto") return {};
  if (text == "software") return {.preference = DevicePreference::kSoftware};
  if (text == "gpu") return {.preference = DevicePreference::kGpu};
  int index = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, index);
  if (error == std::errc{} && stop == end && index >= 0) return {DevicePreference::kIndex, index};
  throw std::invalid_argument("device '" + text +
                              "' is none of: auto, software, gpu, or the number of an EGL device as "
                              "`thinwall doctor` lists them (0, 1, ...)");
}

}  // namespace thinwall

#pragma once

#include <string>

namespace thinwall {

enum class DevicePreference { kAutomatic, kSoftware, kGpu, kIndex };

/// What the user asked for: `--device auto|software|gpu|N`.
struct DeviceChoice {
  DevicePreference preference = DevicePreference::kAutomatic;
  int index = 0;  // of the EGL device, with kIndex
};

/// Reads `auto`, `software`, `gpu` or a number. Throws std::invalid_argument with the allowed words.
DeviceChoice parse_device_choice(const std::string& text);

}  // namespace thinwall

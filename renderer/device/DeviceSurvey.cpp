#include "renderer/device/DeviceSurvey.hpp"

#include <algorithm>
#include <sstream>

#include "renderer/device/EglDevices.hpp"
#include "renderer/device/OffscreenContext.hpp"

namespace thinwall {
namespace {

std::string name_of(const SurveyedDevice& device) {
  return device.index < 0 ? "surfaceless platform" : "EGL device " + std::to_string(device.index);
}

std::string words_of(const DeviceChoice& choice) {
  switch (choice.preference) {
    case DevicePreference::kAutomatic:
      return "auto";
    case DevicePreference::kSoftware:
      return "software";
    case DevicePreference::kGpu:
      return "gpu";
    case DevicePreference::kIndex:
      return std::to_string(choice.index);
  }
  return {};
}

/// Marks the device that `choice` uses and says of the others why not. Returns whether there is one.
bool mark_used(DeviceSurvey& survey, const std::vector<EglDevice>& devices, const DeviceChoice& choice) {
  std::string used;
  for (const std::size_t i : order_of_trial(devices, choice)) {
    SurveyedDevice& device = survey.devices[i];
    if (!device.usable) continue;
    if (!used.empty()) {
      device.refusal = used + " comes first";
      continue;
    }
    device.refusal = refusal_by_choice(device, choice);
    device.used = device.refusal.empty();
    if (device.used) used = name_of(device);
  }
  for (SurveyedDevice& device : survey.devices) {
    if (!device.used && device.refusal.empty()) device.refusal = "--device " + words_of(choice) + " passes it over";
  }
  return !used.empty();
}

void explain_none(DeviceSurvey& survey, const DeviceChoice& choice) {
  survey.problem = "no picture can be made with --device " + words_of(choice);
  if (choice.preference == DevicePreference::kGpu) {
    survey.problem += ": no graphics hardware answers";
    survey.cure = gpu_cure();
  } else if (choice.preference == DevicePreference::kIndex) {
    const auto count = std::count_if(survey.devices.begin(), survey.devices.end(),
                                     [](const SurveyedDevice& device) { return device.index >= 0; });
    const bool exists = choice.index < count;
    survey.problem +=
        exists ? ": that device does not serve"
               : ": EGL knows " + std::to_string(count) + " device" + (count == 1 ? "" : "s") + ", counted from 0";
    survey.cure = "use --device auto, or one of the devices that `thinwall doctor` lists";
  } else {
    survey.cure = "install Mesa: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri";
  }
}

void print_words(std::ostream& out, const char* title, const std::vector<std::string>& words) {
  out << title;
  for (const std::string& word : words) out << ' ' << word;
  out << '\n';
}

}  // namespace

DeviceSurvey survey_devices(const DeviceChoice& choice) {
  const EglLibrary library = list_egl_devices();
  DeviceSurvey survey{.egl_present = library.present, .client_extensions = library.extensions};
  for (const EglDevice& device : library.devices) survey.devices.push_back(try_device(device, nullptr));
  if (!mark_used(survey, library.devices, choice)) {
    explain_none(survey, choice);
    if (!library.problem.empty()) {
      survey.problem += ": " + library.problem;
      survey.cure = library.cure;
    }
  }
  return survey;
}

std::string describe(const DeviceSurvey& survey) {
  std::ostringstream out;
  if (survey.egl_present) print_words(out, "EGL client extensions:", survey.client_extensions);
  for (const SurveyedDevice& device : survey.devices) {
    out << (device.used ? "* " : "  ") << name_of(device) << (device.file.empty() ? "" : ", " + device.file) << ": "
        << (device.used     ? "used"
            : device.usable ? "usable"
                            : "not usable")
        << (device.software ? ", draws with the processor" : "") << '\n';
    if (device.usable) {
      out << "    vendor:   " << device.vendor << "\n    renderer: " << device.renderer
          << "\n    version:  " << device.version << '\n';
    }
    if (device.index >= 0) print_words(out, "    device extensions:", device.extensions);
    if (!device.refusal.empty()) out << "    not used: " << device.refusal << '\n';
    if (!device.cure.empty()) out << "    cure: " << device.cure << '\n';
  }
  if (!survey.problem.empty()) out << survey.problem << "\n  cure: " << survey.cure << '\n';
  return out.str();
}

}  // namespace thinwall

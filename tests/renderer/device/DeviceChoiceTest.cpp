#include "renderer/device/DeviceChoice.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "renderer/device/OffscreenContext.hpp"

namespace thinwall {
namespace {

TEST(DeviceChoice, WordsAndNumbersAreRead) {
  EXPECT_EQ(parse_device_choice("auto").preference, DevicePreference::kAutomatic);
  EXPECT_EQ(parse_device_choice("software").preference, DevicePreference::kSoftware);
  EXPECT_EQ(parse_device_choice("gpu").preference, DevicePreference::kGpu);
  const DeviceChoice third = parse_device_choice("2");
  EXPECT_EQ(third.preference, DevicePreference::kIndex);
  EXPECT_EQ(third.index, 2);
}

TEST(DeviceChoice, AnythingElseIsRefusedWithTheAllowedWords) {
  for (const char* text : {"", "GPU", "-1", "1x", " 1", "99999999999"}) {
    try {
      parse_device_choice(text);
      FAIL() << "'" << text << "' was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "device '" + std::string(text) +
                                  "' is none of: auto, software, gpu, or the number of an EGL device as `thinwall "
                                  "doctor` lists them (0, 1, ...)");
    }
  }
}

/// A software device, two pieces of hardware, the surfaceless platform.
std::vector<EglDevice> some_devices() {
  int somewhere = 0;
  void* handle = &somewhere;
  return {{.index = 0, .handle = handle, .software = true},
          {.index = 1, .handle = handle},
          {.index = 2, .handle = handle},
          {.index = -1}};
}

TEST(OrderOfTrial, HardwareComesBeforeSoftwareAndSoftwareBeforeTheSurfacelessPlatform) {
  EXPECT_EQ(order_of_trial(some_devices(), {}), (std::vector<std::size_t>{1, 2, 0, 3}));
}

TEST(OrderOfTrial, OnlyWhatWasAskedForIsTried) {
  using Order = std::vector<std::size_t>;
  EXPECT_EQ(order_of_trial(some_devices(), parse_device_choice("software")), (Order{0, 3}));
  EXPECT_EQ(order_of_trial(some_devices(), parse_device_choice("gpu")), (Order{1, 2, 3}));
  EXPECT_EQ(order_of_trial(some_devices(), parse_device_choice("2")), (Order{2}));
  EXPECT_EQ(order_of_trial(some_devices(), parse_device_choice("7")), Order{});
}

TEST(RefusalByChoice, GpuNeverTakesAProcessorThatDraws) {
  SurveyedDevice device{.index = -1, .renderer = "llvmpipe", .software = true, .usable = true};
  EXPECT_EQ(refusal_by_choice(device, parse_device_choice("gpu")), "it draws with the processor (llvmpipe)");
  EXPECT_EQ(refusal_by_choice(device, parse_device_choice("auto")), "");
  device = {.index = 0, .renderer = "Some GPU", .usable = true};
  EXPECT_EQ(refusal_by_choice(device, parse_device_choice("software")), "it is hardware (Some GPU)");
  EXPECT_EQ(refusal_by_choice(device, parse_device_choice("gpu")), "");
}

TEST(DescribeSurvey, TheUsedOneIsMarkedAndEveryOtherSaysWhyNotAndWhatHelps) {
  DeviceSurvey survey{.egl_present = true, .client_extensions = {"EGL_EXT_device_base"}};
  survey.devices.push_back({.index = 0,
                            .extensions = {"EGL_EXT_device_drm"},
                            .file = "/dev/dri/card0",
                            .refusal = "its display cannot be opened (EGL error 0x3001)",
                            .cure = "add the user to the groups `video` and `render`"});
  survey.devices.push_back(
      {.index = 1, .vendor = "V", .renderer = "R", .version = "4.6", .usable = true, .used = true});
  EXPECT_EQ(describe(survey),
            "EGL client extensions: EGL_EXT_device_base\n"
            "  EGL device 0, /dev/dri/card0: not usable\n"
            "    device extensions: EGL_EXT_device_drm\n"
            "    not used: its display cannot be opened (EGL error 0x3001)\n"
            "    cure: add the user to the groups `video` and `render`\n"
            "* EGL device 1: used\n"
            "    vendor:   V\n"
            "    renderer: R\n"
            "    version:  4.6\n"
            "    device extensions:\n");
}

}  // namespace
}  // namespace thinwall

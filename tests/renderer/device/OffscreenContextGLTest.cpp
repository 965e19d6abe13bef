#include "renderer/device/OffscreenContext.hpp"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

bool has_hardware() {
  const DeviceSurvey survey = survey_devices({});
  return std::any_of(survey.devices.begin(), survey.devices.end(),
                     [](const SurveyedDevice& device) { return device.usable && !device.software; });
}

TEST(OffscreenContext, GivesOpenGL45AndNamesItsDriver) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current(context);
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(10 * major + minor, 45);
  EXPECT_NE(context.driver().find(reinterpret_cast<const char*>(glGetString(GL_RENDERER))), std::string::npos);
}

TEST(OffscreenContext, IsTheDeviceThatTheSurveyMarks) {
  const DeviceSurvey survey = survey_devices({});
  ASSERT_TRUE(survey.problem.empty()) << describe(survey);
  const OffscreenContext context{DeviceChoice{}};
  int used = 0;
  for (const SurveyedDevice& device : survey.devices) {
    EXPECT_EQ(device.used, device.refusal.empty()) << "every device that is not used says why";
    if (!device.used) continue;
    ++used;
    EXPECT_EQ(device.index, context.device().index);
    EXPECT_EQ(device.renderer, context.device().renderer);
  }
  EXPECT_EQ(used, 1);
}

TEST(OffscreenContext, GpuOnAMachineWithNoneIsRefusedWithACure) {
  if (has_hardware()) GTEST_SKIP() << "this machine has graphics hardware";
  try {
    const OffscreenContext context(parse_device_choice("gpu"));
    FAIL() << "gpu fell back to " << context.driver();
  } catch (const PictureFailure& failure) {
    const std::string message = failure.what();
    EXPECT_EQ(message.find("no picture can be made with --device gpu: no graphics hardware answers"), 0u) << message;
    EXPECT_NE(message.find("cure: "), std::string::npos) << message;
  }
}

TEST(OffscreenContext, ANumberBeyondTheDevicesIsRefusedWithTheirCount) {
  try {
    const OffscreenContext context(parse_device_choice("1000"));
    FAIL() << "device 1000 gave " << context.driver();
  } catch (const PictureFailure& failure) {
    const std::string message = failure.what();
    EXPECT_EQ(message.find("no picture can be made with --device 1000: EGL knows "), 0u) << message;
    EXPECT_NE(message.find("counted from 0"), std::string::npos) << message;
  }
}

TEST(CurrentContext, RestoresWhatWasCurrentAndNests) {
  const OffscreenContext first{DeviceChoice{}}, second{DeviceChoice{}};
  eglBindAPI(EGL_OPENGL_API);
  {
    const CurrentContext outer(first);
    const EGLContext first_name = eglGetCurrentContext();
    {
      const CurrentContext inner(second);
      EXPECT_NE(eglGetCurrentContext(), first_name);
    }
    EXPECT_EQ(eglGetCurrentContext(), first_name);
  }
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(CurrentContext, AContextMayWanderToAnotherThread) {
  const OffscreenContext context{DeviceChoice{}};
  { const CurrentContext current(context); }
  bool has_version = false;
  std::thread([&] {
    const CurrentContext current(context);
    has_version = glGetString(GL_VERSION) != nullptr;
  }).join();
  EXPECT_TRUE(has_version);
}

TEST(CurrentContext, AContextInUseByAnotherThreadIsRefused) {
  const OffscreenContext context{DeviceChoice{}};
  const CurrentContext current(context);
  bool refused = false;
  std::thread([&] {
    try {
      const CurrentContext stolen(context);
    } catch (const PictureFailure&) {
      refused = true;
    }
  }).join();
  EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace thinwall

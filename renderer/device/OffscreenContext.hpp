#pragma once

#include <epoxy/egl.h>

#include <string>
#include <vector>

#include "renderer/device/DeviceChoice.hpp"
#include "renderer/device/DeviceSurvey.hpp"
#include "renderer/device/EglDevices.hpp"

namespace thinwall {

/// An OpenGL 4.5 core context without a window. It is current only inside a CurrentContext, so that it may wander from
/// thread to thread.
class OffscreenContext {
 public:
  /// In this order: what was named; hardware devices; the software device; the surfaceless platform. Throws
  /// PictureFailure with the reason for each refusal and its cure. `gpu` takes hardware or nothing.
  explicit OffscreenContext(const DeviceChoice& choice);
  ~OffscreenContext();
  OffscreenContext(OffscreenContext&& other) noexcept;
  OffscreenContext& operator=(OffscreenContext&& other) noexcept;

  /// The device that is used, with the driver's own strings.
  const SurveyedDevice& device() const { return device_; }

  /// Vendor, renderer and version as the driver names itself, one line.
  std::string driver() const;

 private:
  friend class CurrentContext;
  friend SurveyedDevice try_device(const EglDevice& device, OffscreenContext* result);
  OffscreenContext() = default;
  void destroy() noexcept;

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;  // only where the driver cannot do without
  SurveyedDevice device_;
};

/// Makes a context current in this thread for as long as it lives, and restores what was current before.
class CurrentContext {
 public:
  explicit CurrentContext(const OffscreenContext& context);
  ~CurrentContext();
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  EGLenum previous_api_;
  EGLDisplay own_display_;
  EGLDisplay previous_display_;
  EGLContext previous_context_;
  EGLSurface previous_draw_;
  EGLSurface previous_read_;
};

/// Opens the device and asks its strings; where `result` is not null and the device is usable, leaves the context
/// there.
SurveyedDevice try_device(const EglDevice& device, OffscreenContext* result);

/// Positions in `devices` in the order in which `choice` tries them; the others are refused without a try.
std::vector<std::size_t> order_of_trial(const std::vector<EglDevice>& devices, const DeviceChoice& choice);

/// Why a usable device is not what `choice` asks for; empty when it is.
std::string refusal_by_choice(const SurveyedDevice& device, const DeviceChoice& choice);

/// What to do when `gpu` finds no hardware on this machine.
std::string gpu_cure();

}  // namespace thinwall

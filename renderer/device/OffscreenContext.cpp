#include "renderer/device/OffscreenContext.hpp"

#include <epoxy/gl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <utility>

#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

std::string egl_error() {
  std::ostringstream text;
  text << "EGL error 0x" << std::hex << eglGetError();
  return text.str();
}

EGLDisplay display_of(const EglDevice& device) {
  return device.handle ? eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device.handle, nullptr)
                       : eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

std::string cure_for_closed_device(const EglDevice& device) {
  if (!device.file.empty() && access(device.file.c_str(), R_OK | W_OK) != 0) {
    return "no permission on " + device.file + ": add the user to the groups `video` and `render`";
  }
  if (device.software || !device.handle) return "install Mesa's drivers: apt-get install libgl1-mesa-dri";
  return "install the driver of this device (Mesa: libgl1-mesa-dri; NVIDIA: libnvidia-egl, libnvidia-gl of the "
         "kernel module's version)";
}

/// A configuration is only needed by drivers without EGL_KHR_no_config_context or surfaceless contexts.
EGLConfig any_config(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  return eglChooseConfig(display, wanted, &config, 1, &count) && count > 0 ? config : nullptr;
}

EGLContext create_context(EGLDisplay display, EGLConfig config) {
  const EGLint attributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
}

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

bool names_software(const std::string& renderer) {
  std::string lower = renderer;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* word : {"llvmpipe", "softpipe", "swrast", "software rasterizer", "swiftshader"}) {
    if (lower.find(word) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

SurveyedDevice try_device(const EglDevice& device, OffscreenContext* result) {
  SurveyedDevice report{
      .index = device.index, .extensions = device.extensions, .file = device.file, .software = device.software};
  const auto refuse = [&](std::string reason, std::string cure) {
    report.refusal = std::move(reason);
    report.cure = std::move(cure);
    return report;
  };
  OffscreenContext context;
  context.display_ = display_of(device);
  // A display belongs to the whole process and is never terminated: that would take it from other contexts.
  if (context.display_ == EGL_NO_DISPLAY || !eglInitialize(context.display_, nullptr, nullptr)) {
    return refuse("its display cannot be opened (" + egl_error() + ")", cure_for_closed_device(device));
  }
  const auto extensions = split_words(eglQueryString(context.display_, EGL_EXTENSIONS));
  eglBindAPI(EGL_OPENGL_API);
  const bool surfaceless = contains(extensions, "EGL_KHR_surfaceless_context");
  const bool needs_config = !contains(extensions, "EGL_KHR_no_config_context") || !surfaceless;
  const EGLConfig config = needs_config ? any_config(context.display_) : nullptr;
  context.context_ = create_context(context.display_, config);
  if (context.context_ == EGL_NO_CONTEXT) {
    return refuse("it gives no OpenGL 4.5 core context (" + egl_error() + ")",
                  "update its driver: OpenGL 4.5 came with Mesa 20 for llvmpipe and most hardware");
  }
  if (!surfaceless) {
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    context.surface_ = config ? eglCreatePbufferSurface(context.display_, config, size) : EGL_NO_SURFACE;
    if (context.surface_ == EGL_NO_SURFACE) {
      return refuse("it draws neither without a surface nor to an off-screen one (" + egl_error() + ")",
                    "update its driver");
    }
  }
  {
    const CurrentContext current(context);
    report.vendor = gl_string(GL_VENDOR);
    report.renderer = gl_string(GL_RENDERER);
    report.version = gl_string(GL_VERSION);
  }
  report.software = report.software || names_software(report.renderer);
  report.usable = true;
  if (result) {
    context.device_ = report;
    *result = std::move(context);
  }
  return report;
}

std::vector<std::size_t> order_of_trial(const std::vector<EglDevice>& devices, const DeviceChoice& choice) {
  std::vector<std::size_t> hardware, software, surfaceless;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const EglDevice& device = devices[i];
    if (choice.preference == DevicePreference::kIndex && device.index != choice.index) continue;
    (!device.handle ? surfaceless : device.software ? software : hardware).push_back(i);
  }
  std::vector<std::size_t> order;
  if (choice.preference != DevicePreference::kSoftware) order = hardware;
  // On the surfaceless platform hardware may serve too, so `gpu` looks there when it has no device of its own.
  if (choice.preference != DevicePreference::kGpu) order.insert(order.end(), software.begin(), software.end());
  order.insert(order.end(), surfaceless.begin(), surfaceless.end());
  return order;
}

std::string refusal_by_choice(const SurveyedDevice& device, const DeviceChoice& choice) {
  if (choice.preference == DevicePreference::kGpu && device.software) {
    return "it draws with the processor (" + device.renderer + ")";
  }
  if (choice.preference == DevicePreference::kSoftware && !device.software) {
    return "it is hardware (" + device.renderer + ")";
  }
  return {};
}

std::string gpu_cure() {
  if (std::filesystem::exists("/dev/nvidiactl") || std::filesystem::exists("/dev/nvidia0")) {
    return "an NVIDIA device file is there, but EGL finds no driver for it: install libnvidia-egl and libnvidia-gl of "
           "the kernel module's version (in a container: NVIDIA_DRIVER_CAPABILITIES=graphics,compute), and see that "
           "/usr/share/glvnd/egl_vendor.d holds 10_nvidia.json";
  }
  if (std::filesystem::exists("/dev/dri")) {
    return "/dev/dri is there: install libgl1-mesa-dri, and add the user to the groups `video` and `render`";
  }
  return "no graphics device reaches this machine (neither /dev/dri nor /dev/nvidia0 exists); use --device software";
}

OffscreenContext::OffscreenContext(const DeviceChoice& choice) {
  const EglLibrary library = list_egl_devices();
  std::string refusals;
  for (const std::size_t i : order_of_trial(library.devices, choice)) {
    SurveyedDevice report = try_device(library.devices[i], this);
    if (report.usable) report.refusal = refusal_by_choice(report, choice);
    if (report.usable && report.refusal.empty()) {
      device_.used = true;
      return;
    }
    destroy();
    refusals += "\n  " + (report.index < 0 ? "surfaceless platform" : "EGL device " + std::to_string(report.index)) +
                ": " + report.refusal + (report.cure.empty() ? "" : "; " + report.cure);
  }
  const DeviceSurvey survey = survey_devices(choice);
  throw PictureFailure(survey.problem + refusals + "\n  cure: " + survey.cure);
}

OffscreenContext::~OffscreenContext() {
  destroy();
}

OffscreenContext::OffscreenContext(OffscreenContext&& other) noexcept {
  *this = std::move(other);
}

OffscreenContext& OffscreenContext::operator=(OffscreenContext&& other) noexcept {
  if (this == &other) return *this;
  destroy();
  display_ = std::exchange(other.display_, EGL_NO_DISPLAY);
  context_ = std::exchange(other.context_, EGL_NO_CONTEXT);
  surface_ = std::exchange(other.surface_, EGL_NO_SURFACE);
  device_ = std::move(other.device_);
  return *this;
}

void OffscreenContext::destroy() noexcept {
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
  if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  surface_ = EGL_NO_SURFACE;
  context_ = EGL_NO_CONTEXT;
}

std::string OffscreenContext::driver() const {
  return device_.vendor + " " + device_.renderer + " " + device_.version;
}

CurrentContext::CurrentContext(const OffscreenContext& context)
    : previous_api_(eglQueryAPI()), own_display_(context.display_) {
  // The bound API belongs to the thread, and what is current belongs to the API.
  eglBindAPI(EGL_OPENGL_API);
  previous_display_ = eglGetCurrentDisplay();
  previous_context_ = eglGetCurrentContext();
  previous_draw_ = eglGetCurrentSurface(EGL_DRAW);
  previous_read_ = eglGetCurrentSurface(EGL_READ);
  if (!eglMakeCurrent(context.display_, context.surface_, context.surface_, context.context_)) {
    throw PictureFailure("the GL context cannot be made current (" + egl_error() +
                         "): it may be in use by another thread");
  }
}

CurrentContext::~CurrentContext() {
  if (previous_context_ == EGL_NO_CONTEXT) {
    eglMakeCurrent(own_display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  } else {
    eglMakeCurrent(previous_display_, previous_draw_, previous_read_, previous_context_);
  }
  eglBindAPI(previous_api_);
}

}  // namespace thinwall

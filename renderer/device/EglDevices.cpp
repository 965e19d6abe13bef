#include "renderer/device/EglDevices.hpp"

#include <algorithm>
#include <sstream>

namespace thinwall {
namespace {

constexpr const char* kMesaCure = "install Mesa: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri";

EglDevice describe_device(int index, EGLDeviceEXT handle) {
  EglDevice device{.index = index, .handle = handle};
  device.extensions = split_words(eglQueryDeviceStringEXT(handle, EGL_EXTENSIONS));
  device.software = contains(device.extensions, "EGL_MESA_device_software");
  if (contains(device.extensions, "EGL_EXT_device_drm")) {
    if (const char* file = eglQueryDeviceStringEXT(handle, EGL_DRM_DEVICE_FILE_EXT)) device.file = file;
  }
  return device;
}

void append_enumerated_devices(EglLibrary& library) {
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return;
  std::vector<EGLDeviceEXT> handles(static_cast<std::size_t>(count));
  if (!eglQueryDevicesEXT(count, handles.data(), &count)) return;
  for (int i = 0; i < count; ++i) library.devices.push_back(describe_device(i, handles[static_cast<std::size_t>(i)]));
}

}  // namespace

std::vector<std::string> split_words(const char* text) {
  std::istringstream stream(text ? text : "");
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool contains(const std::vector<std::string>& extensions, const std::string& name) {
  return std::find(extensions.begin(), extensions.end(), name) != extensions.end();
}

EglLibrary list_egl_devices() {
  EglLibrary library;
  // libepoxy ends the program when it cannot load libEGL or does not find a function, so everything is asked for first.
  library.present = epoxy_has_egl();
  if (!library.present) {
    library.problem = "the EGL library (libEGL.so.1) is not installed";
    library.cure = kMesaCure;
    return library;
  }
  library.extensions = split_words(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS));
  const bool enumerates = contains(library.extensions, "EGL_EXT_device_base") ||
                          (contains(library.extensions, "EGL_EXT_device_query") &&
                           contains(library.extensions, "EGL_EXT_device_enumeration"));
  if (enumerates && contains(library.extensions, "EGL_EXT_platform_device")) append_enumerated_devices(library);
  if (contains(library.extensions, "EGL_MESA_platform_surfaceless")) library.devices.push_back({.software = false});
  if (library.devices.empty()) {
    library.problem = "EGL offers no device and no surfaceless platform: it found no driver";
    library.cure = kMesaCure;
  }
  return library;
}

}  // namespace thinwall

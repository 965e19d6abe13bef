#pragma once

#include <epoxy/egl.h>

#include <string>
#include <vector>

namespace thinwall {

/// A way to a picture: an EGL device, or Mesa's platform that needs none.
struct EglDevice {
  int index = -1;                            // in EGL's own order; -1: the surfaceless platform
  EGLDeviceEXT handle = nullptr;             // null for the surfaceless platform
  std::vector<std::string> extensions = {};  // of the device, before any display is opened
  std::string file = {};                     // /dev/dri/..., where the driver tells
  bool software = false;                     // the driver says that the processor does the work
};

/// What the EGL library offers before any device is opened.
struct EglLibrary {
  bool present = false;
  std::vector<std::string> extensions = {};  // client extensions
  std::vector<EglDevice> devices = {};  // EGL's devices in its order, then the surfaceless platform if there is one
  std::string problem = {};             // why there is none; empty when there are some
  std::string cure = {};
};

EglLibrary list_egl_devices();

bool contains(const std::vector<std::string>& extensions, const std::string& name);

/// The words of `text`, which are separated by blanks.
std::vector<std::string> split_words(const char* text);

}  // namespace thinwall

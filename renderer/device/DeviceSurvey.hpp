#pragma once

#include <string>
#include <vector>

#include "renderer/device/DeviceChoice.hpp"

namespace thinwall {

/// What is known of one EGL device (or of Mesa's surfaceless platform) after trying to draw with it.
struct SurveyedDevice {
  int index = -1;                            // the N of `--device N`; -1: the surfaceless platform
  std::vector<std::string> extensions = {};  // of the EGL device
  std::string file = {};                     // /dev/dri/..., where the driver tells
  std::string vendor = {};                   // GL strings; empty when no context came up
  std::string renderer = {};
  std::string version = {};
  bool software = false;     // the processor draws
  bool usable = false;       // an OpenGL 4.5 core context came up
  bool used = false;         // by the choice that the survey was made for
  std::string refusal = {};  // why it is not used
  std::string cure = {};     // what would help; empty when nothing is wrong
};

struct DeviceSurvey {
  bool egl_present = false;
  std::vector<std::string> client_extensions = {};
  std::vector<SurveyedDevice> devices = {};  // EGL's order, the surfaceless platform last
  std::string problem = {};                  // why nothing can be drawn with this choice; empty when something can
  std::string cure = {};
};

/// Opens every device in turn and says which one `choice` would use, and why not the others. Changes no current
/// context.
DeviceSurvey survey_devices(const DeviceChoice& choice);

/// The survey for a person, several lines, each ended by a line feed.
std::string describe(const DeviceSurvey& survey);

}  // namespace thinwall

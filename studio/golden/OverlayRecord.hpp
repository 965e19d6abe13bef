#pragma once

#include <string>
#include <vector>

#include "renderer/overlay/Overlay.hpp"

namespace thinwall {

/// What is written over a picture, as JSON to be kept beside a golden; the curve of the force is left out.
std::string overlay_record(const OverlayContent& content);

/// What two records write differently: "caption \"Pressing\" instead of \"Presing\"", "depth 4.2 mm instead of 4 mm".
/// Numbers count from what is shown of them, three digits. Nothing when one of them is no record.
std::vector<std::string> compare_overlays(const std::string& golden, const std::string& today);

}  // namespace thinwall

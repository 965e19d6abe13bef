#pragma once

#include <string>

#include "renderer/camera/View.hpp"

namespace thinwall {

/// Fills cameras and cuts of a view from a resolved scenario (JSON). Takes of before there were cuts have one camera.
/// Throws nlohmann::json::exception when something needed is missing or no JSON.
void read_cameras(const std::string& resolved, ViewDefinition& view);

}  // namespace thinwall

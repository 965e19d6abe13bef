#pragma once

#include <string>

#include "renderer/camera/View.hpp"
#include "studio/scenario/Teaching.hpp"

namespace thinwall {

/// Fills the teaching layer, and the highlights of a view, from a resolved scenario (JSON). Takes of before there was
/// one have none. Throws nlohmann::json::exception when something needed is missing or no JSON.
void read_teaching(const std::string& resolved, Teaching& teaching, ViewDefinition& view);

}  // namespace thinwall

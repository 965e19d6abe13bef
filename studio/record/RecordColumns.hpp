#pragma once

#include <array>
#include <string_view>

#include "studio/record/StepRecord.hpp"

namespace thinwall {

/// A column of numbers in forces.csv, and of the same name in a take.
struct ToolColumn {
  std::string_view name;  // with the unit
  double& (*value)(ToolRecord&);
};

/// In the order of the file, after `time_s,tool,phase`.
inline constexpr std::array<ToolColumn, 8> kToolColumns = {{
    {"x_m", [](ToolRecord& tool) -> double& { return tool.position.x(); }},
    {"y_m", [](ToolRecord& tool) -> double& { return tool.position.y(); }},
    {"z_m", [](ToolRecord& tool) -> double& { return tool.position.z(); }},
    {"depth_m", [](ToolRecord& tool) -> double& { return tool.depth; }},
    {"fx_N", [](ToolRecord& tool) -> double& { return tool.force.x(); }},
    {"fy_N", [](ToolRecord& tool) -> double& { return tool.force.y(); }},
    {"fz_N", [](ToolRecord& tool) -> double& { return tool.force.z(); }},
    {"contact_area_m2", [](ToolRecord& tool) -> double& { return tool.contact_area; }},
}};

/// A column of numbers in body.csv, and of the same name in a take. One of the two members is set.
struct BodyColumn {
  std::string_view name;  // with the unit
  double BodyRecord::*real = nullptr;
  int BodyRecord::*count = nullptr;

  double get(const BodyRecord& body) const { return real ? body.*real : static_cast<double>(body.*count); }
  void set(BodyRecord& body, double value) const {
    if (real) {
      body.*real = value;
    } else {
      body.*count = static_cast<int>(value);
    }
  }
};

/// In the order of the file, after `time_s,body`.
inline constexpr std::array<BodyColumn, 22> kBodyColumns = {{
    {"volume_m3", &BodyRecord::volume},
    {"fluid_volume_m3", &BodyRecord::fluid_volume},
    {"leaked_m3", &BodyRecord::leaked},
    {"pressure_Pa", &BodyRecord::pressure},
    {"open_area_m2", &BodyRecord::open_area},
    {"cut_length_m", &BodyRecord::cut_length},
    {"elastic_J", &BodyRecord::elastic},
    {"bending_J", &BodyRecord::bending},
    {"kinetic_J", &BodyRecord::kinetic},
    {"fluid_J", &BodyRecord::fluid},
    {"gravity_J", &BodyRecord::gravity},
    {"contact_J", &BodyRecord::contact},
    {"viscous_J", &BodyRecord::viscous},
    {"friction_J", &BodyRecord::friction},
    {"fracture_J", &BodyRecord::fracture},
    {"leak_J", &BodyRecord::leak},
    {"numerical_J", &BodyRecord::numerical},
    {"jump_J", &BodyRecord::jump},
    {"tool_work_J", &BodyRecord::tool_work},
    {"script_work_J", &BodyRecord::script_work},
    {"newton_iterations", nullptr, &BodyRecord::newton_iterations},
    {"residual_N", &BodyRecord::residual},
}};

}  // namespace thinwall

#include "studio/schema/ExpectationQuantity.hpp"

#include <array>

namespace thinwall {
namespace {

using Tool = ToolRecord;
using Body = BodyRecord;
using Point = PointRecord;

constexpr MeasuredQuantity of_tool(std::string_view name, const Dimension& dimension, double (*value)(const Tool&),
                                   std::string_view documentation) {
  return {name, ExpectationSubject::kTool, dimension, value, nullptr, nullptr, documentation};
}
constexpr MeasuredQuantity of_body(std::string_view name, const Dimension& dimension, double (*value)(const Body&),
                                   std::string_view documentation) {
  return {name, ExpectationSubject::kBody, dimension, nullptr, value, nullptr, documentation};
}
constexpr MeasuredQuantity of_chamber(std::string_view name, const Dimension& dimension, double (*value)(const Body&),
                                      std::string_view documentation) {
  return {name, ExpectationSubject::kBody, dimension, nullptr, value, nullptr, documentation, true};
}
constexpr MeasuredQuantity of_point(std::string_view name, double (*value)(const Point&),
                                    std::string_view documentation) {
  return {name, ExpectationSubject::kPoint, kLength, nullptr, nullptr, value, documentation};
}

constexpr std::array kMeasured = {
    of_tool(
        "force", kForce, [](const Tool& tool) { return tool.force.norm(); }, "magnitude of the tissue's force"),
    of_tool(
        "force_x", kForce, [](const Tool& tool) { return tool.force.x(); }, "its part along x"),
    of_tool(
        "force_y", kForce, [](const Tool& tool) { return tool.force.y(); }, "its part along y"),
    of_tool(
        "force_z", kForce, [](const Tool& tool) { return tool.force.z(); }, "its part along z"),
    of_tool(
        "depth", kLength, [](const Tool& tool) { return tool.depth; }, "travel since first contact"),
    of_tool(
        "contact_area", kArea, [](const Tool& tool) { return tool.contact_area; }, "area that touches the tool"),
    of_chamber(
        "pressure", kPressure, [](const Body& body) { return body.pressure; },
        "at its level; of the first chamber where none is named"),
    of_chamber(
        "volume", kVolume, [](const Body& body) { return body.volume; }, "volume within the wall"),
    of_chamber(
        "fluid_volume", kVolume, [](const Body& body) { return body.fluid_volume; }, "volume of the fluid"),
    of_body(
        "elastic_energy", kEnergy, [](const Body& body) { return body.elastic; }, "stored in the wall"),
    of_body(
        "bending_energy", kEnergy, [](const Body& body) { return body.bending; }, "stored in a shell's bending"),
    of_body(
        "kinetic_energy", kEnergy, [](const Body& body) { return body.kinetic; }, "stored in motion"),
    of_body(
        "fluid_energy", kEnergy, [](const Body& body) { return body.fluid; }, "stored in a compressible fluid"),
    of_body(
        "gravity_energy", kEnergy, [](const Body& body) { return body.gravity; }, "stored in height"),
    of_body(
        "viscous_energy", kEnergy, [](const Body& body) { return body.viscous; },
        "spent by viscosity, some of which a wall that is let go gives back"),
    of_body(
        "friction_energy", kEnergy, [](const Body& body) { return body.friction; }, "spent by friction"),
    of_body(
        "numerical_energy", kEnergy, [](const Body& body) { return body.numerical; }, "spent by the integrator"),
    of_body(
        "tool_work", kEnergy, [](const Body& body) { return body.tool_work; }, "put in by the tools"),
    of_body(
        "script_work", kEnergy, [](const Body& body) { return body.script_work; }, "put in by loads and filling"),
    of_point(
        "position_x", [](const Point& point) { return point.position.x(); }, "where the point is"),
    of_point(
        "position_y", [](const Point& point) { return point.position.y(); }, "where the point is"),
    of_point(
        "position_z", [](const Point& point) { return point.position.z(); }, "where the point is"),
    of_point(
        "displacement", [](const Point& point) { return point.displacement().norm(); },
        "distance from its stress-free position"),
    of_point(
        "displacement_x", [](const Point& point) { return point.displacement().x(); }, "its part along x"),
    of_point(
        "displacement_y", [](const Point& point) { return point.displacement().y(); }, "its part along y"),
    of_point(
        "displacement_z", [](const Point& point) { return point.displacement().z(); }, "its part along z"),
};

constexpr std::array kReductions = {
    ReductionWord{"", Reduction::kMoment, "at the time `at`"},
    ReductionWord{"peak_", Reduction::kPeak, "the largest"},
    ReductionWord{"lowest_", Reduction::kLowest, "the smallest"},
    ReductionWord{"mean_", Reduction::kMean, "the average over time"},
    ReductionWord{"final_", Reduction::kFinal, "the last"},
};

}  // namespace

std::span<const MeasuredQuantity> measured_quantities() {
  return kMeasured;
}

std::span<const ReductionWord> reduction_words() {
  return kReductions;
}

std::vector<std::string> expectation_words() {
  std::vector<std::string> words;
  for (const MeasuredQuantity& measured : kMeasured) {
    for (const ReductionWord& reduction : kReductions) {
      words.push_back(std::string(reduction.prefix) + std::string(measured.name));
    }
  }
  return words;
}

ExpectationQuantity find_expectation_quantity(std::string_view word) {
  for (const MeasuredQuantity& measured : kMeasured) {
    for (const ReductionWord& reduction : kReductions) {
      if (word.ends_with(measured.name) && word.size() == reduction.prefix.size() + measured.name.size() &&
          word.starts_with(reduction.prefix)) {
        return {&measured, reduction.reduction};
      }
    }
  }
  return {};
}

std::string_view subject_word(ExpectationSubject subject) {
  constexpr std::array<std::string_view, 3> kWords = {"tool", "body", "point"};
  return kWords[static_cast<std::size_t>(subject)];
}

}  // namespace thinwall

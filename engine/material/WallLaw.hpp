#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace thinwall {

/// What a wall law answers for the in-plane right Cauchy-Green tensor C = (C11, C22, C12) of a thin wall in plane
/// stress.
struct WallLawResponse {
  double energy;                           // strain energy per rest volume, joule / metre^3
  Eigen::Vector3d second_piola_kirchhoff;  // (S11, S22, S12) = 2 dW/dC, pascal
  Eigen::Matrix3d tangent;  // d(S11, S22, S12) / d(E11, E22, 2 E12) with E = (C - 1) / 2, symmetric, pascal
};

/// One parameter of a law, as the scenario format, its reference page and its error messages know it.
struct LawParameter {
  std::string_view name;
  std::string_view unit;           // SI: "Pa", or "" for a number
  double minimum;                  // smallest allowed value, in `unit`
  bool minimum_excluded;           // whether the minimum itself is not allowed
  double maximum;                  // largest allowed value, in `unit`
  std::optional<double> fallback;  // value when absent; needed when empty
  std::string_view documentation;
};

/// A row of the table of laws: everything that the program knows of one law.
struct WallLaw {
  std::string_view name;
  std::string_view formula;
  std::string_view source;  // where the formula comes from
  std::span<const LawParameter> parameters;
  /// `parameters` in the order of the table; `right_cauchy_green` = (C11, C22, C12) with det C > 0.
  WallLawResponse (*respond)(const double* parameters, const Eigen::Vector3d& right_cauchy_green);
  /// In-plane Young's modulus at zero strain, pascal: the scale of stiffness and of tolerances.
  double (*initial_modulus)(const double* parameters);
};

/// All laws, in the order of the reference page.
std::span<const WallLaw> wall_laws();

/// The law of that name, or nullptr.
const WallLaw* find_wall_law(std::string_view name);

/// A law with its parameters.
struct Material {
  const WallLaw* law = nullptr;    // a row of wall_laws()
  std::vector<double> parameters;  // (law->parameters), SI, in the order of the table
};

}  // namespace thinwall

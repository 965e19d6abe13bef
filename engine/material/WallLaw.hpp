#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
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
  std::string_view terms = {};  // name of a list of terms that each have all parameters; "" for a law without
  bool has_fibres = false;      // whether the law's first axis has a meaning, so that a body must say where it lies
  /// `parameters` in the order of the table, term after term where the law has terms; `right_cauchy_green` =
  /// (C11, C22, C12) with det C > 0. Where the law ends (Gent's limit) or its energy overflows, the energy is infinite
  /// and the rest zero.
  WallLawResponse (*respond)(std::span<const double> parameters, const Eigen::Vector3d& right_cauchy_green);
  /// Young's modulus along the first axis at zero strain, pascal: the scale of stiffness and of tolerances.
  double (*initial_modulus)(std::span<const double> parameters);
  /// What is wrong with parameters that are in range each, with the cure; "" when they go together. Null: they always
  /// do.
  std::string (*complaint)(std::span<const double> parameters) = nullptr;
};

/// All laws, in the order of the reference page.
std::span<const WallLaw> wall_laws();

/// The law of that name, or nullptr.
const WallLaw* find_wall_law(std::string_view name);

/// A law with its parameters.
struct Material {
  const WallLaw* law = nullptr;    // a row of wall_laws()
  std::vector<double> parameters;  // (law->parameters, or terms x law->parameters), SI, in the order of the table
};

}  // namespace thinwall

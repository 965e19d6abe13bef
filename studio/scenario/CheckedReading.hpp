#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "studio/scenario/CheckedValue.hpp"

namespace thinwall {

/// Of a checked list of three numbers.
Eigen::Vector3d to_vector(const CheckedValue& list);

/// What a checked mapping has for a key; nothing without it, and where a vector has not three numbers.
std::optional<Eigen::Vector3d> find_vector(const CheckedValue& mapping, std::string_view key);
std::optional<std::string> find_text(const CheckedValue& mapping, std::string_view key);
std::optional<double> find_number(const CheckedValue& mapping, std::string_view key);

}  // namespace thinwall

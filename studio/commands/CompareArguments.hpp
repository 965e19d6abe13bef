#pragma once

#include <optional>
#include <string>

#include "studio/commands/Commands.hpp"

namespace thinwall {

/// What was written after `compare`: values that need no reading beside words that do.
struct CompareArguments {
  CompareOptions options;
  std::string metric = "pixels";
  std::string mask;
  std::string layer;
  std::string difference;
  std::optional<double> tolerance;
  std::optional<int> edge_band;
};

/// Throws UsageError for words that mean nothing and options that do not go together.
CompareOptions compare_options(const CompareArguments& arguments);

}  // namespace thinwall

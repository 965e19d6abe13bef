#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "renderer/camera/View.hpp"
#include "studio/schema/Quantity.hpp"

namespace thinwall {

/// What a command line changes of a data view.
struct DataViewChanges {
  std::optional<Quantity> from = {};
  std::optional<Quantity> to = {};
  std::optional<DataScale> scale = {};
};

/// Throws UsageError where there is no data view to change, an end has another dimension than the quantity, or the ends
/// are in the wrong order.
void change_data_view(const DataViewChanges& changes, LookDefinition& look);

/// Throws UsageError where a data view lacks an end of its colours: the whole range is known only when a simulation has
/// ended.
void require_data_range(const LookDefinition& look);

/// Gives a data view the ends that it lacks, from the whole of all takes that it shows, and says whether values lie
/// beyond them: over 0.5 % of the wall below the first at most, and over 5 % of where they are not zero above the last.
/// What is held fast at its stress-free place does not count. Throws TakeError where a take does not hold what is to be
/// shown, UsageError where the end that is there lies beyond all that the wall bears, so that the two would be in the
/// wrong order.
void complete_data_range(const std::vector<std::filesystem::path>& takes, LookDefinition& look);

}  // namespace thinwall

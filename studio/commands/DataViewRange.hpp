#pragma once

#include <filesystem>

#include "renderer/picture/View.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {

/// Throws UsageError where a data view lacks an end of its colours: the whole range is known only when a simulation has
/// ended.
void require_data_range(const LookDefinition& look);

/// Gives a data view the ends that it lacks, from the whole take, and says whether values lie beyond them: over 0.5 %
/// of the wall below the first at most, and over 5 % of where they are not zero above the last. What is held fast at
/// its stress-free place does not count. Throws TakeError where the take does not hold what is to be shown.
void complete_data_range(const TakeReader& take, const std::filesystem::path& file, LookDefinition& look);

}  // namespace thinwall

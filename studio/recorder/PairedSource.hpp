#pragma once

#include <memory>

#include "studio/record/Moment.hpp"

namespace thinwall {

/// The moments of `first`, each with that of `second` at the same time: where the times differ, the snapshot between
/// two of its moments with the record of the later one; its last when it ends before.
std::unique_ptr<MomentSource> pair_sources(std::unique_ptr<MomentSource> first, std::unique_ptr<MomentSource> second);

}  // namespace thinwall

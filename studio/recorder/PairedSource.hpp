#pragma once

#include <memory>

#include "studio/record/Moment.hpp"

namespace thinwall {

/// The moments of `first`, each with the snapshot of `second` at the same time: between two of its moments where the
/// times differ, its last when it ends before.
std::unique_ptr<MomentSource> pair_sources(std::unique_ptr<MomentSource> first, std::unique_ptr<MomentSource> second);

}  // namespace thinwall

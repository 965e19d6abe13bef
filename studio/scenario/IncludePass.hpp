#pragma once

#include <filesystem>

#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {

/// Merges the files that `include:` names below the root's own keys and takes `include` away. Mappings are merged key
/// by key; of anything else the nearest wins: the including file over the included, a later one of the list over an
/// earlier. A mapping whose kind is chosen by a word (`law`, `kind`, `fluid`) or by a key (`mesh`, `shape`, a region)
/// is not merged with one of another kind but replaces it. Errors: files that cannot be read, cycles, more than 64
/// files.
void include_pass(TextNode& root, Diagnostics& diagnostics);

}  // namespace thinwall

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "studio/scenario/Diagnostics.hpp"
#include "studio/scenario/TextNode.hpp"

namespace thinwall {

/// Reads one YAML file into nodes with their places; only yaml-cpp's events are used, since its own nodes keep
/// duplicate keys silently and turn words into booleans. Anchors and aliases are copied in place. Empty when the file
/// cannot be read or is no YAML, with the reason in `diagnostics`; duplicate keys and keys that are no text are told
/// there too, and the first of equal keys is kept. Refused: more than 1 MiB, 64 levels or 100 000 nodes after aliases;
/// what is no UTF-8.
std::optional<TextNode> read_yaml_file(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same for a text; `place` is the name that errors give, and where paths in the text count from.
std::optional<TextNode> read_yaml_text(const std::string& text, const std::filesystem::path& place,
                                       Diagnostics& diagnostics);

}  // namespace thinwall

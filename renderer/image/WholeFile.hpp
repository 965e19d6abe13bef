#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace thinwall {

/// The name under which `path` is written until it is whole: `video.mp4` -> `video.unfinished.mp4`. The extension stays
/// last because programs choose the format by it.
std::filesystem::path unfinished_name(const std::filesystem::path& path);

/// Writes `bytes` under the unfinished name, then renames: a file called `path` is always a whole one. An older file of
/// that name stays as it was when this fails. What is a device or a pipe (`/dev/null`) stays one, and is written to.
/// Throws FileUnwritable with the system's reason and a cure.
void write_whole_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_whole_file(const std::filesystem::path& path, std::string_view text);

/// What a file holds; nothing when it cannot be read.
std::string bytes_of_file(const std::filesystem::path& path);

/// The same bytes, for what reads numbers.
std::span<const std::uint8_t> as_numbers(std::string_view bytes);

/// What helps against the system error `code` (an errno value) when a file is written, e.g. "free some space ...".
std::string cure_for_write_error(int code);

}  // namespace thinwall

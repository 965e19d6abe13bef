#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "studio/scenario/InputError.hpp"

namespace thinwall {

/// A file of numbers that cannot be read: the message says why and how to mend it; lines and columns count from 1.
class FileFormatError : public std::runtime_error {
 public:
  FileFormatError(const std::filesystem::path& file, int line, int column, const std::string& message)
      : std::runtime_error(message), location_{file, line, column} {}

  const SourceLocation& location() const { return location_; }

 private:
  SourceLocation location_;
};

/// All bytes of a file. Throws FileFormatError: missing, no plain file, larger than `most` bytes, not to be read.
std::string read_file_bytes(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace thinwall

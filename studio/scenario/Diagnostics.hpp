#pragma once

#include <string>
#include <vector>

#include "studio/scenario/InputError.hpp"

namespace thinwall {

/// Collects what the passes find, so that all mistakes are told at once.
struct Diagnostics {
  std::vector<Diagnostic> errors = {};
  std::vector<Diagnostic> warnings = {};
  bool has_gaps = false;  // whether files were not read that were to be included

  /// `path` is the key's path, "bodies.organ.wall"; empty for the file as a whole.
  void error(const SourceLocation& location, const std::string& path, const std::string& message);
  /// An error about what is nowhere, or used nowhere. Told only where nothing was left unread: it may be there.
  void absence(const SourceLocation& location, const std::string& path, const std::string& message);
  void warning(const SourceLocation& location, const std::string& path, const std::string& message);

  /// Throws InputErrors with the errors in the order of the files (the one named `first_file` before the others), when
  /// there are any.
  void throw_errors(const std::filesystem::path& first_file);
};

/// Orders by file (`first_file` before the others), line and column; equal places keep their order.
void sort_by_location(std::vector<Diagnostic>& diagnostics, const std::filesystem::path& first_file);

}  // namespace thinwall

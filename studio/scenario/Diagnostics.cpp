#include "studio/scenario/Diagnostics.hpp"

#include <algorithm>
#include <tuple>

namespace thinwall {
namespace {

Diagnostic make(const SourceLocation& location, const std::string& path, const std::string& message) {
  return {location, path.empty() ? message : path + ": " + message};
}

}  // namespace

void Diagnostics::error(const SourceLocation& location, const std::string& path, const std::string& message) {
  errors.push_back(make(location, path, message));
}

void Diagnostics::absence(const SourceLocation& location, const std::string& path, const std::string& message) {
  if (!has_gaps) error(location, path, message);
}

void Diagnostics::warning(const SourceLocation& location, const std::string& path, const std::string& message) {
  warnings.push_back(make(location, path, message));
}

void Diagnostics::throw_errors(const std::filesystem::path& first_file) {
  if (errors.empty()) return;
  sort_by_location(errors, first_file);
  throw InputErrors(std::move(errors));
}

void sort_by_location(std::vector<Diagnostic>& diagnostics, const std::filesystem::path& first_file) {
  const auto key = [&](const Diagnostic& diagnostic) {
    const SourceLocation& place = diagnostic.location;
    return std::tuple(place.file != first_file, place.file.native(), place.line, place.column);
  };
  std::ranges::stable_sort(diagnostics, [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
}

}  // namespace thinwall

#include "studio/scenario/InputError.hpp"

namespace thinwall {
namespace {

std::string all_texts(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += (text.empty() ? "" : "\n") + to_text(diagnostic);
  return text;
}

}  // namespace

std::string to_text(const Diagnostic& diagnostic) {
  return to_text(diagnostic.location) + ": error: " + diagnostic.message;
}

std::string to_text(const SourceLocation& location) {
  return location.file.string() + ":" + std::to_string(location.line) + ":" + std::to_string(location.column);
}

InputErrors::InputErrors(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(all_texts(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace thinwall

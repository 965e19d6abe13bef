#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// One mistake in a user's input.
struct Diagnostic {
  SourceLocation location = {};
  std::string message = {};  // with the key's path, what is allowed, and the cure
};

/// `file:line:column`
std::string to_text(const SourceLocation& location);

/// `file:line:column: error: message`
std::string to_text(const Diagnostic& diagnostic);

/// All mistakes found in a user's input, in the order of the file; exit code 2.
class InputErrors : public std::runtime_error {
 public:
  explicit InputErrors(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace thinwall

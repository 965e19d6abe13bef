#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// The names of a section such as `tools`, in the order of the file.
std::vector<std::string> names_in(const CheckedValue& root, std::string_view section);

/// A name as it was written, and where.
struct WrittenName {
  std::string text;
  SourceLocation location;
};

/// Tells when `name` is none of `names`, with the nearest of them; `what` is "tool", "camera", ...
void check_name(const WrittenName& name, const std::string& what, const std::vector<std::string>& names,
                const std::string& path, Diagnostics& diagnostics);

/// Checks the name under a key of a mapping, and fills in the only one there is where it was left out.
void resolve_name(CheckedValue& mapping, const std::string& key, const std::vector<std::string>& names,
                  const std::string& path, Diagnostics& diagnostics);

}  // namespace thinwall

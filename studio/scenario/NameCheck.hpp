#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "studio/scenario/CheckedValue.hpp"
#include "studio/scenario/Diagnostics.hpp"

namespace thinwall {

/// The names of a section such as `tools`, in the order of the file.
std::vector<std::string> names_in(const CheckedValue& root, std::string_view section);

/// Names of which one is wanted, and which is meant where none is given: the only one.
struct NameChoice {
  std::vector<std::string> names;
  std::string meant = {};  // or nothing
};
NameChoice choice_of(std::vector<std::string> names);

/// The names of `bodies`. One that is fixed all over is scenery, which is not meant unless it is named.
NameChoice choice_of_bodies(const CheckedValue& root);

/// A name as it was written, and where.
struct WrittenName {
  std::string text;
  SourceLocation location;
};

/// Tells when `name` is none of `names`, with the nearest of them; `what` is "tool", "camera", ...
void check_name(const WrittenName& name, const std::string& what, const std::vector<std::string>& names,
                const std::string& path, Diagnostics& diagnostics);

/// Checks the name under a key of a mapping, and fills in the one that is meant where it was left out.
void resolve_name(CheckedValue& mapping, const std::string& key, const NameChoice& choice, const std::string& path,
                  Diagnostics& diagnostics);

}  // namespace thinwall

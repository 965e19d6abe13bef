#include "studio/scenario/FieldLint.hpp"

#include <algorithm>
#include <filesystem>

#include "studio/scenario/TextNode.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

bool is_ply(std::string file) {
  std::ranges::transform(file, file.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return file.ends_with(".ply");
}

/// Walks through a wall; the keys `file` and `attribute` are those of fields alone.
class FieldChecker {
 public:
  FieldChecker(const CheckedValue* surface, Diagnostics& diagnostics) : surface_(surface), diagnostics_(diagnostics) {}

  void check(const CheckedValue& value, const std::string& path) {
    if (const CheckedValue* file = value.find("file")) check_file(*file, path + ".file");
    if (const CheckedValue* attribute = value.find("attribute")) check_attribute(*attribute, path + ".attribute");
    for (std::size_t index = 0; index < value.items.size(); ++index) {
      check(value.items[index], item_path(path, index));
    }
    for (const CheckedMember& member : value.members) check(member.value, member_path(path, member.key));
  }

  void check_prestretch(const CheckedValue& prestretch, const std::string& path) {
    if (const CheckedValue* standard = prestretch.find("default")) check_prestretch(*standard, path + ".default");
    for (const std::string key : {"column", "attribute"}) {
      const CheckedValue* names = prestretch.find(key);
      if (names == nullptr || names->items.size() == 1 || names->items.size() == 5) continue;
      diagnostics_.error(
          names->location, path + "." + key,
          "expected a name, or five (e.g. [fx, fy, fz, along, across]), got " + std::to_string(names->items.size()));
    }
  }

 private:
  void check_file(const CheckedValue& file, const std::string& path) {
    std::error_code failure;
    if (std::filesystem::is_regular_file(file.text, failure)) return;
    diagnostics_.error(file.location, path, no_file_words(file.text));
  }

  void check_attribute(const CheckedValue& attribute, const std::string& path) {
    const CheckedValue* shape = surface_ == nullptr ? nullptr : surface_->find("shape");
    const CheckedValue* mesh = surface_ == nullptr ? nullptr : surface_->find("mesh");
    if (shape != nullptr) {
      diagnostics_.error(
          attribute.location, path,
          "the shape " + in_backticks(shape->text) + " has no properties; write `file` with a table, or `regions`");
    } else if (mesh != nullptr && !is_ply(mesh->text)) {
      diagnostics_.error(attribute.location, path,
                         "properties are read from PLY files only; save the mesh as PLY, or write `file` with a table");
    }
  }

  const CheckedValue* surface_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_fields(const CheckedMember& body, const std::string& path, Diagnostics& diagnostics) {
  const CheckedValue* wall = body.value.find("wall");
  if (wall == nullptr) return;
  FieldChecker checker(body.value.find("surface"), diagnostics);
  checker.check(*wall, path + ".wall");
  const CheckedValue* prestretch = wall->find("prestretch");
  if (prestretch != nullptr) checker.check_prestretch(*prestretch, path + ".wall.prestretch");
}

}  // namespace thinwall

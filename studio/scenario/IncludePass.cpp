#include "studio/scenario/IncludePass.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "studio/scenario/YamlReader.hpp"
#include "studio/schema/Wording.hpp"

namespace thinwall {
namespace {

constexpr std::size_t kMostFiles = 64;

/// Keys whose word decides which other keys a mapping has.
constexpr std::array<std::string_view, 4> kSelectors = {"law", "kind", "fluid", "shape"};

/// Keys that stand for different forms of a mapping: of a surface, and of a field over a wall.
constexpr std::array<std::string_view, 2> kSurfaceForms = {"mesh", "shape"};
constexpr std::array<std::string_view, 4> kFieldForms = {"default", "file", "attribute", "along"};

/// The first of the forms that a mapping has, "" when it has none.
std::string_view form_of(const TextNode& mapping, std::span<const std::string_view> forms) {
  const auto form = std::ranges::find_if(forms, [&](std::string_view key) { return mapping.find(key) != nullptr; });
  return form == forms.end() ? "" : *form;
}

bool differ_in_form(const TextNode& nearer, const TextNode& farther, std::span<const std::string_view> forms) {
  const std::string_view own = form_of(nearer, forms), other = form_of(farther, forms);
  return !own.empty() && !other.empty() && own != other;
}

bool differ_in_kind(const TextNode& nearer, const TextNode& farther) {
  for (const std::string_view selector : kSelectors) {
    const TextMember *own = nearer.find(selector), *other = farther.find(selector);
    if (own != nullptr && other != nullptr && own->value.text != other->value.text) return true;
  }
  return differ_in_form(nearer, farther, kSurfaceForms) || differ_in_form(nearer, farther, kFieldForms);
}

TextNode merged(TextNode nearer, TextNode farther) {
  if (nearer.kind != NodeKind::kMapping || farther.kind != NodeKind::kMapping) return nearer;
  if (differ_in_kind(nearer, farther)) return nearer;
  TextNode result = std::move(farther);
  result.location = nearer.location;
  for (TextMember& member : nearer.members) {
    TextMember* below = result.find(member.key);
    if (below == nullptr) {
      result.members.push_back(std::move(member));
    } else {
      below->location = member.location;
      below->value = merged(std::move(member.value), std::move(below->value));
    }
  }
  return result;
}

class Includer {
 public:
  explicit Includer(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Replaces the root by itself merged over what it includes.
  void include(TextNode& root) {
    const auto include =
        std::ranges::find_if(root.members, [](const TextMember& member) { return member.key == "include"; });
    if (include == root.members.end()) return;
    const TextNode list = std::move(include->value);
    const SourceLocation key = include->location;
    root.members.erase(include);
    TextNode below;
    for (const NamedFile& named : named_files(list, key)) {
      std::optional<TextNode> file = read(named);
      if (!file) continue;
      check_version(root, *file);
      below = below.kind == NodeKind::kEmpty ? std::move(*file) : merged(std::move(*file), std::move(below));
    }
    if (below.kind == NodeKind::kMapping) root = merged(std::move(root), std::move(below));
  }

  void begin(const std::filesystem::path& file) { open_.push_back(identity(file)); }

 private:
  /// The name of a file that is included, and the key's path where that is written.
  struct NamedFile {
    const TextNode& item;
    std::string path;
  };

  /// One path for all the ways to write it, so that a cycle is seen.
  static std::filesystem::path identity(const std::filesystem::path& file) {
    std::error_code failure;
    std::filesystem::path canonical = std::filesystem::weakly_canonical(file, failure);
    return failure ? file.lexically_normal() : canonical;
  }

  std::vector<NamedFile> named_files(const TextNode& list, const SourceLocation& key) {
    std::vector<NamedFile> files;
    if (list.kind == NodeKind::kText) return {{list, "include"}};
    if (list.kind == NodeKind::kMapping) {
      diagnostics_.error(key, "include", "expected a file or a list of files, got a mapping");
      diagnostics_.has_gaps = true;
    }
    for (std::size_t index = 0; index < list.items.size(); ++index) {
      const TextNode& item = list.items[index];
      const std::string path = item_path("include", index);
      if (item.kind == NodeKind::kText) {
        files.push_back({item, path});
      } else {
        diagnostics_.error(item.location, path, "expected the path of a file, got " + describe(item));
        diagnostics_.has_gaps = true;
      }
    }
    return files;
  }

  /// The nearest wins, but not over the version that a file is written for.
  void check_version(const TextNode& root, const TextNode& file) {
    const TextMember *own = root.find("thinwall"), *other = file.find("thinwall");
    if (own == nullptr || other == nullptr || own->value.text == other->value.text) return;
    diagnostics_.error(other->value.location, "thinwall",
                       "the file is of version " + in_backticks(other->value.text) + ", that which includes it of " +
                           in_backticks(own->value.text) + ": a scenario is of one version");
  }

  std::optional<TextNode> read(const NamedFile& named) {
    const TextNode& item = named.item;
    const std::filesystem::path file = (item.location.file.parent_path() / item.text).lexically_normal();
    const std::filesystem::path id = identity(file);
    if (std::ranges::find(open_, id) != open_.end()) {
      diagnostics_.error(item.location, named.path, in_backticks(item.text) + " includes itself; leave it out");
      return std::nullopt;
    }
    std::optional<TextNode> node = parse(named, file);
    if (!node) {
      diagnostics_.has_gaps = true;
      return std::nullopt;
    }
    open_.push_back(id);
    include(*node);
    open_.pop_back();
    return node;
  }

  std::optional<TextNode> parse(const NamedFile& named, const std::filesystem::path& file) {
    const TextNode& item = named.item;
    if (item.text.find("${") != std::string::npos) {
      diagnostics_.error(item.location, named.path,
                         "parameters are not known yet where files are included; write the file's name itself");
      return std::nullopt;
    }
    if (++files_ > kMostFiles) {
      if (files_ == kMostFiles + 1) diagnostics_.error(item.location, named.path, "more than 64 files are included");
      return std::nullopt;
    }
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure)) {
      diagnostics_.error(item.location, named.path, no_file_words(file.string()));
      return std::nullopt;
    }
    std::optional<TextNode> node = read_yaml_file(file, diagnostics_);
    if (!node) return std::nullopt;
    if (node->kind != NodeKind::kMapping) {
      diagnostics_.error(item.location, named.path, in_backticks(item.text) + " does not hold a mapping");
      return std::nullopt;
    }
    return node;
  }

  Diagnostics& diagnostics_;
  std::vector<std::filesystem::path> open_;  // the files that are being included, outermost first
  std::size_t files_ = 0;
};

}  // namespace

void include_pass(TextNode& root, Diagnostics& diagnostics) {
  Includer includer(diagnostics);
  includer.begin(root.location.file);
  includer.include(root);
}

}  // namespace thinwall

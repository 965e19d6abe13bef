#include <algorithm>
#include <set>
#include <system_error>

#include "renderer/image/PngFile.hpp"
#include "studio/comparison/FileComparison.hpp"

namespace thinwall {
namespace {

/// Relative paths of the files below a folder; hidden files and folders are left out. Throws ImageUnreadable.
std::set<std::filesystem::path> files_below(const std::filesystem::path& folder) try {
  std::set<std::filesystem::path> files;
  std::error_code unreadable;
  auto entry = std::filesystem::recursive_directory_iterator(folder);
  for (; entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    if (entry->path().filename().string().starts_with('.')) {
      entry.disable_recursion_pending();
    } else if (!entry->is_directory(unreadable)) {
      files.insert(entry->path().lexically_relative(folder));
    }
  }
  return files;
} catch (const std::filesystem::filesystem_error& error) {
  throw ImageUnreadable("cannot read all of the folder " + folder.string() + ": " + error.code().message());
}

}  // namespace

std::vector<FileComparison> compare_folders(const std::filesystem::path& first, const std::filesystem::path& second,
                                            const FileComparisonOptions& options) {
  const std::set<std::filesystem::path> in_first = files_below(first);
  const std::set<std::filesystem::path> in_second = files_below(second);
  std::set<std::filesystem::path> all = in_first;
  all.insert(in_second.begin(), in_second.end());
  std::vector<FileComparison> results;
  for (const std::filesystem::path& file : all) {
    if (in_first.count(file) > 0 && in_second.count(file) > 0) {
      results.push_back(compare_files(first / file, second / file, options));
      continue;
    }
    const bool is_in_first = in_first.count(file) > 0;
    results.push_back({.first = first / file,
                       .second = second / file,
                       .outcome = is_in_first ? FileOutcome::kOnlyInFirst : FileOutcome::kOnlyInSecond,
                       .verdict = is_in_first ? "missing in the second folder" : "missing in the first folder"});
  }
  return results;
}

}  // namespace thinwall

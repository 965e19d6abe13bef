#pragma once

#include <filesystem>

namespace thinwall {

/// Where something stands in a user's file. Lines and columns count from 1.
struct SourceLocation {
  std::filesystem::path file = {};
  int line = 1;
  int column = 1;
};

}  // namespace thinwall

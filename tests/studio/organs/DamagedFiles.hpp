#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "studio/organs/FileFormatError.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {

/// Reads the file cut off at each length and with changed bytes: each is read or refused with a place, nothing else.
template <typename Read>
void expect_damage_is_read_or_refused(const std::string& bytes, const Read& read) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "damaged";
  const auto attempt = [&](const std::string& damaged) {
    write_bytes(file, damaged);
    try {
      read(file);
    } catch (const FileFormatError& error) {
      EXPECT_GE(error.location().line, 1);
      EXPECT_GE(error.location().column, 1);
      EXPECT_STRNE(error.what(), "");
    }
  };
  for (std::size_t length = 0; length < bytes.size(); ++length) attempt(bytes.substr(0, length));
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    std::string damaged = bytes;
    for (int changes = 0; changes < 1 + trial % 4; ++changes) {
      damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    }
    attempt(damaged);
  }
}

}  // namespace thinwall

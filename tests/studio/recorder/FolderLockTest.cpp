#include "studio/recorder/FolderLock.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>

#include "renderer/image/PictureFailure.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

std::string refusal_of(const std::filesystem::path& folder) {
  try {
    const FolderLock lock(folder);
  } catch (const FolderInUse& error) {
    return error.what();
  } catch (const PictureFailure& failure) {
    return failure.what();
  }
  return "";
}

TEST(FolderLock, ASecondRunIsRefusedWithTheFirstOnesNumberUntilThatHasEnded) {
  const TemporaryFolder folder;
  std::optional<FolderLock> first(folder / "out");
  const std::string words = refusal_of(folder / "out");
  EXPECT_NE(words.find("process " + std::to_string(getpid()) + ","), std::string::npos) << words;
  EXPECT_NE(words.find("choose another folder with --out"), std::string::npos) << words;
  EXPECT_EQ(refusal_of(folder / "other"), "");
  first.reset();
  EXPECT_EQ(refusal_of(folder / "out"), "");
}

TEST(FolderLock, WhatAKilledRunLeftDoesNotCount) {
  const TemporaryFolder folder;
  write_bytes(folder / ".in_use", "12345678901234567890");
  const FolderLock lock(folder.path());
  EXPECT_EQ(file_bytes(folder / ".in_use"), std::to_string(getpid()));
}

TEST(FolderLock, NothingOfItStaysInTheFolder) {
  const TemporaryFolder folder;
  std::optional<FolderLock> lock(folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder / ".in_use"));
  lock.reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FolderLock, AFolderThatCannotBeMadeIsTold) {
  const TemporaryFolder folder;
  write_bytes(folder / "file", "");
  EXPECT_NE(refusal_of(folder / "file" / "out").find("cannot make the folder"), std::string::npos);
}

}  // namespace
}  // namespace thinwall

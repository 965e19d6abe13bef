#include "studio/golden/ApprovalFile.hpp"

#include <gtest/gtest.h>

#include "studio/golden/GoldenVideoApproval.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

class ApprovalFileTest : public ::testing::Test {
 protected:
  /// What is said of an approval.json of that text, without the folder; "" where it is read.
  std::string refusal(const std::string& text) { return told("approval.json", text, read_approvals); }
  std::string refusal_of_video(const std::string& text) { return told("video.0.json", text, read_video_approvals); }

  static constexpr const char* kCure =
      "; restore it from version control, or remove the scenario's folder and approve anew";

 private:
  template <typename Read>
  std::string told(const std::string& name, const std::string& text, Read&& read) {
    write_bytes(folder_ / name, text);
    try {
      read(folder_.path());
      return "";
    } catch (const GoldenError& error) {
      const std::string words = error.what(), place = folder_.path().string() + "/";
      return words.starts_with(place) ? words.substr(place.size()) : words;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(ApprovalFileTest, WhatIsNoJsonIsToldWithLineAndColumnAndTheCure) {
  EXPECT_EQ(refusal("{\n  \"goldens\": ["),
            std::string("approval.json:2:15: is damaged: the file ends in the middle") + kCure);
  EXPECT_EQ(refusal(""), std::string("approval.json:1:1: is damaged: the file ends in the middle") + kCure);
  EXPECT_EQ(refusal("{\n  \"goldens\": ]\n}"),
            std::string("approval.json:2:14: is damaged: JSON does not go on with ] here") + kCure);
}

TEST_F(ApprovalFileTest, TheConflictOfAMergeIsToldAsSuch) {
  const std::string words = refusal("{\n  \"approval_version\": 1,\n<<<<<<< HEAD\n=======\n>>>>>>> other\n}\n");
  EXPECT_TRUE(words.starts_with("approval.json:3:1: is damaged: a conflict of a merge begins here; take the folder "))
      << words;
  EXPECT_NE(words.find("git checkout --ours or --theirs"), std::string::npos) << words;
}

TEST_F(ApprovalFileTest, AValueThatIsMissingOrOfAnotherKindIsToldWithItsPlaceAndPath) {
  const std::string begin = "{\n  \"approval_version\": 1,\n  \"goldens\": [\n    {\"at_s\": ";
  EXPECT_EQ(refusal(begin + "\"1 s\"}\n  ]\n}"),
            std::string("approval.json:4:14: is damaged: goldens[1].at_s: expected a number, got \"1 s\"") + kCure);
  EXPECT_EQ(refusal(begin + "1}\n  ]\n}"),
            std::string("approval.json:4:5: is damaged: goldens[1]: `driver` is missing") + kCure);
  EXPECT_EQ(refusal("{\"approval_version\": 1,\n \"goldens\": {}}"),
            std::string("approval.json:2:13: is damaged: goldens: expected a list, got keys and values") + kCure);
  EXPECT_EQ(refusal("[]"),
            std::string("approval.json:1:1: is damaged: expected keys and values between braces, got a list") + kCure);
}

TEST_F(ApprovalFileTest, AnotherVersionIsNoDamage) {
  EXPECT_EQ(refusal("{\"approval_version\": 7}"),
            std::string("approval.json:1:22: approval_version: written by another version of the program: this one "
                        "reads version 1") +
                kCure);
}

TEST_F(ApprovalFileTest, ApprovalsOfVideosAreToldLikewise) {
  EXPECT_EQ(refusal_of_video("{\"video_approval_version\": 1,\n \"driver\": 3}"),
            std::string("video.0.json:2:12: is damaged: driver: expected a text, got 3") + kCure);
  EXPECT_EQ(refusal_of_video("{,"),
            std::string("video.0.json:1:2: is damaged: JSON does not go on with , here") + kCure);
}

}  // namespace
}  // namespace thinwall

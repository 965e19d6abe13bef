// What the program says and ends with where it compares.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/studio/commands/ProgramFixture.hpp"

namespace thinwall {
namespace {

TEST_F(ProgramTest, ToCompareTellsItsVerdictByTheExitCode) {
  const std::string black = "PF\n1 1\n-1.0\n" + std::string(12, '\0');
  write_bytes(folder_ / "a.pfm", black);
  write_bytes(folder_ / "b.pfm", black);
  write_bytes(folder_ / "c.pfm", black.substr(0, black.size() - 1) + "\x40");
  write_bytes(folder_ / "cut.pfm", black.substr(0, 15));
  EXPECT_EQ(run({"compare", "a.pfm", "b.pfm"}).exit_code, 0);
  const ProgramEnd different = run({"compare", "--json", "a.pfm", "c.pfm", "--diff", "d/e.png"});
  EXPECT_EQ(different.exit_code, 1) << different.messages;
  EXPECT_EQ(nlohmann::json::parse(different.output)["outcome"], "differs");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "d/e.png"));
  EXPECT_EQ(run({"compare", "a.pfm", "c.pfm", "--flip", "1"}).exit_code, 0);
  expect_bad_usage({"compare", "a.pfm", "cut.pfm"}, "cut short");
  expect_bad_usage({"compare", "a.pfm", "none.pfm"}, "none.pfm: no such file");
  expect_bad_usage({"compare", "a.pfm"}, "B is required");
  expect_bad_usage({"compare", "a.pfm", "b.pfm", "--metric", "beauty"}, "write pixels, ssim, flip or all");
  expect_bad_usage({"compare", "a.pfm", "b.pfm", "--max", "300"}, "--max");
  for (const char* option : {"--max=3", "--metric=all"}) {
    expect_bad_usage({"compare", "a.pfm", "b.pfm", "--layer", "depth", option},
                     "neither limits nor metrics of pictures");
  }
  expect_bad_usage({"compare", "a.pfm", "b.pfm", "--layer", "depth", "--tolerance", "-1"}, "--tolerance");
  expect_bad_usage({"compare", "a.pfm", "b.pfm", "--layer", "depth", "--diff", "d.png"}, "no picture of what differs");
  for (const char* text : {"nan", "-NaN"}) expect_bad_usage({"compare", "a.pfm", "b.pfm", "--mean", text}, "--mean");
  EXPECT_EQ(run({"compare", "a.pfm", "."}).exit_code, 1);
}

TEST_F(ProgramTest, ToCompareAFolderWithAFileIsAVerdictInJsonToo) {
  write_bytes(folder_ / "a.pfm", "PF\n1 1\n-1.0\n" + std::string(12, '\0'));
  const ProgramEnd other_kind = run({"compare", "a.pfm", ".", "--json"});
  EXPECT_EQ(other_kind.exit_code, 1);
  EXPECT_EQ(nlohmann::json::parse(other_kind.output)["outcome"], "differs");
  const ProgramEnd absent = run({"compare", ".", "none", "--json"});
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_EQ(nlohmann::json::parse(absent.output)["outcome"], "unreadable");
}

TEST_F(ProgramTest, ToCompareWhatCannotBeReadIsExitCode2AlsoWhereTheSystemRefuses) {
  for (const char* folder : {"one", "two"}) {
    std::filesystem::create_directory(folder_ / folder);
    write_bytes(folder_ / folder / "a.pfm", "PF\n1 1\n-1.0\n" + std::string(12, '\0'));
    std::filesystem::create_symlink("loop.png", folder_ / folder / "loop.png");
  }
  for (const std::vector<std::string>& pair :
       {std::vector<std::string>{"one/loop.png", "two/a.pfm"}, {"one", "two"}, {"one", "two/loop.png"}}) {
    const ProgramEnd end = run({"compare", pair[0], pair[1], "--json"});
    EXPECT_EQ(end.exit_code, 2) << end.messages;
    EXPECT_NE(end.output.find("\"unreadable\""), std::string::npos) << end.output;
  }
}

TEST_F(ProgramTest, APictureOfTheDifferenceOverwritesNothingThatIsCompared) {
  const std::string black = "PF\n1 1\n-1.0\n" + std::string(12, '\0');
  for (const char* name : {"a.pfm", "b.pfm"}) write_bytes(folder_ / name, black);
  std::filesystem::create_symlink("b.pfm", folder_ / "link.pfm");
  for (const char* name : {"a.pfm", "./b.pfm", "link.pfm"}) {
    expect_bad_usage({"compare", "a.pfm", "b.pfm", "--diff", name}, "would be overwritten");
  }
  EXPECT_EQ(file_bytes(folder_ / "a.pfm"), black);
  EXPECT_EQ(file_bytes(folder_ / "b.pfm"), black);
}

TEST_F(ProgramTest, APictureOfTheDifferenceIsAPngAndAnotherNameIsRefusedBeforeAnythingIsCompared) {
  const std::string black = "PF\n1 1\n-1.0\n" + std::string(12, '\0');
  for (const char* name : {"one/a.pfm", "two/a.pfm"}) {
    std::filesystem::create_directory((folder_ / name).parent_path());
    write_bytes(folder_ / name, name[0] == 'o' ? black : black.substr(0, black.size() - 1) + "\x40");
  }
  for (const char* name : {"d.jpg", "d.PNG", "d"}) {
    expect_bad_usage({"compare", "one/a.pfm", "two/a.pfm", "--diff", name}, "let its name end with .png");
    EXPECT_FALSE(std::filesystem::exists(folder_ / name));
  }
  expect_bad_usage({"compare", "one/a.pfm", "two/a.pfm", "--diff", "one"}, "this is a folder; name a picture in it");
  write_bytes(folder_ / "d.png", "a picture");
  expect_bad_usage({"compare", "one", "two", "--diff", "d.png"}, "go into a folder; choose another name");
  EXPECT_EQ(run({"compare", "one", "two", "--diff", "differences.jpg"}).exit_code, 1) << "a folder has any name";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "differences.jpg/a.pfm.difference.png"));
  EXPECT_EQ(run({"compare", "one", "two/a.pfm", "--diff", "d.jpg"}).exit_code, 1) << "there is no picture to be made";
}

}  // namespace
}  // namespace thinwall

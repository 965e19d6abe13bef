#include "studio/organs/CsvTable.hpp"

#include <gtest/gtest.h>

#include "tests/studio/organs/DamagedFiles.hpp"

namespace thinwall {
namespace {

std::vector<CsvColumn> read_text(const std::string& bytes, const std::vector<std::string>& names,
                                 const CsvLimits& limits = {}) {
  const TemporaryFolder folder;
  write_bytes(folder / "wall.csv", bytes);
  return read_csv_columns(folder / "wall.csv", names, limits);
}

/// "line:column: message"
std::string refusal_of(const std::string& bytes, const std::vector<std::string>& names = {"t"},
                       const CsvLimits& limits = {}) {
  try {
    read_text(bytes, names, limits);
  } catch (const FileFormatError& error) {
    return std::to_string(error.location().line) + ":" + std::to_string(error.location().column) + ": " + error.what();
  }
  return "accepted";
}

TEST(CsvTable, ColumnsComeInTheOrderAskedForWithTheirPlaces) {
  const std::vector<CsvColumn> columns = read_text("x, t ,\"a, b\"\n1, 2.5,+3\n-1e-3,\t4,\"7\"\n", {"a, b", "x"});
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(columns[0].values, (std::vector<double>{3, 7}));
  EXPECT_EQ(columns[0].lines, (std::vector<int>{2, 3}));
  EXPECT_EQ(columns[0].columns, (std::vector<int>{8, 10}));
  EXPECT_EQ(columns[1].values, (std::vector<double>{1, -1e-3}));
}

TEST(CsvTable, WhatProgramsAddMeansNothing) {
  const std::string plain = "t,u\n1,2\n3,4\n";
  for (const std::string text :
       {"\xEF\xBB\xBFt,u\n1,2\n3,4", "t,u\r\n1,2\r\n3,4\r\n\r\n", "\"t\",\"u\"\n1,2\n3,4\n\n\n"}) {
    EXPECT_EQ(read_text(text, {"t", "u"})[1].values, read_text(plain, {"u"})[0].values) << text;
  }
}

TEST(CsvTable, ATableWithoutRowsIsEmpty) {
  EXPECT_TRUE(read_text("t\n", {"t"})[0].values.empty());
}

TEST(CsvTable, ColumnsThatAreNotThereOnceAreTold) {
  EXPECT_EQ(refusal_of("thicknes,x\n1,2\n", {"thickness"}),
            "1:1: there is no column `thickness`, did you mean `thicknes`?; there is `thicknes`, `x`");
  EXPECT_EQ(refusal_of("t,x,t\n1,2,3\n"), "1:5: there are two columns `t`; give one another name");
  EXPECT_EQ(refusal_of("u;x\n1;2\n"),
            "1:1: there is no column `t`; there is `u;x`; columns are parted by commas, not semicolons");
  EXPECT_EQ(refusal_of(""), "1:1: the first line must name the columns, but is empty");
}

TEST(CsvTable, CellsThatAreNoFiniteNumbersAreToldWithTheCure) {
  const auto told = [](const std::string& place, const std::string& cell) {
    return place + ": expected a finite number in the column `t`, got `" + cell +
           "`; write plain numbers like 0.8 or 8e-4, without units";
  };
  EXPECT_EQ(refusal_of("x,t\n1,2\n1,thin\n"), told("3:3", "thin"));
  EXPECT_EQ(refusal_of("x,t\n1,nan\n"), told("2:3", "nan"));
  EXPECT_EQ(refusal_of("x,t\n1,-inf\n"), told("2:3", "-inf"));
  EXPECT_EQ(refusal_of("x,t\n1,1e999\n"), told("2:3", "1e999"));
  EXPECT_EQ(refusal_of("x,t\n1,+-2\n"), told("2:3", "+-2"));
  EXPECT_EQ(refusal_of("x,t\n1,2 mm\n"), told("2:3", "2 mm"));
  EXPECT_EQ(refusal_of("x,t\n1,\n"),
            "2:3: expected a finite number in the column `t`, got nothing; every row needs one");
  EXPECT_EQ(refusal_of("x,t\nwords,2\n"), "accepted");
}

TEST(CsvTable, LinesOfAnotherLengthAreTold) {
  EXPECT_EQ(refusal_of("x,t\n1,2\n3\n"), "3:1: 1 cell in a table with 2 columns");
  EXPECT_EQ(refusal_of("x,t\n1,2,3\n"), "2:5: 3 cells in a table with 2 columns");
  EXPECT_EQ(refusal_of("x,t\n1,2\n\n3,4\n"), "3:1: an empty line between rows; remove it");
  EXPECT_EQ(refusal_of("x,t\n\"1,2\n"), "2:1: a quotation mark is not closed in its line");
  EXPECT_EQ(refusal_of("x,t\n\"1\"2,3\n"), "2:4: expected a comma after the closing quotation mark");
}

TEST(CsvTable, LimitsHold) {
  EXPECT_NE(refusal_of("t\n1\n2\n3\n", {"t"}, {.numbers = 2}).find("4:1: it holds more than 2 numbers"),
            std::string::npos);
  EXPECT_NE(refusal_of("t\n1\n", {"t"}, {.file_bytes = 3}).find("larger than the 3 bytes"), std::string::npos);
  EXPECT_THROW(read_csv_columns("no/such.csv", {"t"}), FileFormatError);
}

TEST(CsvTable, DamageIsReadOrRefused) {
  expect_damage_is_read_or_refused("x,\"t\",u\n1,2.5,3\n-1e-3,4,\"7\"\n5,6,7\n", [](const auto& file) {
    read_csv_columns(file, {"t", "u"});
  });
}

}  // namespace
}  // namespace thinwall

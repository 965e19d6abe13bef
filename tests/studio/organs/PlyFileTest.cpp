#include "studio/organs/PlyFile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/studio/organs/DamagedFiles.hpp"

namespace thinwall {
namespace {

const std::string kHeader =
    "element vertex 4\n"
    "property float x\n"
    "property float y\n"
    "property double thickness\n"
    "property float z\n"
    "property short side\n"
    "element material 1\n"
    "property list uchar int numbers\n"
    "property uchar shade\n"
    "element face 2\n"
    "property uint mark\n"
    "property list uchar int vertex_indices\n"
    "end_header\n";

const std::string kAscii = "ply\r\nformat ascii 1.0\ncomment by hand\n" + kHeader +
                           "0 0 0.25 0 -3\n"
                           "1 0 1e-3 0 7\n"
                           "1 +1 2 0.5 8\n"
                           "0 1 4 0 9\n"
                           "2 5 6 200\n"
                           "10 3 0 1 2\n"
                           "4000000000 4 0 1 2 3\n";

template <typename Number>
void put(std::string& bytes, Number number, bool is_big) {
  std::string raw(sizeof(Number), '\0');
  std::memcpy(raw.data(), &number, sizeof(Number));
  if (is_big) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

/// The same file as kAscii.
std::string binary(bool is_big) {
  std::string bytes = std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" + kHeader;
  const double thickness[] = {0.25, 1e-3, 2, 4};
  const float places[][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 1, 0}};
  const std::int16_t sides[] = {-3, 7, 8, 9};
  for (int v = 0; v < 4; ++v) {
    put(bytes, places[v][0], is_big);
    put(bytes, places[v][1], is_big);
    put(bytes, thickness[v], is_big);
    put(bytes, places[v][2], is_big);
    put(bytes, sides[v], is_big);
  }
  put<std::uint8_t>(bytes, 2, is_big);
  put<std::int32_t>(bytes, 5, is_big);
  put<std::int32_t>(bytes, 6, is_big);
  put<std::uint8_t>(bytes, 200, is_big);
  put<std::uint32_t>(bytes, 10, is_big);
  put<std::uint8_t>(bytes, 3, is_big);
  for (const std::int32_t corner : {0, 1, 2}) put(bytes, corner, is_big);
  put<std::uint32_t>(bytes, 4000000000, is_big);
  put<std::uint8_t>(bytes, 4, is_big);
  for (const std::int32_t corner : {0, 1, 2, 3}) put(bytes, corner, is_big);
  return bytes;
}

PlyFile read_ply_text(const std::string& bytes, const PlyLimits& limits = {}) {
  const TemporaryFolder folder;
  write_bytes(folder / "wall.ply", bytes);
  return read_ply(folder / "wall.ply", limits);
}

/// "line:column: message"
std::string ply_refusal_of(const std::string& bytes, const PlyLimits& limits = {}) {
  try {
    read_ply_text(bytes, limits);
  } catch (const FileFormatError& error) {
    return std::to_string(error.location().line) + ":" + std::to_string(error.location().column) + ": " + error.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

void expect_the_file(const PlyFile& ply) {
  ASSERT_EQ(ply.vertices.size(), 4u);
  EXPECT_EQ(ply.vertices[2], Eigen::Vector3d(1, 1, 0.5));
  EXPECT_EQ(ply.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 2, 3}}));
  ASSERT_EQ(ply.vertex_properties.size(), 2u);
  EXPECT_EQ(ply.vertex_properties[0].name, "thickness");
  EXPECT_EQ(ply.vertex_properties[0].values, (std::vector<double>{0.25, 1e-3, 2, 4}));
  EXPECT_EQ(ply.vertex_properties[1].name, "side");
  EXPECT_EQ(ply.vertex_properties[1].values, (std::vector<double>{-3, 7, 8, 9}));
  ASSERT_EQ(ply.face_properties.size(), 1u);
  EXPECT_EQ(ply.face_properties[0].name, "mark");
  EXPECT_EQ(ply.face_properties[0].values, (std::vector<double>{10, 4e9}));
}

TEST(PlyFile, TextAndBothByteOrdersGiveTheSame) {
  const PlyFile ascii = read_ply_text(kAscii);
  expect_the_file(ascii);
  EXPECT_EQ(ascii.vertex_lines, (std::vector<int>{17, 18, 19, 20}));
  EXPECT_EQ(ascii.face_lines, (std::vector<int>{22, 23}));
  for (const bool is_big : {false, true}) {
    const PlyFile ply = read_ply_text(binary(is_big));
    expect_the_file(ply);
    EXPECT_TRUE(ply.vertex_lines.empty());
  }
}

TEST(PlyFile, NumbersThatAreNoneAreKeptInProperties) {
  const PlyFile ply = read_ply_text(replaced(kAscii, "1e-3", "nan"));
  EXPECT_TRUE(std::isnan(ply.vertex_properties[0].values[1]));
}

TEST(PlyFile, MistakesOfTheHeaderAreToldWithTheirLine) {
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "ply", "plx")), "1:1: a PLY file begins with the line `ply`");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "ascii", "binary")),
            "2:1: the format is `ascii`, `binary_little_endian` or `binary_big_endian`, not `binary`");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "property float y", "property half y")),
            "6:1: there is no type of numbers `half`");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "property short side", "property short x")),
            "9:1: the property `x` is there twice");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "element vertex 4", "element vertex four")),
            "4:1: expected `element NAME COUNT`");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "comment by hand", "remark by hand")),
            "3:1: the header knows `format`, `element`, `property`, `comment` and `end_header`, not `remark`");
  EXPECT_EQ(ply_refusal_of("ply\nformat ascii 1.0\n"),
            "3:1: the header has no line `end_header`; the file is cut off or is no PLY file");
}

TEST(PlyFile, MistakesOfTheNumbersAreToldWithTheirPlace) {
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "1e-3", "thin")), "18:5: expected a number, got `thin`");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "3 0 1 2", "3 0 1 4")),
            "22:1: face 1 has the corner 4, but there are 4 vertices");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "4 0 1 2 3", "4 0 1 2")),
            "24:1: the file ends before all that its header announces");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "1 +1 2", "1 inf 2")),
            "19:1: a coordinate of vertex 3 is no finite number");
  EXPECT_EQ(ply_refusal_of(replaced(kAscii, "3 0 1 2\n", "3 0 1 1.5\n")), "22:10: 1.5 is no corner of a face");
}

TEST(PlyFile, CountsThatTheFileCannotHoldAreRefusedBeforeAnythingIsMade) {
  EXPECT_NE(ply_refusal_of(replaced(kAscii, "vertex 4", "vertex 4000000000")).find("more than the file holds"),
            std::string::npos);
  EXPECT_NE(ply_refusal_of(replaced(binary(false), "vertex 4", "vertex 99999999999")).find("at byte"),
            std::string::npos);
  EXPECT_NE(ply_refusal_of(kAscii, {.numbers = 10}).find("more than 10 numbers"), std::string::npos);
  EXPECT_NE(ply_refusal_of(kAscii, {.file_bytes = 20}).find("larger than the 20 bytes"), std::string::npos);
}

TEST(PlyFile, AFileThatIsNotThereIsTold) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_ply(folder / "none.ply"), FileFormatError);
  EXPECT_THROW(read_ply(folder.path()), FileFormatError);
}

TEST(PlyFile, DamageIsReadOrRefused) {
  for (const std::string& bytes : {kAscii, binary(false), binary(true)})
    expect_damage_is_read_or_refused(bytes, [](const auto& file) { read_ply(file); });
}

}  // namespace
}  // namespace thinwall

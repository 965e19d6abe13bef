#include "studio/organs/ObjOutline.hpp"

#include <gtest/gtest.h>

#include "tests/studio/organs/DamagedFiles.hpp"

namespace thinwall {
namespace {

const std::string kFile =
    "# a roof\n"
    "mtllib no.mtl\n"
    "v 0 0 0\n"
    "v 1 0 0\r\n"
    "vt 0.5 0.5\n"
    "vn 0 0 1\n"
    "  v +1 1e0 -0.5 0.1 0.2 0.3\n"
    "g wall\n"
    "f 1 2/1 3/1/1\n"
    "v 0 1 0\n"
    "f -4//1 -2//1 -1\n"
    "f 1 2 3 4";

ObjOutline read_text(const std::string& bytes, const ObjLimits& limits = {}) {
  const TemporaryFolder folder;
  write_bytes(folder / "roof.obj", bytes);
  return read_obj_outline(folder / "roof.obj", limits);
}

/// "line:column: message"
std::string refusal_of(const std::string& bytes, const ObjLimits& limits = {}) {
  try {
    read_text(bytes, limits);
  } catch (const FileFormatError& error) {
    return std::to_string(error.location().line) + ":" + std::to_string(error.location().column) + ": " + error.what();
  }
  return "accepted";
}

TEST(ObjOutline, VerticesAndFacesComeInTheOrderOfTheFile) {
  const ObjOutline outline = read_text(kFile);
  EXPECT_EQ(outline.vertices, (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, -0.5}, {0, 1, 0}}));
  EXPECT_EQ(outline.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2, 3}}));
}

TEST(ObjOutline, AFaceMayStandBeforeItsVertices) {
  EXPECT_EQ(read_text("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").faces, (std::vector<std::vector<int>>{{0, 1, 2}}));
}

TEST(ObjOutline, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(refusal_of("v 0 0 up\n"), "1:7: expected a finite number, got `up`");
  EXPECT_EQ(refusal_of("v 0 nan 0\n"), "1:5: expected a finite number, got `nan`");
  EXPECT_EQ(refusal_of("v 0 0\n"), "1:6: a vertex has three coordinates");
  EXPECT_EQ(refusal_of("v 0 0 0\nf 1 0 1\n"), "2:5: expected a corner of a face, got `0`");
  EXPECT_EQ(refusal_of("v 0 0 0\nf 1 -2 1\n"), "2:5: expected a corner of a face, got `-2`");
  EXPECT_EQ(refusal_of("v 0 0 0\nf 1 1\n"), "2:6: a face has three corners or more");
  EXPECT_EQ(refusal_of("v 0 0 0\nf 1 1 2\n"), "2:1: a face has the corner 2, but there are 1 vertices");
  EXPECT_EQ(refusal_of("v 0 0 \\\n0\n"),
            "1:7: a line that is continued by `\\` is not read here; write it in one line");
}

TEST(ObjOutline, LimitsHold) {
  EXPECT_NE(refusal_of(kFile, {.numbers = 5}).find("more than 5 numbers"), std::string::npos);
  EXPECT_NE(refusal_of(kFile, {.file_bytes = 5}).find("larger than the 5 bytes"), std::string::npos);
}

TEST(ObjOutline, DamageIsReadOrRefused) {
  expect_damage_is_read_or_refused(kFile, [](const auto& file) { read_obj_outline(file); });
}

}  // namespace
}  // namespace thinwall

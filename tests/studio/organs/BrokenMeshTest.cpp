#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "studio/organs/BodyBuilder.hpp"
#include "studio/organs/MeshFile.hpp"

namespace thinwall {
namespace {

const std::filesystem::path kBroken = std::filesystem::path(THINWALL_SOURCE_DIR) / "tests/studio/organs/broken";

struct BrokenMesh {
  const char* file;
  std::vector<std::string> messages;  // after "scene.yaml:4:14: error: bodies.organ.surface: mesh `FILE`: "
};

void PrintTo(const BrokenMesh& mesh, std::ostream* out) {
  *out << mesh.file;
}

const BrokenMesh kMeshes[] = {
    {"missing.obj", {"there is no such file"}},
    {".", {"it is not a file"}},
    {"empty.obj", {"the file is empty"}},
    {"words.txt", {"`.txt` is no mesh format that can be read; OBJ, PLY, STL, OFF and glTF are the common ones"}},
    {"words.obj", {"it holds no triangles"}},
    {"points_only.obj", {"it holds points or lines, but no triangles or polygons"}},
    {"lines_only.obj", {"it holds points or lines, but no triangles or polygons"}},
    {"corner_out_of_range.obj", {"it is malformed: OBJ: vertex index out of range"}},
    {"corner_out_of_range.ply", {"a face has the corner 7, but there are 3 vertices"}},
    {"cut_off.gltf", {"what it holds is not `.gltf`, or is cut off"}},
    {"cut_off.off", {"the reader of its format crashes on it: it is malformed; save it anew from a modelling program"}},
    {"cut_off.stl", {"it is malformed: Failed to determine STL storage representation for cut_off.stl."}},
    {"counts_too_large.off", {"reading it takes more than 4096 MiB of memory"}},
    {"not_a_number.obj", {"the coordinates (nan, 0, 0) of a vertex are no finite numbers; mend or remove it"}},
    {"infinite.off", {"the coordinates (inf, 0, 0) of a vertex are no finite numbers; mend or remove it"}},
    {"one_point.obj", {"all its vertices are at one place"}},
    {"straight_line.obj", {"all its triangles are flat or collapsed to a point: nothing is left"}},
    {"moebius_band.obj",
     {"it has no inside and outside: like a Moebius band, its triangles cannot be turned to agree everywhere"}},
    {"open_box.obj",
     {"the fluid needs a closed surface, but this has 4 open edges around 1 hole: (10, 0, 10) to (0, 0, 10), "
      "(10, 0, 10) to (10, 10, 10), (0, 0, 10) to (0, 10, 10) and 1 more, in units of the file; close the surface, or "
      "say `contents: { fluid: none }`"}},
    {"open_tube.obj",
     {"the fluid needs a closed surface, but this has 8 open edges around 2 holes: (0, 0, 0) to (10, 0, 0), (0, 0, 0) "
      "to (0, 10, 0), (10, 0, 0) to (10, 10, 0) and 5 more, in units of the file; close the surface, or say "
      "`contents: { fluid: none }`"}},
    {"branching_wall.obj",
     {"the fluid needs a surface with one inside, but this has 4 edges shared by more than two triangles: (0, 0, 0) to "
      "(10, 0, 0), (0, 0, 0) to (0, 10, 10), (10, 0, 0) to (10, 10, 10) and 1 more, in units of the file; the wall "
      "branches there; take the inner surfaces out of the mesh"}},
    {"touching_tips.obj",
     {"the fluid needs a surface that touches itself nowhere, but this has 1 vertex in which parts of it touch: "
      "(0, 0, 0), in units of the file; move the parts apart there",
      "a body with fluid is one closed surface, but this has 2 separate ones: 4 triangles with 50.0 % of the area, 4 "
      "triangles with 50.0 % of the area; keep one of them, or make a body of each (parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"two_boxes.obj",
     {"a body with fluid is one closed surface, but this has 2 separate ones: 12 triangles with 80.0 % of the area, 12 "
      "triangles with 20.0 % of the area; keep one of them, or make a body of each (parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"box_in_box.obj",
     {"a body with fluid is one closed surface, but this has 2 separate ones: 12 triangles with 73.5 % of the area, 12 "
      "triangles with 26.5 % of the area; keep one of them, or make a body of each (parts of under 1 % of the area "
      "together are left out by themselves)"}},
};

class BrokenMeshes : public testing::TestWithParam<BrokenMesh> {
 protected:
  // Messages name the file as the scenario does: relative.
  void SetUp() override { std::filesystem::current_path(kBroken); }
};

TEST_P(BrokenMeshes, AreRefusedWithTheReason) {
#ifdef __SANITIZE_ADDRESS__
  if (GetParam().file == std::string("counts_too_large.off")) GTEST_SKIP() << "memory is not limited in this build";
#endif
  BodyScenario body;
  body.name = "organ";
  body.surface_location = {"scene.yaml", 4, 14};
  body.surface = MeshFileSource{.file = GetParam().file, .unit = 1e-3};
  body.thickness.standard = 1e-3;
  std::string expected;
  for (const std::string& message : GetParam().messages) {
    expected += (expected.empty() ? "" : "\n") + std::string("scene.yaml:4:14: error: bodies.organ.surface: mesh `") +
                GetParam().file + "`: " + message;
  }
  std::vector<std::string> notes;
  try {
    build_body(body, notes);
    FAIL() << "was accepted";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(errors.what(), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenMeshes, testing::ValuesIn(kMeshes));

TEST(MeshFileReader, RunawayReaderIsStopped) {
  // The header of this PLY file never ends, and the reader looks for its end for ever.
  try {
    read_mesh_file(kBroken / "cut_off.ply", {.processor_seconds = 1});
    FAIL() << "was accepted";
  } catch (const MeshFileError& error) {
    EXPECT_STREQ(error.what(), "reading it takes more than 1 s; it is malformed or far too large");
  }
}

TEST(MeshFileReader, LimitsAreTold) {
  const auto message = [](const MeshFileLimits& limits) -> std::string {
    try {
      read_mesh_file(kBroken / "open_box.obj", limits);
    } catch (const MeshFileError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message({}), "accepted");
  EXPECT_EQ(message({.triangles = 9}), "it has more than 9 triangles, which is the most that is read; reduce it first");
  EXPECT_EQ(message({.file_bytes = 100}), "the file is larger than the 100 bytes that are read; reduce the mesh first");
}

}  // namespace
}  // namespace thinwall

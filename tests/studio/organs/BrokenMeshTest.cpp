#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/BodyBuilder.hpp"
#include "studio/organs/MeshFile.hpp"

namespace thinwall {
namespace {

const std::filesystem::path kBroken = std::filesystem::path(THINWALL_SOURCE_DIR) / "tests/studio/organs/broken";

struct BrokenMesh {
  const char* file;
  bool repair = false;
  std::vector<std::string> messages;  // after "scene.yaml:4:14: error: bodies.organ.surface: mesh `FILE`: "
};

void PrintTo(const BrokenMesh& mesh, std::ostream* out) {
  *out << mesh.file;
}

const BrokenMesh kMeshes[] = {
    {"missing.obj", false, {"there is no such file"}},
    {".", false, {"it is not a file"}},
    {"empty.obj", false, {"the file is empty"}},
    {"words.txt",
     false,
     {"`.txt` is no mesh format that can be read; OBJ, PLY, STL, OFF and glTF are the common ones"}},
    {"words.obj", false, {"it holds no triangles"}},
    {"points_only.obj", false, {"it holds points or lines, but no triangles or polygons"}},
    {"lines_only.obj", false, {"it holds points or lines, but no triangles or polygons"}},
    {"corner_out_of_range.obj", false, {"it is malformed: OBJ: vertex index out of range"}},
    {"corner_out_of_range.ply", false, {"a face has the corner 7, but there are 3 vertices"}},
    {"cut_off.gltf", false, {"what it holds is not `.gltf`, or is cut off"}},
    {"cut_off.off",
     false,
     {"the reader of its format crashes on it: it is malformed; save it anew from a modelling program"}},
    {"cut_off.stl",
     false,
     {"its head announces 12 triangles, and 2 are there: it is cut off, or no binary STL; copy it anew, or save it "
      "anew "
      "from a modelling program"}},
    {"cut_off_solid.stl",
     false,
     {"its head announces 4 triangles, and 2 are there: it is cut off, or no binary STL; copy it anew, or save it anew "
      "from a modelling program"}},
    {"counts_too_large.off", false, {"reading it takes more than 4096 MiB of memory"}},
    {"not_a_number.obj", false, {"the coordinates (nan, 0, 0) of a vertex are no finite numbers; mend or remove it"}},
    {"infinite.off", false, {"the coordinates (inf, 0, 0) of a vertex are no finite numbers; mend or remove it"}},
    {"one_point.obj", false, {"all its vertices are at one place"}},
    {"straight_line.obj", false, {"all its triangles are flat or collapsed to a point: nothing is left"}},
    {"moebius_band.obj",
     false,
     {"it has no inside and outside: like a Moebius band, its triangles cannot be turned to agree everywhere"}},
    {"open_box.obj",
     false,
     {"the fluid needs a closed surface, but this has 4 open edges around 1 hole: (10, 0, 10) to (0, 0, 10), "
      "(10, 0, 10) to (10, 10, 10), (0, 0, 10) to (0, 10, 10) and 1 more, in units of the file; close the surface, or "
      "say `contents: { fluid: none }`"}},
    {"open_tube.obj",
     false,
     {"the fluid needs a closed surface, but this has 8 open edges around 2 holes: (0, 0, 0) to (10, 0, 0), (0, 0, 0) "
      "to (0, 10, 0), (10, 0, 0) to (10, 10, 0) and 5 more, in units of the file; close the surface, or say "
      "`contents: { fluid: none }`"}},
    {"branching_wall.obj",
     false,
     {"the fluid needs a surface with one inside, but this has 4 edges shared by more than two triangles: (0, 0, 0) to "
      "(10, 0, 0), (0, 0, 0) to (0, 10, 10), (10, 0, 0) to (10, 10, 10) and 1 more, in units of the file; the wall "
      "branches there; take the inner surfaces out of the mesh"}},
    {"touching_tips.obj",
     false,
     {"the fluid needs a surface that touches itself nowhere, but this has 1 vertex in which parts of it touch: "
      "(0, 0, 0), in units of the file; move the parts apart there",
      "a body with fluid is one closed surface, but this has 2 separate ones: 4 triangles with 50.0 % of the area, 4 "
      "triangles with 50.0 % of the area; keep one of them, name each in `contents.chambers`, or make a body of each "
      "(parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"two_boxes.obj",
     false,
     {"a body with fluid is one closed surface, but this has 2 separate ones: 12 triangles with 80.0 % of the area, 12 "
      "triangles with 20.0 % of the area; keep one of them, name each in `contents.chambers`, or make a body of each "
      "(parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"box_in_box.obj",
     false,
     {"a body with fluid is one closed surface, but this has 2 separate ones: 12 triangles with 73.5 % of the area, 12 "
      "triangles with 26.5 % of the area; keep one of them, name each in `contents.chambers`, or make a body of each "
      "(parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"small_hole.obj",
     false,
     {"the fluid needs a closed surface, but this has 4 open edges around 1 hole: (5, 4, 10) to (4, 4, 10), (5, 4, 10) "
      "to (5, 5, 10), (4, 4, 10) to (4, 5, 10) and 1 more, in units of the file; close the surface, or say `contents: "
      "{ fluid: none }`; `repair: true` would mend it"}},
    {"crack.obj",
     false,
     {"the fluid needs a closed surface, but this has 3 open edges around 1 hole: (10, 0, 10) to (0, 0, 10), (10, 0, "
      "10) to (5, 0, 10), (0, 0, 10) to (5, 0, 10), in units of the file; close the surface, or say `contents: { "
      "fluid: none }`; `repair: true` would mend it"}},
    {"flap.obj",
     false,
     {"the fluid needs a closed surface, but this has 2 open edges around 1 hole: (0, 0, 10) to (5, -1, 11), (10, 0, "
      "10) to (5, -1, 11), in units of the file; close the surface, or say `contents: { fluid: none }`; `repair: true` "
      "would mend it",
      "the fluid needs a surface with one inside, but this has 1 edge shared by more than two triangles: (0, 0, 10) to "
      "(10, 0, 10), in units of the file; the wall branches there; take the inner surfaces out of the mesh; `repair: "
      "true` would mend it"}},
    {"touching_edge.obj",
     false,
     {"the fluid needs a surface with one inside, but this has 1 edge shared by more than two triangles: (1, 1, 1) to "
      "(1, 1, 2), in units of the file; the wall branches there; take the inner surfaces out of the mesh; `repair: "
      "true` would mend it"}},
    {"touching_corner.obj",
     false,
     {"the fluid needs a surface that touches itself nowhere, but this has 1 vertex in which parts of it touch: (1, 1, "
      "1), in units of the file; move the parts apart there; `repair: true` would mend it"}},
    {"open_box.obj",
     true,
     {"the fluid needs a closed surface, but this has 4 open edges around 1 hole: (10, 0, 10) to (0, 0, 10), (10, 0, "
      "10) to (10, 10, 10), (0, 0, 10) to (0, 10, 10) and 1 more, in units of the file; close the surface (`repair: "
      "true` fills holes of up to 64 edges, up to 10 % of the surface's extent across), or say `contents: { fluid: "
      "none }`"}},
    {"branching_wall.obj",
     true,
     {"repair cannot tell inside from outside at 4 edges shared by more than two triangles, with the middles (5, 0, "
      "0), (0, 5, 5), (10, 5, 5) and 1 more, in units of the file; the wall branches there; take the inner surfaces "
      "out of the mesh"}},
    {"doubled_partition.obj",
     true,
     {"a body with fluid is one closed surface, but this has 2 separate ones: 12 triangles with 50.0 % of the area, 12 "
      "triangles with 50.0 % of the area; keep one of them, name each in `contents.chambers`, or make a body of each "
      "(parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"touching_tips.obj",
     true,
     {"a body with fluid is one closed surface, but this has 2 separate ones: 4 triangles with 50.0 % of the area, 4 "
      "triangles with 50.0 % of the area; keep one of them, name each in `contents.chambers`, or make a body of each "
      "(parts of under 1 % of the area "
      "together are left out by themselves)"}},
    {"moebius_band.obj",
     true,
     {"it has no inside and outside: like a Moebius band, its triangles cannot be turned to agree everywhere"}},
};

struct MendedMesh {
  const char* file;
  double volume;                   // units of the file
  std::vector<std::string> notes;  // after "mesh `FILE`: "
};

void PrintTo(const MendedMesh& mesh, std::ostream* out) {
  *out << mesh.file;
}

const MendedMesh kMended[] = {
    {"small_hole.obj",
     1000,
     {"1 hole filled: 4 edges, 1.41 across, at (4.5, 4.5, 10), in units of the file",
      "20 triangles, 12 vertices, closed, 10 x 10 x 10 mm, smallest angle 5 deg, groups `wall`"}},
    {"crack.obj",
     1000,
     {"1 hole filled: 3 edges, 10 across, at (5, 0, 10), in units of the file",
      "1 flat triangle of the filling merged into neighbours",
      "14 triangles, 9 vertices, closed, 10 x 10 x 10 mm, smallest angle 18 deg, groups `wall`"}},
    {"flap.obj",
     1000,
     {"1 flap with 1 triangle that hung on the surface removed: (5, -0.333333, 10.3333), in units of the file",
      "12 triangles, 8 vertices, closed, 10 x 10 x 10 mm, smallest angle 45 deg, groups `wall`"}},
    {"touching_edge.obj",
     6,
     {"1 edge shared by more than two triangles split apart, middles at (1, 1, 1.5), in units of the file",
      "48 triangles, 26 vertices, closed, 2 x 2 x 2 mm, smallest angle 45 deg, groups `wall`"}},
    {"touching_corner.obj",
     8,
     {"1 vertex in which parts touched split apart: (1, 1, 1), in units of the file",
      "68 triangles, 36 vertices, closed, 3 x 3 x 2 mm, smallest angle 45 deg, groups `wall`"}},
    {"bytes_behind.stl",
     1000,
     {"7 bytes behind the 12 triangles that its head announces left out",
      "12 triangles, 8 vertices, closed, 10 x 10 x 10 mm, smallest angle 45 deg, groups `wall`"}},
    {"doubled.obj",
     1000,
     {"21 vertices welded to others nearer than 1.73e-05 units of the file",
      "12 triangles with the corners of another removed",
      "12 triangles, 8 vertices, closed, 10 x 10 x 10 mm, smallest angle 45 deg, groups `wall`"}},
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
  body.surface = MeshFileSource{.file = GetParam().file, .unit = 1e-3, .repair = GetParam().repair};
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

class MendedMeshes : public testing::TestWithParam<MendedMesh> {
 protected:
  void SetUp() override { std::filesystem::current_path(kBroken); }
};

TEST_P(MendedMeshes, AreClosedAndEachThingDoneIsTold) {
  BodyScenario body;
  body.name = "organ";
  body.surface = MeshFileSource{.file = GetParam().file, .unit = 1e-3, .repair = true};
  body.thickness.standard = 1e-3;
  std::vector<std::string> notes;
  const SurfaceMesh mesh = build_body(body, notes).mesh;
  EXPECT_TRUE(is_closed(topology_of(static_cast<int>(mesh.vertices.size()), mesh.triangles)));
  EXPECT_NEAR(1e9 * enclosed_volume(mesh), GetParam().volume, 1e-5 * GetParam().volume);
  std::vector<std::string> expected;
  for (const std::string& note : GetParam().notes) {
    expected.push_back("mesh `" + std::string(GetParam().file) + "`: " + note);
  }
  EXPECT_EQ(notes, expected);
}

INSTANTIATE_TEST_SUITE_P(Files, MendedMeshes, testing::ValuesIn(kMended));

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

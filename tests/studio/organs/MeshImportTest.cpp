#include "studio/organs/MeshImport.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <numbers>
#include <tuple>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "studio/organs/ClosedCheck.hpp"

namespace thinwall {
namespace {

const SourceLocation kHere = {"scene.yaml", 4, 14};

std::filesystem::path write_file(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

ImportedMesh import(const std::filesystem::path& file, double unit = 1) {
  return import_mesh(file, mesh_origin(file, unit, "bodies.organ.surface", kHere));
}

/// A unit cube of quadrilaterals.
const std::string kCubeVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
const std::string kCubeSides = "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string kCubeEnds = "f 1 4 3 2\nf 5 6 7 8\n";

TEST(MeshImport, PolygonsAreTriangulatedAndUnitsApplied) {
  const ImportedMesh cube = import(write_file("cube.obj", kCubeVertices + kCubeSides + kCubeEnds), 0.01);
  EXPECT_EQ(cube.mesh.vertices.size(), 8u);
  EXPECT_EQ(cube.mesh.triangles.size(), 12u);
  // Coordinates come in single precision, in which the corners of this cube are exact.
  EXPECT_NEAR(enclosed_volume(cube.mesh), 1e-6, 1e-20);
  EXPECT_NO_THROW(check_closed_for_fluid(cube.mesh, {}));
}

TEST(MeshImport, ASizeThatNoOrganHasIsToldWithTheUnitThatMayBeMeant) {
  std::string vertices = kCubeVertices;
  for (std::size_t k = 0; (k = vertices.find(" 1", k)) != std::string::npos;) vertices.replace(k, 2, " 30");
  const std::filesystem::path cube = write_file("sized.obj", vertices + kCubeSides + kCubeEnds);
  const auto last_note = [&](double unit) { return import(cube, unit).notes.back(); };
  const std::string name = "mesh `" + cube.generic_string() + "` is ";
  const std::string advice = " m across, which no organ is: see whether `unit` is the file's";
  EXPECT_EQ(last_note(1), name + "30" + advice + "; with `unit: mm` it is 30 mm");
  EXPECT_EQ(last_note(1e-6), name + "3e-05" + advice + "; with `unit: mm` it is 30 mm");
  EXPECT_NE(last_note(0.05).find("groups"), std::string::npos) << "1.5 m may be a whole belly";
}

TEST(MeshImport, ASurfaceThatPassesThroughItselfIsToldWithThePlaces) {
  // The top's middle hangs out below the bottom.
  const std::string spike = "v 0.4 0.6 -1\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n";
  const ImportedMesh mesh = import(write_file("spiked.obj", kCubeVertices + spike + kCubeSides + "f 1 4 3 2\n"));
  const auto told = std::find_if(mesh.notes.begin(), mesh.notes.end(), [](const std::string& note) {
    return note.find("edges pass through the surface, with the middles (") != std::string::npos;
  });
  EXPECT_NE(told, mesh.notes.end());
  for (const std::string& note : import(write_file("sound.obj", kCubeVertices + kCubeSides + kCubeEnds)).notes) {
    EXPECT_EQ(note.find("through the surface"), std::string::npos) << note;
  }
}

/// A second cube with edges of a half from `low` on, whose vertices follow those of the first.
std::string second_cube(double low) {
  const std::string a = " " + std::to_string(low), b = " " + std::to_string(low + 0.5);
  std::string text;
  for (const std::string& z : {a, b})
    text += "v" + a + a + z + "\nv" + b + a + z + "\nv" + b + b + z + "\nv" + a + b + z + "\n";
  return text + "f 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\nf 9 12 11 10\nf 13 14 15 16\n";
}

TEST(MeshImport, APartWithinAnotherIsToldAsNothingAroundItPressesOnIt) {
  const auto notes_of = [](const std::string& text) {
    std::vector<std::string> notes = import(write_file("nested.obj", text)).notes;
    std::erase_if(notes, [](const std::string& note) { return note.find("within another") == std::string::npos; });
    return notes;
  };
  const std::vector<std::string> told = notes_of(kCubeVertices + kCubeSides + kCubeEnds + second_cube(0.25));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("1 separate part lies within another (12 triangles); "), std::string::npos) << told[0];
  EXPECT_TRUE(notes_of(kCubeVertices + kCubeSides + kCubeEnds + second_cube(1.5)).empty()) << "beside it";
  EXPECT_TRUE(notes_of(kCubeVertices + kCubeSides + "f 1 4 3 2\n" + second_cube(0.25)).empty()) << "in an open box";
}

TEST(MeshImport, AWallThatChambersShareIsToldToBeTwo) {
  const SurfaceMesh mesh =
      import(write_file("septum.obj", kCubeVertices + kCubeSides + kCubeEnds + "f 1 3 7 5\n")).mesh;
  try {
    check_closed_for_fluid(mesh, {"mesh `septum.obj`", 1, "units of the file", "bodies.organ.surface", kHere},
                           "close the surface", 2);
    FAIL() << "was taken";
  } catch (const InputErrors& errors) {
    const std::string words =
        "; the wall branches there; give each chamber a closed wall of its own, with a gap between";
    EXPECT_NE(std::string(errors.what()).find(words), std::string::npos) << errors.what();
  }
}

TEST(MeshImport, GroupsOfFacesBecomeGroupsOfVertices) {
  const std::string text = kCubeVertices + "g sides\n" + kCubeSides + "g lid\nf 5 6 7 8\ng sides\nf 1 4 3 2\n";
  const SurfaceMesh mesh = import(write_file("groups.obj", text)).mesh;
  ASSERT_EQ(mesh.groups.size(), 3u);
  EXPECT_EQ(mesh.groups.at("sides").size(), 8u);
  EXPECT_EQ(mesh.groups.at("wall").size(), 8u);
  ASSERT_EQ(mesh.groups.at("lid").size(), 4u);
  for (const int v : mesh.groups.at("lid")) EXPECT_EQ(mesh.vertices[v][2], 1);
}

TEST(MeshImport, MaterialsAreGroupsToo) {
  write_file("paints.mtl", "newmtl red\nKd 1 0 0\n");
  const std::string text =
      "mtllib paints.mtl\n" + kCubeVertices + "usemtl red\nf 5 6 7 8\nusemtl blue\n" + kCubeSides + "f 1 4 3 2\n";
  const SurfaceMesh mesh = import(write_file("paints.obj", text)).mesh;
  ASSERT_TRUE(mesh.groups.contains("red"));
  EXPECT_EQ(mesh.groups.at("red").size(), 4u);
}

TEST(MeshImport, GroupThatTheFileCallsWallIsTheFilesOwn) {
  const std::string text = kCubeVertices + "g wall\nf 5 6 7 8\ng rest\n" + kCubeSides + "f 1 4 3 2\n";
  EXPECT_EQ(import(write_file("wall.obj", text)).mesh.groups.at("wall").size(), 4u);
}

TEST(MeshImport, FormatsWithoutSharedVerticesAreWelded) {
  std::string text = "solid cube\n";
  const Eigen::Vector3d corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Eigen::Vector3i& t : {Eigen::Vector3i(0, 2, 1), {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : t) {
      const Eigen::Vector3d& p = corners[v];
      text += "vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  const SurfaceMesh mesh = import(write_file("soup.stl", text + "endsolid cube\n")).mesh;
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_NO_THROW(check_closed_for_fluid(mesh, {}));
}

TEST(MeshImport, ASlitWhoseLipsTouchIsToldToBeJoined) {
  // Six squares in two rows of three, between which the first two edges are a slit with lips of their own.
  const std::string vertices =
      "0 0 0\n1 0 0\n2 0 0\n3 0 0\n0 1 0\n1 1 0\n2 1 0\n3 1 0\n0 2 0\n1 2 0\n2 2 0\n3 2 0\n0 1 0\n1 1 0\n";
  const auto joined = [](const std::filesystem::path& file) -> std::string {
    const ImportedMesh sheet = import(file);
    EXPECT_EQ(sheet.mesh.vertices.size(), 12u);
    for (const std::string& note : sheet.notes) {
      if (const std::size_t k = note.find("joined"); k != std::string::npos) return note.substr(k - 8);
    }
    return {};
  };
  const std::string what =
      "2 edges joined whose two faces have corners of their own at the same places; a slit stays one where its lips "
      "are farther apart than 3.61e-06 units of the file";
  std::string obj = "\n" + vertices;
  for (std::size_t k = 0; (k = obj.find('\n', k)) + 1 < obj.size(); k += 3) obj.replace(k, 1, "\nv ");
  const std::string lower = "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n", upper = "f 13 14 10 9\nf 14 7 11 10\nf 7 8 12 11\n";
  EXPECT_EQ(joined(write_file("slit.obj", obj + lower + upper)), what);
  EXPECT_EQ(joined(write_file("whole.obj", obj + lower + "f 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\n")), "");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 14\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 6\nproperty list uchar int vertex_indices\nend_header\n" +
      vertices;
  EXPECT_EQ(
      joined(write_file("slit.ply", ply + "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 12 13 9 8\n4 13 6 10 9\n4 6 7 11 10\n")),
      what);
}

TEST(MeshImport, DebrisIsRemovedAndToldWithAllElseThatWasDone) {
  const std::string text = kCubeVertices + "v 3 3 3\nv 3.1 3 3\nv 3 3.1 3\nv 9 9 9\n" + kCubeSides +
                           "f 4 1 5 8\nf 1 2 3 4\nf 5 6 7 8\nf 9 10 11\n";
  const std::filesystem::path file = write_file("debris.obj", text);
  const ImportedMesh cube = import(file, 0.01);
  const std::string name = "mesh `" + file.generic_string() + "`: ";
  const std::vector<std::string> expected = {
      name + "2 triangles with the corners of another removed",
      name + "1 separate part with 1 triangle removed, 0.083 % of the area",
      name + "2 triangles turned to agree with the others",
      name + "12 triangles, 8 vertices, closed, 10 x 10 x 10 mm, smallest angle 45 deg, groups `wall`",
  };
  EXPECT_EQ(cube.notes, expected);
  EXPECT_NEAR(enclosed_volume(cube.mesh), 1e-6, 1e-20);
}

/// A tetrahedron whose elements stand in the order given, among them two that only their author knows.
std::string ply_in_order(const std::vector<std::string>& order) {
  using Element = std::pair<std::string, std::string>;
  const std::map<std::string, Element> elements = {
      {"vertex", {" 4\nproperty float x\nproperty float y\nproperty float z\n", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"}},
      {"face", {" 4\nproperty list uchar int vertex_indices\n", "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"}},
      {"camera", {" 2\nproperty float view\nproperty list uchar int shape\n", "1.5 2 1 2\n2.5 0\n"}},
      {"seam", {" 1\nproperty list uchar int vertices\n", "2 1 2\n"}}};
  std::string header = "ply\nformat ascii 1.0\n";
  std::string body;
  for (const std::string& name : order) {
    header += "element " + name + elements.at(name).first;
    body += elements.at(name).second;
  }
  return header + "end_header\n" + body;
}

TEST(MeshImport, ElementsOfAPlyFileMayHaveAnyNameAndOrder) {
  using Order = std::vector<std::string>;
  for (const Order& order :
       {Order{"vertex", "face"}, Order{"camera", "vertex", "face"}, Order{"vertex", "camera", "face"},
        Order{"vertex", "face", "camera"}, Order{"face", "vertex"}, Order{"seam", "face", "camera", "vertex"}}) {
    const ImportedMesh imported = import(write_file("ordered.PLY", ply_in_order(order)));
    ASSERT_EQ(imported.mesh.triangles.size(), 4u) << order.front();
    // The corners are exact in single precision.
    EXPECT_DOUBLE_EQ(enclosed_volume(imported.mesh), 1.0 / 6) << order.front();
    EXPECT_EQ(imported.notes.size(), 1u) << "nothing had to be mended";
  }
}

TEST(MeshImport, PlacementOfObjectsIsApplied) {
  // A triangle moved by (5, 0, 0): three positions as little-endian floats in a data URI.
  const std::string text = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "translation": [5, 0, 0], "name": "moved"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}]})";
  const SurfaceMesh mesh = import(write_file("moved.gltf", text)).mesh;
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[1], Eigen::Vector3d(6, 0, 0));
  EXPECT_TRUE(mesh.groups.contains("moved"));
}

TEST(MeshImport, IsTheSameEveryTime) {
  const std::filesystem::path file = write_file("cube.obj", kCubeVertices + kCubeSides + kCubeEnds);
  const ImportedMesh first = import(file);
  const ImportedMesh second = import(file);
  EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
  EXPECT_EQ(first.notes, second.notes);
}

std::string refusal_of(const std::filesystem::path& file, const ImportOptions& options) {
  try {
    import_mesh(file, mesh_origin(file, 0.01, "bodies.organ.surface", kHere), options);
  } catch (const InputErrors& errors) {
    const std::string text = errors.what();
    return text.substr(text.find("`: ") + 3);
  }
  return "accepted";
}

TEST(MeshImport, RemeshingIsToldAndKeepsVolumeAndGroups) {
  const std::filesystem::path file =
      write_file("fine.obj", kCubeVertices + "g sides\n" + kCubeSides + "g lid\nf 5 6 7 8\ng bottom\nf 1 4 3 2\n");
  const ImportedMesh cube =
      import_mesh(file, mesh_origin(file, 0.01, "bodies.organ.surface", kHere), {.edge_length = 1e-3});
  EXPECT_NO_THROW(check_closed_for_fluid(cube.mesh, {}));
  EXPECT_NEAR(enclosed_volume(cube.mesh), 1e-6, 1e-18);
  EXPECT_NEAR(static_cast<double>(cube.mesh.triangles.size()), 6 * 100 / (std::numbers::sqrt3 / 4), 300);
  for (const int v : cube.mesh.groups.at("lid")) EXPECT_NEAR(cube.mesh.vertices[v][2], 0.01, 1e-12);
  for (const int v : cube.mesh.groups.at("bottom")) EXPECT_NEAR(cube.mesh.vertices[v][2], 0, 1e-12);
  EXPECT_GT(cube.mesh.groups.at("lid").size(), 80u);
  const std::string& note = cube.notes.at(0);
  EXPECT_NE(note.find("remeshed to edges of 1 mm: 12 to "), std::string::npos) << note;
  EXPECT_NE(note.find("smallest angle 45 to 3"), std::string::npos) << note;
  EXPECT_NE(note.find("from the given surface, volume "), std::string::npos) << note;
}

TEST(MeshImport, RemeshingThatCannotBeIsRefusedWithTheCure) {
  const std::string octahedron =
      "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\n"
      "f 4 2 6\nf 1 4 6\n";
  const std::filesystem::path file = write_file("octahedron.obj", octahedron);
  EXPECT_EQ(refusal_of(file, {.edge_length = 2e-5}),
            "`remesh` with edges of 0.02 mm would make about 4e+06 triangles, but 200000 are the most; ask for longer "
            "edges");
  const std::filesystem::path flap = std::filesystem::path(THINWALL_SOURCE_DIR) / "tests/studio/organs/broken/flap.obj";
  EXPECT_EQ(refusal_of(flap, {.edge_length = 0.01}),
            "`remesh` needs a surface whose parts nowhere touch or branch; `repair: true` may mend that");
  EXPECT_EQ(refusal_of(flap, {.repair = true, .edge_length = 0.01}), "accepted");
  const std::filesystem::path organ =
      std::filesystem::path(THINWALL_SOURCE_DIR) / "scenes/organs/gallbladder_light.obj";
  const std::string coarse = refusal_of(organ, {.edge_length = 0.3});
  EXPECT_NE(coarse.find("`remesh` with edges of 300 mm is too coarse: the volume would change by -"), std::string::npos)
      << coarse;
  EXPECT_NE(coarse.find(" %; ask for shorter edges"), std::string::npos) << coarse;
}

struct GivenMesh {
  const char* file;
  double unit;
  std::size_t triangles;
  double volume_ml;
};

/// Meshes that are lent for trials and do not belong to the project.
TEST(MeshImport, GivenOrgansAreClosedAsTheyAre) {
  const std::filesystem::path folder = std::filesystem::path(THINWALL_SOURCE_DIR) / "../shared/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the lent meshes are not here";
  for (const GivenMesh& given :
       {GivenMesh{"liver-smooth.obj", 0.03, 4384, 1060}, {"aneurysm3D_1.off", 1e-3, 14186, 1.379}}) {
    const SurfaceMesh mesh = import(folder / given.file, given.unit).mesh;
    EXPECT_EQ(mesh.triangles.size(), given.triangles);
    EXPECT_NO_THROW(check_closed_for_fluid(mesh, {}));
    EXPECT_NEAR(enclosed_volume(mesh) * 1e6, given.volume_ml, 0.001 * given.volume_ml);
  }
}

TEST(MeshImport, GivenOrgansLoseTheirSlivers) {
  const std::filesystem::path folder = std::filesystem::path(THINWALL_SOURCE_DIR) / "../shared/meshes";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the lent meshes are not here";
  // 32 and 5.6 degrees were seen, where the files have 0.6 and 2.6; the lower ones lie at ends of creases, which stay.
  for (const auto& [name, unit, length, least] :
       {std::tuple{"liver-smooth.obj", 0.03, 6e-3, 28.0}, {"aneurysm3D_1.off", 1e-3, 5e-4, 5.0}}) {
    const std::filesystem::path file = folder / name;
    const SurfaceMesh mesh = import_mesh(file, mesh_origin(file, unit, "surface", kHere), {.edge_length = length}).mesh;
    EXPECT_NO_THROW(check_closed_for_fluid(mesh, {}));
    EXPECT_GT(quality_of(mesh).least_angle * 180 / std::numbers::pi, least) << name;
  }
}

TEST(ClosedCheck, TrianglesThatFaceOppositeWaysAreTold) {
  SurfaceMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}, {0, 0, 0.001}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {2, 1, 3}, {2, 0, 3}};
  try {
    check_closed_for_fluid(mesh, {"shape `tip`", 1e-3, "mm", "bodies.organ.surface", kHere});
    FAIL() << "was accepted";
  } catch (const InputErrors& errors) {
    EXPECT_STREQ(
        errors.what(),
        "scene.yaml:4:14: error: bodies.organ.surface: shape `tip`: the fluid needs a surface with one inside, but "
        "this has 3 edges between triangles that face opposite ways: (1, 0, 0) to (0, 1, 0), (1, 0, 0) to (0, 0, "
        "1), (0, 1, 0) to (0, 0, 1), in mm; turn one side of them over");
  }
}

}  // namespace
}  // namespace thinwall

#include "studio/organs/TableOrder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "studio/organs/BodyBuilder.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

using Rows = std::vector<std::array<int, 3>>;

/// Two squares side by side that share no vertices; the last face is turned, and no face has the first vertex.
const std::string kSquares =
    "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\n"
    "property float thickness\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n"
    "5 5 5 100\n"
    "0.1 0 0 1\n1.1 0 0 1\n1.1 1 0 1\n0.1 1 0 4\n"
    "1.1 0 0 7\n1.1 1 0 7\n2.1 0 0 7\n2.1 1 0 10\n"
    "4 1 2 3 4\n3 5 7 8\n3 8 5 6\n";

class TableOrderOfFile : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) {
    source_.file = folder_ / name;
    write_bytes(source_.file, bytes);
    std::vector<std::string> notes;
    wall_ = make_surface(source_, {}, notes);
  }

  TableOrder order() const { return table_order(source_, wall_, "bodies.organ.wall.thickness", {"scene.yaml", 7, 9}); }

  std::string refusal() const {
    try {
      order();
    } catch (const InputErrors& errors) {
      return errors.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
  MeshFileSource source_{.unit = 0.01};
  SurfaceMesh wall_;
};

TEST_F(TableOrderOfFile, WeldedVerticesKeepTheRowsOfEachFace) {
  write("squares.ply", kSquares);
  ASSERT_EQ(wall_.vertices.size(), 6u);
  const TableOrder order = this->order();
  EXPECT_EQ(order.vertices, 9u);
  EXPECT_EQ(order.faces, 3u);
  EXPECT_EQ(order.face_rows, (std::vector<int>{0, 0, 1, 2}));
  Rows rows = order.corner_rows;
  for (std::array<int, 3>& row : rows) std::ranges::sort(row);
  EXPECT_EQ(rows, (Rows{{1, 2, 3}, {1, 3, 4}, {5, 7, 8}, {5, 6, 8}}));
  EXPECT_TRUE(order.doubled_faces.empty());
  EXPECT_TRUE(order.doubled_vertices.empty());
  ASSERT_TRUE(order.ply.has_value());
  EXPECT_EQ(order.ply->vertex_properties.at(0).values.at(8), 10);
}

TEST_F(TableOrderOfFile, EachCornerHasTheRowOfItsOwnPlace) {
  write("squares.ply", kSquares);
  const TableOrder order = this->order();
  for (std::size_t t = 0; t < wall_.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      // The coordinates of the wall went through single precision.
      const Eigen::Vector3d place = 0.01 * order.ply->vertices[order.corner_rows[t][k]];
      EXPECT_LT((wall_.vertices[wall_.triangles[t][k]] - place).norm(), 1e-8);
    }
  }
}

TEST_F(TableOrderOfFile, AFileThatIsTurnedAndBroughtElsewhereKeepsItsRows) {
  write("squares.ply", kSquares);
  const Rows rows = order().corner_rows;
  const SurfacePlacement placement{.at = {0.3, -0.2, 0.1},
                                   .turned = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 2) / 3)};
  source_.placed = placement;
  for (Eigen::Vector3d& vertex : wall_.vertices) vertex = placement.place_of(vertex);
  EXPECT_EQ(order().corner_rows, rows);
}

TEST_F(TableOrderOfFile, AnObjFileCountsItsVerticesByItsLines) {
  write("two.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 2//1 3//1 4//1\nf 2//1 4//1 5//1\n");
  const TableOrder order = this->order();
  EXPECT_EQ(order.vertices, 5u);
  EXPECT_EQ(order.face_rows, (std::vector<int>{0, 1}));
  EXPECT_EQ(order.corner_rows, (Rows{{1, 2, 3}, {1, 3, 4}}));
  EXPECT_FALSE(order.ply.has_value());
}

TEST_F(TableOrderOfFile, FacesThatLieOnEachOtherAreTold) {
  write("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0\nf 1 2 3\nf 2 4 1\n");
  ASSERT_EQ(wall_.triangles.size(), 1u);
  const TableOrder order = this->order();
  EXPECT_EQ(order.face_rows, std::vector<int>{0});
  EXPECT_EQ(order.doubled_faces, (std::vector<std::array<int, 2>>{{0, 1}}));
  EXPECT_EQ(order.doubled_vertices, (std::vector<std::array<int, 2>>{{2, 3}}));
}

TEST_F(TableOrderOfFile, ATriangleThatTheFileLacksIsRefusedWithItsPlace) {
  write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  wall_.triangles[0] = {0, 1, 3};
  EXPECT_EQ(refusal(),
            "scene.yaml:7:9: error: bodies.organ.wall.thickness: the triangle of the wall at [6.667, 3.333, 0] mm is "
            "none of the mesh file's faces: the import changed it; mend the mesh in a modelling program, save it and "
            "leave `repair` out, or use regions");
}

TEST_F(TableOrderOfFile, AFilledHoleIsRefused) {
  source_.repair = true;
  // A box of which one of the twelve triangles is missing.
  write("box.obj",
        "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 1\nv 10 0 1\nv 10 10 1\nv 0 10 1\n"
        "v 5 5 1\nv 5.5 5 1\nv 5 5.5 1\n"
        "f 1 4 3\nf 1 3 2\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n"
        "f 5 6 10\nf 5 10 9\nf 6 7 10\nf 7 11 10\nf 7 8 11\nf 8 9 11\nf 8 5 9\n");
  EXPECT_NE(refusal().find("at [51.67, 51.67, 10] mm is none of the mesh file's faces"), std::string::npos)
      << refusal();
}

TEST_F(TableOrderOfFile, RemeshedSurfacesAndOtherFormatsAreRefusedWithTheCure) {
  source_ = {.file = "wall.ply", .edge_length = 1e-3};
  EXPECT_EQ(
      refusal(),
      "scene.yaml:7:9: error: bodies.organ.wall.thickness: `remesh` makes other triangles than the mesh file has; "
      "save a mesh that is fine enough and leave `remesh` out, or use regions");
  source_ = {.file = "wall.stl"};
  EXPECT_EQ(refusal(),
            "scene.yaml:7:9: error: bodies.organ.wall.thickness: a `.stl` file does not number its vertices and faces; "
            "save the mesh as PLY or OBJ, or use regions");
}

TEST_F(TableOrderOfFile, AFileThatCannotBeReadIsToldAtItsOwnPlace) {
  source_.file = folder_ / "wall.obj";
  write_bytes(source_.file, "v 0 0 0\nv 1 0 up\n");
  EXPECT_EQ(refusal(),
            source_.file.string() + ":2:7: error: bodies.organ.wall.thickness: expected a finite number, got `up`");
}

TEST(TableOrder, AShapeCountsItsOwnTriangles) {
  std::vector<std::string> notes;
  const ShapeSource shape{.shape = Shape::kSheet, .triangles = 32};
  const SurfaceMesh wall = make_surface(shape, {}, notes);
  const TableOrder order = table_order(shape, wall, "", {});
  EXPECT_EQ(order.vertices, wall.vertices.size());
  for (std::size_t t = 0; t < wall.triangles.size(); ++t) {
    EXPECT_EQ(order.face_rows[t], static_cast<int>(t));
    for (int k = 0; k < 3; ++k) EXPECT_EQ(order.corner_rows[t][k], wall.triangles[t][k]);
  }
}

}  // namespace
}  // namespace thinwall

#include "studio/organs/TableFields.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "studio/organs/BodyBuilder.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

/// A square of two triangles with properties of its vertices and faces; `same` is of both.
std::string square(const std::string& third_vertex = "10 10 0 3 0 -1 0 7") {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "property float thickness\nproperty float fx\nproperty float fy\nproperty float fz\nproperty float same\n"
         "element face 2\nproperty list uchar int vertex_indices\nproperty float stiffness\nproperty float same\n"
         "end_header\n"
         "0 0 0 1 0 1 0 7\n10 0 0 2 0 1 0 7\n" +
         third_vertex +
         "\n0 10 0 6 0 1 0 7\n"
         "3 0 1 2 20 7\n3 0 2 3 30 7\n";
}

const Range kAboveZero{.minimum = 0, .minimum_excluded = true};

class FieldOfTable : public testing::Test {
 protected:
  FieldOfTable() {
    body_.name = "organ";
    body_.fluid.kind = FluidKind::kNone;
    body_.thickness.standard = 1e-3;
    write_mesh(square());
  }

  void write_mesh(const std::string& text) {
    const std::filesystem::path file = folder_ / "square.ply";
    write_bytes(file, text);
    body_.surface = MeshFileSource{.file = file, .unit = 1e-3};
  }

  std::filesystem::path write_table(const std::string& text) {
    write_bytes(folder_ / "wall.csv", text);
    return folder_ / "wall.csv";
  }

  static Field<double> thickness(const FieldTable& table) { return {.location = {"scene.yaml", 7, 9}, .table = table}; }

  FieldTable column(const std::string& text, TablePer per) {
    return {.file = write_table(text),
            .columns = {"thickness"},
            .per = per,
            .unit = 1e-3,
            .range = kAboveZero,
            .example = "0.8 mm"};
  }

  FieldTable property(const std::string& name) {
    return {.columns = {name}, .unit = 1e-3, .range = kAboveZero, .example = "0.8 mm"};
  }

  BodyDefinition built() {
    std::vector<std::string> notes;
    return build_body(body_, notes);
  }

  /// Without the folder.
  std::string refusal() {
    try {
      built();
    } catch (const InputErrors& errors) {
      std::string text = errors.what();
      const std::string folder = folder_.path().string() + "/";
      for (std::size_t at = 0; (at = text.find(folder, at)) != std::string::npos;) text.erase(at, folder.size());
      return text;
    }
    return "accepted";
  }

  std::string refusal(const FieldTable& table) {
    body_.thickness = thickness(table);
    return refusal();
  }

  TemporaryFolder folder_;
  BodyScenario body_;
};

TEST_F(FieldOfTable, ARowForEachFaceIsTheTrianglesOwn) {
  body_.thickness = thickness(column("name,thickness\na,0.1\nb,0.7\n", TablePer::kFace));
  EXPECT_EQ(built().thickness, (std::vector<double>{1e-3 * 0.1, 1e-3 * 0.7}));
}

TEST_F(FieldOfTable, ARegionWinsOverTheTable) {
  body_.thickness = thickness(column("thickness\n0.1\n0.7\n", TablePer::kFace));
  // The middle of the first triangle lies at x = 20/3 mm, that of the second at 10/3 mm.
  body_.thickness.regions = {{.region = AboveRegion{.axis = 0, .at = 5e-3}, .value = 2e-3}};
  EXPECT_EQ(built().thickness, (std::vector<double>{2e-3, 1e-3 * 0.7}));
  body_.thickness.table->columns = {"none"};
  EXPECT_TRUE(refusal().starts_with("wall.csv:1:1: error: bodies.organ.wall.thickness: there is no column `none`"));
}

TEST_F(FieldOfTable, ARowForEachVertexIsAveragedOverTheCorners) {
  body_.thickness = thickness(column("thickness\n1\n2\n3\n8\n", TablePer::kVertex));
  const std::vector<double> values = built().thickness;
  // The last bit is the rounding of the mean.
  EXPECT_NEAR(values.at(0), 2e-3, 1e-18);
  EXPECT_NEAR(values.at(1), 4e-3, 1e-18);
}

TEST_F(FieldOfTable, AShapeTakesATableInItsOwnOrder) {
  body_.surface = ShapeSource{.shape = Shape::kSheet, .triangles = 2};
  std::vector<std::string> notes;
  const std::size_t triangles = make_surface(body_.surface, {}, notes).triangles.size();
  std::string rows = "thickness\n";
  for (std::size_t t = 0; t < triangles; ++t) rows += std::to_string(t + 1) + "\n";
  body_.thickness = thickness(column(rows, TablePer::kFace));
  const std::vector<double> values = built().thickness;
  for (std::size_t t = 0; t < triangles; ++t) EXPECT_EQ(values.at(t), 1e-3 * static_cast<double>(t + 1));
}

TEST_F(FieldOfTable, PropertiesOfVerticesAndFacesAreReadFromTheMesh) {
  body_.thickness = thickness(property("thickness"));
  EXPECT_NEAR(built().thickness.at(0), 2e-3, 1e-18);
  EXPECT_NEAR(built().thickness.at(1), 10e-3 / 3, 1e-18);
  body_.material = {.law = find_wall_law("neo_hookean"), .parameters = {0}};
  FieldTable stiffness = property("stiffness");
  stiffness.unit = 1e3;
  body_.parameter_fields = {{.index = 0, .path = "shear_modulus", .values = {.table = stiffness}}};
  const BodyDefinition body = built();
  ASSERT_EQ(body.materials.size(), 2u);
  EXPECT_EQ(body.materials[0].parameters, std::vector<double>{20e3});
  EXPECT_EQ(body.materials[1].parameters, std::vector<double>{30e3});
}

TEST_F(FieldOfTable, WhatIsReadIsTold) {
  body_.thickness = thickness(column("thickness\n1\n2\n3\n8\n", TablePer::kVertex));
  std::vector<std::string> notes;
  build_body(body_, notes);
  EXPECT_EQ(notes.back(), "bodies.organ.wall.thickness: `thickness` of 4 vertices: 1 mm to 8 mm");
}

TEST_F(FieldOfTable, FibresHaveNoSenseWhenCornersAreAveraged) {
  // The third vertex points backwards and aslant.
  write_mesh(square("10 10 0 3 -1 -1 0 7"));
  body_.fibres = Field<Eigen::Vector3d>{.table = FieldTable{.columns = {"fx", "fy", "fz"}}};
  const Eigen::Vector3d mean = (2 * Eigen::Vector3d::UnitY() + Eigen::Vector3d(1, 1, 0).normalized()).normalized();
  for (const Eigen::Vector3d& along : built().fibres) {
    // Which sense comes out is of no meaning; the rest is rounding.
    EXPECT_NEAR(std::abs(along.dot(mean)), 1, 1e-15);
  }
}

TEST_F(FieldOfTable, FibresThatAreZeroOrStandOnTheWallAreRefusedWithThePlace) {
  body_.fibres =
      Field<Eigen::Vector3d>{.location = {"scene.yaml", 8, 9}, .table = FieldTable{.columns = {"fx", "fy", "fz"}}};
  write_mesh(square("10 10 0 3 0 0 0 7"));
  EXPECT_EQ(refusal(),
            "scene.yaml:8:9: error: bodies.organ.wall.fibres: the fibres are zero at [6.667, 3.333, 0] mm; give the "
            "wall there a direction of its own");
  body_.fibres->table->file = write_table("a,b,c\n0,0,1\n1,0,0\n");
  body_.fibres->table->columns = {"a", "b", "c"};
  body_.fibres->table->per = TablePer::kFace;
  EXPECT_EQ(refusal(),
            "scene.yaml:8:9: error: bodies.organ.wall.fibres: the fibres stand perpendicular to the wall at [6.667, "
            "3.333, 0] mm; give the wall there a direction of its own");
}

TEST_F(FieldOfTable, PrestretchHasOneColumnOrFive) {
  FieldTable table{.file = write_table("x,y,z,s,t\n0,-2,0,1.2,1.1\n3,0,0,1.3,1\n"),
                   .columns = {"s"},
                   .per = TablePer::kFace,
                   .range = kAboveZero,
                   .example = "1.1"};
  body_.prestretch.table = table;
  EXPECT_EQ(built().prestretch.at(1).first, 1.3);
  EXPECT_EQ(built().prestretch.at(1).second, 1.3);
  table.columns = {"x", "y", "z", "s", "t"};
  body_.prestretch.table = table;
  const std::vector<Prestretch> prestretch = built().prestretch;
  EXPECT_EQ(prestretch.at(0).along, Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(prestretch.at(0).second, 1.1);
  EXPECT_EQ(prestretch.at(1).along, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(prestretch.at(1).first, 1.3);
}

TEST_F(FieldOfTable, NumbersOutOfRangeAreToldWithTheirCells) {
  EXPECT_EQ(refusal(column("name,thickness\na,0.1\nb, -0.7\n", TablePer::kFace)),
            "wall.csv:3:4: error: bodies.organ.wall.thickness: face 2: -0.7 mm is out of range, it must be greater "
            "than 0 mm");
  write_mesh(square("10 10 0 0 0 -1 0 7"));
  EXPECT_EQ(refusal(property("thickness")),
            "square.ply:19:1: error: bodies.organ.wall.thickness: vertex 3: 0 mm is out of range, it must be greater "
            "than 0 mm");
}

TEST_F(FieldOfTable, OnlyTheFirstOfManyWrongNumbersAreTold) {
  const std::string text = refusal(column("thickness\n-1\n-1\n-1\n-1\n", TablePer::kVertex));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_TRUE(text.ends_with("; and 1 more numbers are wrong")) << text;
}

TEST_F(FieldOfTable, WhatIsNoFiniteNumberIsRefused) {
  write_mesh(square("10 10 0 nan 0 -1 0 7"));
  EXPECT_EQ(refusal(property("thickness")),
            "square.ply:19:1: error: bodies.organ.wall.thickness: vertex 3: nan is no finite number");
  EXPECT_TRUE(refusal(column("thickness\n1\n1.5 mm\n", TablePer::kFace))
                  .starts_with("wall.csv:3:1: error: bodies.organ.wall.thickness: expected a finite number"));
}

TEST_F(FieldOfTable, AnotherCountOfRowsIsRefusedWithWhatIsMeant) {
  EXPECT_EQ(refusal(column("thickness\n1\n2\n3\n", TablePer::kVertex)),
            "wall.csv:4:1: error: bodies.organ.wall.thickness: the table has 3 rows, but the surface has 4 vertices; "
            "write one row for each, in the order of the surface");
  EXPECT_EQ(refusal(column("thickness\n1\n2\n", TablePer::kVertex)),
            "wall.csv:3:1: error: bodies.organ.wall.thickness: the table has 2 rows, but the surface has 4 vertices; "
            "write `per: face`");
}

TEST_F(FieldOfTable, PropertiesThatTheMeshLacksOrHasTwiceAreRefused) {
  EXPECT_EQ(refusal(property("thicknes")),
            "scene.yaml:7:9: error: bodies.organ.wall.thickness: the mesh file does not have `thicknes` with one "
            "number; its vertices have `thickness`, `fx`, `fy`, `fz`, `same`, its faces `stiffness`, `same`");
  EXPECT_EQ(refusal(property("same")),
            "scene.yaml:7:9: error: bodies.organ.wall.thickness: both the vertices and the faces of the mesh file "
            "have `same`; write `per: vertex` or `per: face`");
  FieldTable table = property("same");
  table.per = TablePer::kFace;
  EXPECT_EQ(refusal(table), "accepted");
}

TEST_F(FieldOfTable, FacesThatLieOnEachOtherMustHaveTheSameNumber) {
  const auto mesh = [](const std::string& second) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nproperty float h\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1\n3 0 1 2 " +
           second + "\n";
  };
  write_mesh(mesh("1.0000001"));
  EXPECT_EQ(refusal(property("h")), "accepted");
  write_mesh(mesh("2"));
  EXPECT_EQ(refusal(property("h")),
            "square.ply:15:1: error: bodies.organ.wall.thickness: faces of the mesh file lie on each other, but face 1 "
            "has 1 mm and face 2 has 2 mm; give both the same or remove one of the faces");
}

}  // namespace
}  // namespace thinwall

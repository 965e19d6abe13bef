#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "engine/mesh/MeshMeasures.hpp"
#include "engine/mesh/Region.hpp"
#include "studio/organs/ClosedCheck.hpp"
#include "studio/organs/MeshImport.hpp"
#include "studio/organs/generator/OrganPlan.hpp"

namespace thinwall {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

const std::filesystem::path kFolder = std::filesystem::path(THINWALL_SOURCE_DIR) / "scenes/organs";

class OrganFiles : public testing::TestWithParam<OrganFile> {
 protected:
  std::filesystem::path path() const { return kFolder / GetParam().name; }
  SurfaceOrigin origin() const { return mesh_origin(path(), 1e-3, "surface", {}); }
};

TEST_P(OrganFiles, AreWhatTheGeneratorGives) {
  std::ifstream stream(path(), std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  // Not EXPECT_EQ, which would print both files.
  EXPECT_TRUE(text.str() == organ_text(GetParam())) << path() << " is stale: run scripts/organs";
  EXPECT_LT(text.str().size(), 500'000u);
}

TEST_P(OrganFiles, ImportAsClosedSurfacesOfTheWantedCountWithNothingToMend) {
  const ImportedMesh organ = import_mesh(path(), origin());
  EXPECT_EQ(organ.notes.size(), 1u) << organ.notes.front();
  EXPECT_NO_THROW(check_closed_for_fluid(organ.mesh, origin()));
  EXPECT_NEAR(static_cast<double>(organ.mesh.triangles.size()), GetParam().triangles, 0.01 * GetParam().triangles);
}

TEST_P(OrganFiles, AreWellMeshed) {
  const MeshQuality quality = quality_of(import_mesh(path(), origin()).mesh);
  EXPECT_GE(quality.least_angle, 30 * kDegree);
  EXPECT_GE(quality.median_angle, 45 * kDegree);
}

INSTANTIATE_TEST_SUITE_P(Table, OrganFiles, testing::ValuesIn(organ_files()),
                         [](const testing::TestParamInfo<OrganFile>& file) {
                           return file.param.name.substr(0, file.param.name.find('.'));
                         });

TEST(OrganFolder, HoldsNothingThatTheGeneratorDoesNotWrite) {
  std::set<std::string> known;
  for (const OrganFile& file : organ_files()) known.insert(file.name);
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    EXPECT_TRUE(known.contains(entry.path().filename().string())) << entry.path();
  }
}

SurfaceMesh organ(const std::string& name) {
  const std::filesystem::path file = kFolder / name;
  return import_mesh(file, mesh_origin(file, 1e-3, "surface", {})).mesh;
}

/// Of the box around an organ, millimetres.
Eigen::Vector3d size_of(const SurfaceMesh& mesh) {
  Eigen::Vector3d low = mesh.vertices.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return 1e3 * (high - low);
}

/// Middle of a group's vertices, millimetres.
Eigen::Vector3d middle_of(const SurfaceMesh& mesh, const std::string& group) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int v : mesh.groups.at(group)) sum += mesh.vertices[v];
  return 1e3 * sum / static_cast<double>(mesh.groups.at(group).size());
}

TEST(Gallbladder, HasTheMeasuresOfAFilledHumanOne) {
  const SurfaceMesh mesh = organ("gallbladder.obj");
  const Eigen::Vector3d size = size_of(mesh);
  EXPECT_NEAR(size[0], 115, 5);  // 80 to the neck, and 30 to 40 of the duct
  EXPECT_NEAR(size[1], 35, 2);
  EXPECT_NEAR(size[2], 31, 2);
  EXPECT_NEAR(1e6 * enclosed_volume(mesh), 45, 10);  // millilitres: 30 to 50, a little more when filled well
}

TEST(Gallbladder, PartsLieWhereTheyBelong) {
  const SurfaceMesh mesh = organ("gallbladder.obj");
  const auto middle = [&](const std::string& group) { return middle_of(mesh, group); };
  EXPECT_GT(middle("fundus")[0], middle("body")[0]);
  EXPECT_GT(middle("body")[0], middle("neck")[0]);
  EXPECT_GT(middle("neck")[0], middle("duct")[0]);
  EXPECT_GT(middle("duct")[0], middle("duct_end")[0]);
  EXPECT_LT(middle("liver_bed")[2], -10);
  EXPECT_GT(triangles_in(GroupRegion{"liver_bed"}, mesh).size(), 100u);
  EXPECT_GT(triangles_in(GroupRegion{"duct_end"}, mesh).size(), 20u);
  // Straight above the origin lies the body: that is where it is palpated.
  const double top = 1e3 * mesh.vertices[vertices_in(SphereRegion{{0, 0, 0.018}, 0.002}, mesh).at(0)][2];
  EXPECT_NEAR(top, 18, 1);
}

TEST(Stomach, HasTheMeasuresOfAModeratelyFilledHumanOne) {
  const SurfaceMesh mesh = organ("stomach.obj");
  const Eigen::Vector3d size = size_of(mesh);
  EXPECT_NEAR(size[0], 185, 15);
  EXPECT_NEAR(size[1], 180, 15);  // about 150 from the fundus to the lowest point, and the gullet beside it
  EXPECT_LT(size[2], 0.6 * size[0]);
  // Millilitres: 50 to 100 when empty, 1000 to 1500 after a large meal.
  EXPECT_GT(1e6 * enclosed_volume(mesh), 400);
  EXPECT_LT(1e6 * enclosed_volume(mesh), 800);
}

TEST(Stomach, PartsLieWhereTheyBelong) {
  const SurfaceMesh mesh = organ("stomach.obj");
  const auto middle = [&](const std::string& group) { return middle_of(mesh, group); };
  // From above: fundus, body, antrum; from the left: body, antrum, pylorus, duodenum.
  EXPECT_GT(middle("fundus")[1], middle("body")[1]);
  EXPECT_GT(middle("body")[1], middle("antrum")[1]);
  EXPECT_GT(middle("body")[0], middle("antrum")[0]);
  EXPECT_GT(middle("antrum")[0], middle("pylorus")[0]);
  EXPECT_GT(middle("pylorus")[0], middle("duodenum")[0]);
  EXPECT_GT(middle("oesophagus_end")[1], middle("oesophagus")[1]);
  EXPECT_GT(middle("oesophagus")[1], middle("cardia")[1]);
  EXPECT_LT(middle("cardia")[0], middle("fundus")[0]);
  EXPECT_LT(middle("lesser_curvature")[0], middle("greater_curvature")[0]);
  EXPECT_GT(middle("lesser_curvature")[1], middle("greater_curvature")[1]);
  // The fundus rises above the notch at the gullet's mouth.
  EXPECT_GT(middle("fundus")[1], middle("cardia")[1]);
  for (const char* end : {"oesophagus_end", "duodenum_end"}) {
    EXPECT_GT(triangles_in(GroupRegion{end}, mesh).size(), 20u) << end;
  }
}

TEST(LiverLobe, HasTheMeasuresOfAHumanRightLobe) {
  const SurfaceMesh mesh = organ("liver_lobe.obj");
  const Eigen::Vector3d size = size_of(mesh);
  EXPECT_NEAR(size[0], 125, 10);
  EXPECT_NEAR(size[1], 160, 15);
  EXPECT_NEAR(size[2], 75, 10);
  EXPECT_NEAR(1e6 * enclosed_volume(mesh), 650, 150);  // millilitres
}

TEST(LiverLobe, PartsLieWhereTheyBelong) {
  const SurfaceMesh mesh = organ("liver_lobe.obj");
  const auto middle = [&](const std::string& group) { return middle_of(mesh, group); };
  EXPECT_LT(middle("inferior_edge")[1], middle("dome")[1]);
  EXPECT_LT(middle("visceral_surface")[2], middle("dome")[2]);
  EXPECT_GT(middle("bare_area")[1], middle("visceral_surface")[1]);
  EXPECT_GT(middle("medial_face")[0], 40);
  for (const char* held : {"medial_face", "bare_area"}) {
    EXPECT_GT(triangles_in(GroupRegion{held}, mesh).size(), 100u) << held;
  }
}

/// Thickness between front and back along z at a place, millimetres.
double thickness_at(const SurfaceMesh& mesh, double x, double y) {
  double low = 1e3;
  double high = -1e3;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    if (std::abs(1e3 * v[0] - x) > 5 || std::abs(1e3 * v[1] - y) > 3) continue;
    low = std::min(low, 1e3 * v[2]);
    high = std::max(high, 1e3 * v[2]);
  }
  return high - low;
}

TEST(LiverLobe, IsThickBehindAndThinsToASharpEdge) {
  const SurfaceMesh mesh = organ("liver_lobe.obj");
  EXPECT_GT(thickness_at(mesh, -20, 40), 55);
  EXPECT_GT(thickness_at(mesh, -20, -40), 25);
  const double before_edge = thickness_at(mesh, -20, -76);
  EXPECT_LT(before_edge, 17);
  EXPECT_GT(before_edge, 2);
}

TEST(Fingerpad, HasTheMeasuresOfAnIndexFingersTip) {
  const SurfaceMesh mesh = organ("fingerpad.obj");
  const Eigen::Vector3d size = size_of(mesh);
  EXPECT_NEAR(size[0], 16.5, 1);
  EXPECT_NEAR(size[1], 28, 2);
  EXPECT_NEAR(size[2], 9, 0.7);
  EXPECT_NEAR(1e6 * enclosed_volume(mesh), 2.4, 0.4);  // millilitres
}

TEST(Fingerpad, RestsOnAFlatBaseThatHoldsIt) {
  const SurfaceMesh mesh = organ("fingerpad.obj");
  EXPECT_GT(triangles_in(GroupRegion{"base"}, mesh).size(), 500u);
  for (const int v : mesh.groups.at("base")) EXPECT_LT(1e3 * mesh.vertices[v][2], 1);
  EXPECT_GT(middle_of(mesh, "pad")[2], 6);
  EXPECT_GT(middle_of(mesh, "tip")[1], 10);
  EXPECT_LT(middle_of(mesh, "proximal_end")[1], -14);
}

}  // namespace
}  // namespace thinwall

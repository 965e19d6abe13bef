#include <gtest/gtest.h>

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
  EXPECT_GE(quality.least_angle, 20 * kDegree);
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

TEST(Gallbladder, HasTheMeasuresOfAFilledHumanOne) {
  const std::filesystem::path file = kFolder / "gallbladder.obj";
  const SurfaceMesh mesh = import_mesh(file, mesh_origin(file, 1e-3, "surface", {})).mesh;
  Eigen::Vector3d low = mesh.vertices.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Eigen::Vector3d size = 1e3 * (high - low);  // millimetres
  EXPECT_NEAR(size[0], 115, 5);                     // 80 to the neck, and 30 to 40 of the duct
  EXPECT_NEAR(size[1], 35, 2);
  EXPECT_NEAR(size[2], 31, 2);
  EXPECT_NEAR(1e6 * enclosed_volume(mesh), 45, 10);  // millilitres: 30 to 50, a little more when filled well
}

TEST(Gallbladder, PartsLieWhereTheyBelong) {
  const std::filesystem::path file = kFolder / "gallbladder.obj";
  const SurfaceMesh mesh = import_mesh(file, mesh_origin(file, 1e-3, "surface", {})).mesh;
  const auto middle = [&](const std::string& group) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : mesh.groups.at(group)) sum += mesh.vertices[v];
    return Eigen::Vector3d(1e3 * sum / static_cast<double>(mesh.groups.at(group).size()));  // millimetres
  };
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

}  // namespace
}  // namespace thinwall

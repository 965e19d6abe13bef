#include "studio/recorder/PoseTables.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace thinwall {
namespace {

constexpr ImageSize kSize = {.width = 320, .height = 180};

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

/// A row of a table for each line after the first, by the names of the columns.
std::vector<std::map<std::string, std::string>> rows(const std::string& table) {
  std::istringstream stream(table);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = cells(line);
  std::vector<std::map<std::string, std::string>> result;
  while (std::getline(stream, line)) {
    const std::vector<std::string> values = cells(line);
    for (auto& row = result.emplace_back(); const std::string& name : names) row[name] = values.at(row.size());
  }
  return result;
}

Camera camera_at(const Double3& position, const LensDistortion& lens) {
  return resolve_camera({.position = position, .target = Double3{0, 0, 0}, .lens = lens}, {}, kSize, 0);
}

/// Where a row of cameras.csv puts a point, in pixels: OpenCV's formula, written out.
std::array<double, 2> projected(std::map<std::string, std::string> row, const Double3& point) {
  const auto number = [&](const std::string& name) { return std::stod(row.at(name)); };
  std::array<double, 3> in_camera = {};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string index = std::to_string(axis + 1);
    in_camera[axis] = number("t" + index + "_m");
    for (int i = 0; i < 3; ++i) in_camera[axis] += number("r" + index + std::to_string(i + 1)) * point[i];
  }
  const double x = in_camera[0] / in_camera[2], y = in_camera[1] / in_camera[2], r2 = x * x + y * y;
  const double radial = 1 + r2 * (number("k1") + r2 * (number("k2") + r2 * number("k3")));
  const double p1 = number("p1"), p2 = number("p2");
  return {number("cx_px") + number("fx_px") * (x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)),
          number("cy_px") + number("fy_px") * (y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y)};
}

TEST(PoseTables, TellTheLensOfEachFrameAfterAllThatWasThereBefore) {
  PoseTables tables;
  const PicturePart all = own_part({}, kSize);
  tables.add(0, 0, camera_at({0.1, 0, 0}, {.k1 = -0.3}), all, {});
  tables.add(1, 0.04, camera_at({0, 0.1, 0}, {.k1 = 0.2, .k2 = 0.03, .p1 = 0.01, .p2 = -0.02, .k3 = 0.004}), all, {});
  EXPECT_EQ(tables.cameras().substr(0, tables.cameras().find('\n')),
            "frame,time_s,fx_px,fy_px,cx_px,cy_px,r11,r12,r13,r21,r22,r23,r31,r32,r33,t1_m,t2_m,t3_m,k1,k2,p1,p2,k3");
  const auto table = rows(tables.cameras());
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(std::stod(table[0].at("k1")), -0.3);
  EXPECT_EQ(std::stod(table[0].at("k3")), 0);
  for (const auto& [name, value] : {std::pair{"k1", 0.2}, {"k2", 0.03}, {"p1", 0.01}, {"p2", -0.02}, {"k3", 0.004}}) {
    EXPECT_EQ(std::stod(table[1].at(name)), value) << name;
  }
}

TEST(PoseTables, ARowOfCamerasAlonePutsAPointWhereThePictureShowsIt) {
  const LensDistortion lens = {.k1 = 0.2, .k2 = 0.03, .p1 = 0.01, .p2 = -0.02, .k3 = 0.004};
  const Camera camera = camera_at({0.05, -0.1, 0.03}, lens);
  const Shot beside_another = {.beside = CameraDefinition{}};
  for (const PicturePart& part : {own_part({}, kSize), own_part(beside_another, kSize)}) {
    PoseTables tables;
    tables.add(0, 0, camera_at({0.1, 0, 0}, {.k1 = -0.3}), own_part({}, kSize), {});
    tables.add(1, 0.04, camera, part, {});
    const Projection projection(camera, part);
    const auto expected = projection.land(projection.in_camera({0.01, 0.02, 0.015}));
    ASSERT_TRUE(expected);
    const std::array<double, 2> pixel = projected(rows(tables.cameras())[1], {0.01, 0.02, 0.015});
    EXPECT_NEAR(pixel[0], (*expected)[0], 1e-9);
    EXPECT_NEAR(pixel[1], (*expected)[1], 1e-9);
  }
}

TEST(PoseTables, TellHowFarTheJawsOfForcepsAreApartAndWhatIsInThePictureAfterAllThatWasThereBefore) {
  SnapshotTool forceps, probe;
  forceps.name = "forceps";
  forceps.kind = SnapshotToolKind::kForceps;
  forceps.opening = 0.0035;
  forceps.force = {1, 2, 3};
  probe.name = "probe";
  probe.is_set_aside = true;
  PoseTables tables;
  tables.add(0, 0, camera_at({0.1, 0, 0}, {}), own_part({}, kSize), {forceps, probe});
  EXPECT_EQ(tables.tools().substr(0, tables.tools().find('\n')),
            "frame,time_s,tool,kind,phase,x_m,y_m,z_m,direction_x,direction_y,direction_z,axis_x,axis_y,axis_z,"
            "fx_N,fy_N,fz_N,opening_m,in_picture");
  const auto table = rows(tables.tools());
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(std::stod(table[0].at("opening_m")), 0.0035);
  EXPECT_EQ(table[0].at("fz_N"), "3");
  EXPECT_EQ(table[1].at("opening_m"), "0");
  EXPECT_EQ(table[0].at("in_picture"), "1");
  EXPECT_EQ(table[1].at("in_picture"), "0");
}

TEST(PoseTables, IntrinsicsAreOfTheFirstFrame) {
  PoseTables tables;
  tables.add(0, 0, camera_at({0.1, 0, 0}, {.k1 = -0.25}), own_part({}, kSize), {});
  const std::string first = tables.intrinsics();
  EXPECT_NE(first.find("data: [ -0.25, 0, 0, 0, 0 ]"), std::string::npos) << first;
  tables.add(1, 0.04, camera_at({0, 0.1, 0}, {.k1 = 0.5}), own_part({}, kSize), {});
  EXPECT_EQ(tables.intrinsics(), first);
}

}  // namespace
}  // namespace thinwall

#include "studio/recorder/RecordCsv.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

StepRecord example() {
  ToolRecord tool{.tool = "probe", .phase = "contact"};
  tool.position = {0.1, -0.02, 1e-9};
  tool.depth = 0.004;
  tool.force = {0, -0.0, 1.0 / 3};
  tool.contact_area = 2.5e-5;
  BodyRecord body{.body = "organ", .volume = 1e-5, .fluid_volume = 2e-5, .leaked = 3e-5, .pressure = 101325.25};
  body.newton_iterations = 7;
  body.residual = 1e-300;
  return {.time = 0.015, .tools = {tool}, .bodies = {body}};
}

TEST(RecordCsvTest, HeadersAreWordForWordThoseOfTheContract) {
  EXPECT_EQ(forces_csv_header(), "time_s,tool,phase,x_m,y_m,z_m,depth_m,fx_N,fy_N,fz_N,contact_area_m2");
  EXPECT_EQ(body_csv_header(),
            "time_s,body,volume_m3,fluid_volume_m3,leaked_m3,pressure_Pa,open_area_m2,cut_length_m,elastic_J,bending_J,"
            "kinetic_J,fluid_J,gravity_J,contact_J,viscous_J,friction_J,fracture_J,leak_J,numerical_J,jump_J,"
            "tool_work_J,script_work_J,newton_iterations,residual_N");
}

TEST(RecordCsvTest, ARowHoldsTheColumnsOfTheHeader) {
  EXPECT_EQ(forces_csv_rows(example()), "0.015,probe,contact,0.1,-0.02,1e-09,0.004,0,-0,0.3333333333333333,2.5e-05\n");
  EXPECT_EQ(body_csv_rows(example()),
            "0.015,organ,1e-05,2e-05,3e-05,101325.25,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,7,1e-300\n");
}

TEST(RecordCsvTest, EachMemberHasItsOwnColumn) {
  BodyRecord body;
  for (const auto member :
       {&BodyRecord::volume,    &BodyRecord::fluid_volume, &BodyRecord::leaked,    &BodyRecord::pressure,
        &BodyRecord::open_area, &BodyRecord::cut_length,   &BodyRecord::elastic,   &BodyRecord::bending,
        &BodyRecord::kinetic,   &BodyRecord::fluid,        &BodyRecord::gravity,   &BodyRecord::contact,
        &BodyRecord::viscous,   &BodyRecord::friction,     &BodyRecord::fracture,  &BodyRecord::leak,
        &BodyRecord::numerical, &BodyRecord::jump,         &BodyRecord::tool_work, &BodyRecord::script_work,
        &BodyRecord::residual}) {
    static int number = 0;
    body.*member = ++number;
  }
  body.body = "b";
  body.newton_iterations = 99;
  EXPECT_EQ(body_csv_rows({.time = 0, .tools = {}, .bodies = {body}}),
            "0,b,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,99,21\n");
}

TEST(RecordCsvTest, AChamberHasARowWithTheColumnsOfItsHeader) {
  EXPECT_EQ(chambers_csv_header(), "time_s,body,chamber,volume_m3,fluid_volume_m3,leaked_m3,pressure_Pa");
  const ChamberRecord left{
      .body = "gland", .chamber = "left", .volume = 1, .fluid_volume = 2, .leaked = 3, .pressure = 4};
  EXPECT_EQ(chambers_csv_rows({.time = 0.5, .tools = {}, .bodies = {}, .points = {}, .chambers = {left}}),
            "0.5,gland,left,1,2,3,4\n");
}

TEST(RecordCsvTest, NumbersReadBackToTheSameBits) {
  StepRecord record = example();
  for (const double value : {0.1 + 0.2, 1e22, 5e-324, 123456789.123456789, std::nextafter(1.0, 2.0)}) {
    record.tools[0].depth = value;
    std::istringstream row(forces_csv_rows(record));
    std::string cell;
    for (int column = 0; column < 7; ++column) std::getline(row, cell, ',');
    EXPECT_EQ(std::strtod(cell.c_str(), nullptr), value) << cell;
  }
}

TEST(RecordCsvTest, NamesWithCommasAreQuoted) {
  StepRecord record = example();
  record.tools[0].tool = "probe, \"small\"";
  EXPECT_EQ(forces_csv_rows(record).substr(0, 31), "0.015,\"probe, \"\"small\"\"\",contac");
}

TEST(RecordCsvTest, ANumberThatIsNotFiniteNeverGetsIntoAFile) {
  StepRecord record = example();
  record.tools[0].force.y() = std::numeric_limits<double>::quiet_NaN();
  try {
    static_cast<void>(forces_csv_rows(record));
    FAIL() << "was accepted";
  } catch (const SimulationFailure& failure) {
    EXPECT_STREQ(failure.what(), "fy_N of probe is not a finite number at time 0.015 s");
  }
  record = example();
  record.bodies[0].kinetic = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(body_csv_rows(record)), SimulationFailure);
}

TEST(RecordCsvTest, FilesHaveTheirNamesOnlyWhenFinished) {
  const TemporaryFolder folder;
  {
    RecordCsv csv(folder.path());
    csv.write(example());
    csv.write(example());
    EXPECT_FALSE(std::filesystem::exists(folder / "forces.csv"));
    csv.finish();
  }
  EXPECT_EQ(file_bytes(folder / "forces.csv"),
            forces_csv_header() + '\n' + forces_csv_rows(example()) + forces_csv_rows(example()));
  EXPECT_EQ(file_bytes(folder / "body.csv"),
            body_csv_header() + '\n' + body_csv_rows(example()) + body_csv_rows(example()));
  EXPECT_FALSE(std::filesystem::exists(folder / "forces.unfinished.csv"));
}

TEST(RecordCsvTest, AFullDiskIsReported) {
  // The system's own full disk: each write to it is refused.
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "forces.unfinished.csv");
  RecordCsv csv(folder.path());
  try {
    csv.finish();
    FAIL() << "was written";
  } catch (const PictureFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("forces.csv: No space left on device"), std::string::npos)
        << failure.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "forces.csv"));
}

}  // namespace
}  // namespace thinwall

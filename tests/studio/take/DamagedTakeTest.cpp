#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "renderer/image/WholeFile.hpp"
#include "studio/record/RecordColumns.hpp"
#include "tests/studio/TemporaryFolder.hpp"
#include "tests/studio/take/WrittenTake.hpp"

namespace thinwall {
namespace {

void write_five_steps(const std::filesystem::path& path) {
  write_take(path, {.steps = 5});
}

/// The same of a surface whose topology is another one at each step.
void write_five_topologies(const std::filesystem::path& path) {
  SyntheticRun run({.steps = 5});
  TakeWriter writer(path, kDescription);
  float thickness = 1e-3F;  // metres
  while (auto moment = run.next()) {
    SnapshotSurface& surface = moment->snapshot.surfaces.front();
    auto topology = std::make_shared<SnapshotTopology>(*surface.topology);
    topology->thickness.assign(topology->thickness.size(), thickness);
    thickness *= 2;
    surface.topology = std::move(topology);
    writer.write(*moment);
  }
  writer.finish({.complete = true, .warnings = {}, .state_digest = run.state_digest()});
}

/// Opens a whole take, changes it by the library's own calls, and gives what is said of it, without the file's name and
/// the cure.
std::string complaint_after(const std::function<void(hid_t file)>& change,
                            const std::function<void(const std::filesystem::path&)>& write = write_five_steps) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "take.h5";
  write(path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  change(file);
  EXPECT_GE(H5Fclose(file), 0);
  std::string complaint = complaint_about(path);
  const std::string name = path.string() + ": ";
  const std::string cure = "; run the scenario again";
  if (!complaint.starts_with(name) || !complaint.ends_with(cure)) return complaint;
  return complaint.substr(name.size(), complaint.size() - name.size() - cure.size());
}

/// Puts one value of a dataset in place of all that it holds.
std::function<void(hid_t)> filled(const std::string& name, float value) {
  return [=](hid_t file) {
    const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(dataset);
    const std::vector<float> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)), value);
    EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    H5Sclose(space);
    H5Dclose(dataset);
  };
}

/// Lets a dataset say that it has so many rows.
std::function<void(hid_t)> lengthened(const std::string& name, hsize_t rows) {
  return [=](hid_t file) {
    const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    EXPECT_GE(H5Dset_extent(dataset, &rows), 0);
    H5Dclose(dataset);
  };
}

/// Puts a dataset or an attribute of `count` zeros in the place of one that is there; one without extents for no count.
std::function<void(hid_t)> replaced(const std::string& group, const std::string& name, hsize_t count, bool attribute) {
  return [=](hid_t file) {
    const hid_t parent = H5Oopen(file, group.c_str(), H5P_DEFAULT);
    const hid_t space = count == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr);
    const std::vector<double> zeros(std::max<hsize_t>(count, 1), 0);
    if (attribute) {
      EXPECT_GE(H5Adelete(parent, name.c_str()), 0);
      const hid_t made = H5Acreate2(parent, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
      EXPECT_GE(H5Awrite(made, H5T_NATIVE_DOUBLE, zeros.data()), 0);
      H5Aclose(made);
    } else {
      EXPECT_GE(H5Ldelete(parent, name.c_str(), H5P_DEFAULT), 0);
      const hid_t made =
          H5Dcreate2(parent, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      EXPECT_GE(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data()), 0);
      H5Dclose(made);
    }
    H5Sclose(space);
    H5Oclose(parent);
  };
}

TEST(DamagedTake, RefusesNumbersThatNoRunWrites) {
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(complaint_after(filled("scalars/organ.pressure", kNothing)),
            "the take is damaged (organ.pressure holds a number that is not finite)");
  EXPECT_EQ(complaint_after(filled("time", HUGE_VALF)), "the take is damaged (time holds a number that is not finite)");
  EXPECT_EQ(complaint_after(filled("surfaces/organ/epoch_0/rest_positions", kNothing)),
            "the take is damaged (rest_positions holds a number that is not finite)");
  EXPECT_EQ(complaint_after(filled("surfaces/organ/epoch_0/positions", kNothing)),
            "step 0 is damaged (the surface of organ holds a number that is not finite)");
}

TEST(DamagedTake, RefusesTimesThatNoRunReaches) {
  const auto timed = [](const std::vector<double>& times) {
    return [=](hid_t file) {
      const hid_t dataset = H5Dopen2(file, "time", H5P_DEFAULT);
      EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times.data()), 0);
      H5Dclose(dataset);
    };
  };
  EXPECT_EQ(complaint_after(timed({0, 1, 2, 3, 4})), "");
  EXPECT_EQ(complaint_after(timed({0, 1, 2, 2, 1})), "the take is damaged (times do not ascend)");
  EXPECT_EQ(complaint_after(timed({-1, 0, 1, 2, 3})), "the take is damaged (times are not those of steps)");
  // Pictures of all that time would never end.
  EXPECT_EQ(complaint_after(timed({0, 1, 2, 3, 1e75})), "the take is damaged (times are not those of steps)");
}

TEST(DamagedTake, RefusesCountsThatNoNumberOfIterationsIs) {
  const auto counted = [](double count) {
    return [=](hid_t file) {
      const hid_t dataset = H5Dopen2(file, "records/bodies/organ/values", H5P_DEFAULT);
      std::vector<double> values(5 * kBodyColumns.size());
      EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
      const auto column = std::ranges::find(kBodyColumns, "newton_iterations", &BodyColumn::name);
      values[kBodyColumns.size() + (column - kBodyColumns.begin())] = count;
      EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
      H5Dclose(dataset);
    };
  };
  EXPECT_EQ(complaint_after(counted(3)), "");
  EXPECT_EQ(complaint_after(counted(3e9)), "the take is damaged (newton_iterations is no count)");
  EXPECT_EQ(complaint_after(counted(-1)), "the take is damaged (newton_iterations is no count)");
}

TEST(DamagedTake, RefusesTopologiesOutOfOrder) {
  EXPECT_EQ(complaint_after([](hid_t) {}, write_five_topologies), "");
  // The third says that it begins at step zero, as the first one does.
  EXPECT_EQ(complaint_after(replaced("surfaces/organ/epoch_2", "first_step", 0, true), write_five_topologies),
            "the take is damaged (the surface of organ changes its topology at steps that do not ascend)");
}

TEST(DamagedTake, RefusesMoreThanAFileCanHold) {
  for (const hsize_t rows : {hsize_t{1} << 26, hsize_t{1} << 40, hsize_t{1} << 60}) {
    EXPECT_EQ(complaint_after(lengthened("time", rows)),
              "the take is damaged (time says that it holds more than there is)");
    EXPECT_EQ(complaint_after(lengthened("tools/probe/phase", rows)),
              "the take is damaged (phase says that it holds more than there is)");
  }
}

TEST(DamagedTake, RefusesOtherShapes) {
  EXPECT_EQ(complaint_after(replaced("/", "time", 0, false)),
            "the take is damaged (time has another shape than it should)");
  // What reads one value has room for no more.
  EXPECT_EQ(complaint_after(replaced("tools/probe", "radius_m", 1000, true)),
            "the take is damaged (attribute radius_m is not one value)");
  EXPECT_EQ(complaint_after(replaced("/", "complete", 1000, true)),
            "the take is damaged (attribute complete is not one value)");
}

TEST(DamagedTake, NoticesAFlippedByteInThePositions) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5", {.side = 60});
  const std::string bytes = file_bytes(folder / "take.h5");
  // Positions and fields make up nearly all of this file, so most places in its middle are theirs.
  int noticed = 0;
  for (std::size_t percent = 40; percent < 60; ++percent) {
    std::string damaged = bytes;
    char& byte = damaged[damaged.size() * percent / 100];
    byte = static_cast<char>(byte ^ 0x10);
    write_bytes(folder / "damaged.h5", damaged);
    if (!complaint_about(folder / "damaged.h5").empty()) ++noticed;
  }
  EXPECT_GE(noticed, 18);
}

}  // namespace
}  // namespace thinwall

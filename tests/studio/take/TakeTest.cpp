#include <fcntl.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <functional>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "tests/studio/TemporaryFolder.hpp"
#include "tests/studio/take/WrittenTake.hpp"

namespace thinwall {
namespace {

void expect_equal(const SnapshotTool& read, const SnapshotTool& written) {
  EXPECT_EQ(read.name, written.name);
  EXPECT_EQ(read.kind, written.kind);
  EXPECT_EQ(read.tip, written.tip);
  EXPECT_EQ(read.direction, written.direction);
  EXPECT_EQ(read.axis, written.axis);
  EXPECT_EQ(read.phase, written.phase);
  EXPECT_EQ(read.depth, written.depth);
  EXPECT_EQ(read.force, written.force);
}

void expect_equal(const SnapshotSurface& read, const SnapshotSurface& written) {
  EXPECT_EQ(read.body, written.body);
  EXPECT_EQ(read.positions, written.positions);
  EXPECT_EQ(read.topology->rest_positions, written.topology->rest_positions);
  EXPECT_EQ(read.topology->triangles, written.topology->triangles);
  EXPECT_EQ(read.topology->cap_triangles, written.topology->cap_triangles);
  EXPECT_EQ(read.topology->thickness, written.topology->thickness);
  EXPECT_EQ(read.topology->cut_times, written.topology->cut_times);
  EXPECT_EQ(read.topology->is_scenery, written.topology->is_scenery);
  ASSERT_EQ(read.fields.size(), written.fields.size());
  for (std::size_t i = 0; i < read.fields.size(); ++i) {
    EXPECT_EQ(read.fields[i].name, written.fields[i].name);
    EXPECT_EQ(read.fields[i].unit, written.fields[i].unit);
    EXPECT_EQ(read.fields[i].location, written.fields[i].location);
    EXPECT_EQ(read.fields[i].values, written.fields[i].values);
  }
}

void expect_equal(const Moment& read, const Moment& written) {
  EXPECT_EQ(read.snapshot.time, written.snapshot.time);
  EXPECT_EQ(read.snapshot.gravity, written.snapshot.gravity);
  ASSERT_EQ(read.snapshot.surfaces.size(), written.snapshot.surfaces.size());
  for (std::size_t i = 0; i < read.snapshot.surfaces.size(); ++i) {
    expect_equal(read.snapshot.surfaces[i], written.snapshot.surfaces[i]);
  }
  ASSERT_EQ(read.snapshot.tools.size(), 1U);
  expect_equal(read.snapshot.tools[0], written.snapshot.tools[0]);
  ASSERT_EQ(read.snapshot.scalars.size(), 1U);
  EXPECT_EQ(read.snapshot.scalars[0].name, "organ.pressure");
  EXPECT_EQ(read.snapshot.scalars[0].unit, "Pa");
  EXPECT_EQ(read.snapshot.scalars[0].value, written.snapshot.scalars[0].value);
  EXPECT_EQ(read.planned_duration, written.planned_duration);
  EXPECT_EQ(read.captions, written.captions);
  EXPECT_EQ(read.chapters, written.chapters);
  ASSERT_EQ(read.record.tools.size(), 1U);
  EXPECT_EQ(read.record.tools[0].position, written.record.tools[0].position);
  EXPECT_EQ(read.record.tools[0].force, written.record.tools[0].force);
  EXPECT_EQ(read.record.tools[0].phase, written.record.tools[0].phase);
  ASSERT_EQ(read.record.bodies.size(), 1U);
  EXPECT_EQ(read.record.bodies[0].volume, written.record.bodies[0].volume);
  EXPECT_EQ(read.record.bodies[0].newton_iterations, written.record.bodies[0].newton_iterations);
  EXPECT_EQ(read.record.bodies[0].residual, written.record.bodies[0].residual);
}

TEST(TakeTest, GivesBackBitForBitWhatWasWritten) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5");
  const TakeReader reader(folder / "take.h5");
  EXPECT_EQ(reader.description().name, "sheet");
  EXPECT_EQ(reader.description().title, "A sheet");
  EXPECT_EQ(reader.description().resolved, kDescription.resolved);
  EXPECT_TRUE(reader.ending().complete);
  EXPECT_EQ(reader.ending().warnings, std::vector<std::string>{"the sheet is a formula"});
  EXPECT_EQ(reader.ending().state_digest, "00000000000000000000000004104000");
  const SyntheticRun run;
  ASSERT_EQ(reader.times().size(), 41U);
  // Not in order: a step does not depend on what was read before.
  for (const std::size_t step : {40U, 0U, 17U, 18U}) expect_equal(reader.moment(step), run.moment(step));
}

TEST(TakeTest, ReadsAsASourceInTheOrderOfTime) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5", {.steps = 5});
  const TakeReader reader(folder / "take.h5");
  TakeSource source(reader);
  std::vector<double> times;
  while (const auto moment = source.next()) times.push_back(moment->snapshot.time);
  EXPECT_EQ(times, reader.times());
}

TEST(TakeTest, EqualRunsGiveEqualBytes) {
  const TemporaryFolder folder;
  write_take(folder / "one.h5");
  // Time stamps in the file would have a resolution of one second.
  const struct timespec pause = {1, 100'000'000};
  nanosleep(&pause, nullptr);
  write_take(folder / "two.h5");
  write_take(folder / "other.h5", {.depth = 0.0041});
  EXPECT_GT(file_bytes(folder / "one.h5").size(), 10'000U);
  EXPECT_TRUE(file_bytes(folder / "one.h5") == file_bytes(folder / "two.h5"));
  EXPECT_FALSE(file_bytes(folder / "one.h5") == file_bytes(folder / "other.h5"));
}

TEST(TakeTest, KeepsAChangeOfTopology) {
  const TemporaryFolder folder;
  const SyntheticRun coarse({.side = 5});
  const SyntheticRun fine({.side = 7});
  {
    TakeWriter writer(folder / "take.h5", kDescription);
    for (std::size_t step = 0; step < 3; ++step) writer.write(coarse.moment(step));
    for (std::size_t step = 3; step < 6; ++step) writer.write(fine.moment(step));
    writer.finish({.complete = true, .warnings = {}, .state_digest = ""});
  }
  const TakeReader reader(folder / "take.h5");
  expect_equal(reader.moment(2), coarse.moment(2));
  expect_equal(reader.moment(3), fine.moment(3));
  expect_equal(reader.moment(5), fine.moment(5));
}

TEST(TakeTest, KeepsGravityWhenLipsWereCutAndWhatIsScenery) {
  const TemporaryFolder folder;
  Moment moment = SyntheticRun({.side = 5}).moment(0);
  moment.snapshot.gravity = {0, 1.5, -9.7};
  auto topology = std::make_shared<SnapshotTopology>(*moment.snapshot.surfaces[0].topology);
  topology->cut_times.assign(topology->rest_positions.size(), kNeverCut);
  topology->cut_times[3] = 0.25F;
  topology->is_scenery = true;
  moment.snapshot.surfaces[0].topology = topology;
  {
    TakeWriter writer(folder / "take.h5", kDescription);
    writer.write(moment);
    writer.finish({.complete = true, .warnings = {}, .state_digest = ""});
  }
  expect_equal(TakeReader(folder / "take.h5").moment(0), moment);
}

TEST(TakeTest, HasItsNameOnlyWhenFinished) {
  const TemporaryFolder folder;
  SyntheticRun run;
  {
    TakeWriter writer(folder / "take.h5", kDescription);
    for (int step = 0; step < 7; ++step) writer.write(*run.next());
    EXPECT_FALSE(std::filesystem::exists(folder / "take.h5"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "take.h5"));
  const TakeReader reader(folder / "take.unfinished.h5");
  EXPECT_FALSE(reader.ending().complete);
  ASSERT_EQ(reader.times().size(), 7U);
  expect_equal(reader.moment(6), run.moment(6));
}

TEST(TakeTest, WithoutAnyStepIsStillATake) {
  const TemporaryFolder folder;
  { const TakeWriter writer(folder / "take.h5", kDescription); }
  EXPECT_TRUE(TakeReader(folder / "take.unfinished.h5").times().empty());
}

TEST(TakeTest, NamesWithASlashAreKept) {
  const TemporaryFolder folder;
  Moment moment = SyntheticRun().moment(0);
  moment.snapshot.surfaces[0].body = "left/lobe";
  {
    TakeWriter writer(folder / "take.h5", kDescription);
    writer.write(moment);
    writer.finish({});
  }
  EXPECT_EQ(TakeReader(folder / "take.h5").moment(0).snapshot.surfaces[0].body, "left/lobe");
}

TEST(TakeTest, RefusesANumberThatIsNotFinite) {
  const TemporaryFolder folder;
  TakeWriter writer(folder / "take.h5", kDescription);
  const auto expect_refused = [&](const std::function<void(Moment&)>& spoil) {
    Moment moment = SyntheticRun().moment(0);
    spoil(moment);
    EXPECT_THROW(writer.write(moment), SimulationFailure);
  };
  expect_refused([](Moment& moment) { moment.snapshot.surfaces[0].positions[3][1] = std::nanf(""); });
  expect_refused([](Moment& moment) { moment.snapshot.surfaces[0].fields[0].values[0] = std::nanf(""); });
  expect_refused([](Moment& moment) { moment.snapshot.tools[0].force[2] = HUGE_VAL; });
  expect_refused([](Moment& moment) { moment.snapshot.scalars[0].value = std::nan(""); });
  expect_refused([](Moment& moment) { moment.record.tools[0].depth = std::nan(""); });
  expect_refused([](Moment& moment) { moment.record.bodies[0].pressure = -HUGE_VAL; });
  writer.write(SyntheticRun().moment(0));
}

TEST(TakeTest, RefusesAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  try {
    const TakeWriter writer(folder.path() / "nowhere" / "take.h5", kDescription);
    FAIL() << "was made";
  } catch (const PictureFailure& failure) {
    EXPECT_EQ(std::string(failure.what()), "cannot write " + (folder.path() / "nowhere" / "take.h5").string() +
                                               ": No such file or directory; " + cure_for_write_error(ENOENT));
  }
}

/// Limits the size of files that this process writes, which refuses writes as a full disk does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  struct rlimit before_ = {};
};

TEST(TakeTest, SaysWhyItCouldNotBeWritten) {
  const TemporaryFolder folder;
  const FileSizeLimit limit(20'000);
  try {
    write_take(folder / "take.h5", {.steps = 400, .side = 20});
    FAIL() << "was written";
  } catch (const PictureFailure& failure) {
    EXPECT_EQ(std::string(failure.what()),
              "cannot write " + (folder / "take.h5").string() + ": File too large; " + cure_for_write_error(EFBIG));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "take.h5"));
}

TEST(TakeTest, SaysThatThereIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint_about(folder / "none.h5"), (folder / "none.h5").string() + ": there is no such file");
  write_bytes(folder / "stopped.unfinished.h5", "what a run that was stopped has left");
  EXPECT_EQ(complaint_about(folder / "stopped.h5"), (folder / "stopped.h5").string() + ": there is no such file, but " +
                                                        (folder / "stopped.unfinished.h5").string() +
                                                        " of a run that was stopped, which can be shown");
  EXPECT_EQ(complaint_about("/dev/null"), "/dev/null: this is no file");
}

TEST(TakeTest, PointsFromAFolderToTheTakeInIt) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint_about(folder.path()), folder.path().string() + ": this is a folder; give the take.h5 of a run");
  write_bytes(folder / "take.h5", "a take");
  EXPECT_EQ(complaint_about(folder.path()),
            folder.path().string() + ": this is a folder; give " + (folder / "take.h5").string());
}

TEST(TakeTest, SaysThatAFileIsNoTake) {
  const TemporaryFolder folder;
  write_bytes(folder / "text.h5", "time_s,tool,phase\n");
  EXPECT_EQ(complaint_about(folder / "text.h5"),
            (folder / "text.h5").string() + ": this is no take (not an HDF5 file); give the take.h5 of a run");
  H5Fclose(H5Fcreate((folder / "other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_EQ(complaint_about(folder / "other.h5"),
            (folder / "other.h5").string() + ": this is an HDF5 file, but no take; give the take.h5 of a run");
}

TEST(TakeTest, SaysThatATakeIsOfAnotherVersion) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5", {.steps = 2});
  const hid_t file = H5Fopen((folder / "take.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, "format_version", H5P_DEFAULT);
  const std::int64_t version = 7;
  H5Awrite(attribute, H5T_NATIVE_INT64, &version);
  H5Aclose(attribute);
  H5Fclose(file);
  EXPECT_EQ(complaint_about(folder / "take.h5"),
            (folder / "take.h5").string() +
                ": take format version 7, but this program reads version 1; run the scenario again with this program");
}

TEST(TakeTest, SaysThatATakeIsCutShortWhereverItIsCut) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5");
  const std::string bytes = file_bytes(folder / "take.h5");
  for (const double part : {0.01, 0.3, 0.7, 0.999}) {
    write_bytes(folder / "cut.h5", bytes.substr(0, static_cast<std::size_t>(static_cast<double>(bytes.size()) * part)));
    const std::string complaint = complaint_about(folder / "cut.h5");
    EXPECT_NE(complaint.find("cut.h5: the take is cut short or damaged ("), std::string::npos) << part << complaint;
  }
}

TEST(TakeTest, ARunThatIsKilledSoonLeavesAtLeastHalfOfItsSteps) {
  for (const std::size_t steps : {1U, 3U, 7U}) {
    const TemporaryFolder folder;
    const pid_t run = fork();
    if (run == 0) {
      SyntheticRun moments({.steps = 10});
      TakeWriter writer(folder / "take.h5", kDescription);
      for (std::size_t i = 0; i < steps; ++i) writer.write(*moments.next());
      _exit(0);
    }
    waitpid(run, nullptr, 0);
    const TakeReader take(folder / "take.unfinished.h5");
    EXPECT_EQ(take.times().size(), std::bit_floor(steps));
    EXPECT_EQ(complaint_about(folder / "take.unfinished.h5"), "");
  }
}

TEST(TakeTest, SaysThatATakeIsStillBeingWritten) {
  const TemporaryFolder folder;
  write_take(folder / "take.h5", {.steps = 2});
  const int writer = open((folder / "take.h5").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(flock(writer, LOCK_EX), 0);
  EXPECT_EQ(complaint_about(folder / "take.h5"),
            (folder / "take.h5").string() + ": a run is still writing this take; wait until it has ended");
  close(writer);
  EXPECT_EQ(complaint_about(folder / "take.h5"), "");
}

}  // namespace
}  // namespace thinwall

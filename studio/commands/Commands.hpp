#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/device/DeviceChoice.hpp"
#include "renderer/image/Image.hpp"
#include "renderer/look/DataView.hpp"
#include "studio/commands/Arguments.hpp"
#include "studio/commands/DataViewRange.hpp"
#include "studio/comparison/FileComparison.hpp"
#include "studio/golden/GoldenRun.hpp"
#include "studio/haptics/HapticRun.hpp"

namespace thinwall {

// A command is its options and a function that gives the exit code; exceptions are for exit_code_of.

struct RunOptions {
  std::filesystem::path scenario;
  std::optional<std::filesystem::path> out;  // out/NAME when absent
  Overrides overrides;
  DeviceChoice device;
  std::string device_text = "auto";
  bool render = true;
  bool video = true;
  bool frames = false;
  bool surfaces = false;
  bool ground_truth = false;
  bool stats = false;
  bool json = false;
};
int run_scenario(const RunOptions& options);

struct CheckOptions {
  std::vector<std::filesystem::path> scenarios;
  Overrides overrides;
  bool json = false;
};
int check_scenarios(const CheckOptions& options);

struct RenderOptions {
  std::filesystem::path take;
  std::optional<std::filesystem::path> out;   // `render` beside the take when absent
  std::optional<std::filesystem::path> view;  // a scenario whose camera, lights, look and record are taken
  Overrides overrides;                        // of its parameters
  std::optional<ImageSize> size;
  std::optional<double> frames_per_second;
  std::optional<DataQuantity> data;  // shown instead of the tissue, with the range of the whole take
  DataViewChanges data_changes;      // of that, or of the scenario's own data view
  bool mesh = false;                 // whether the edges of triangles are drawn
  DeviceChoice device;
  std::string device_text = "auto";
  bool video = true;
  bool frames = false;
  bool surfaces = false;
  bool ground_truth = false;
  bool stats = false;
  bool json = false;
};
int render_take(const RenderOptions& options);

struct StillOptions {
  std::filesystem::path scenario;
  double at = 0;  // seconds
  std::filesystem::path picture;
  Overrides overrides;
  std::optional<ImageSize> size;
  DeviceChoice device;
  bool ground_truth = false;  // in the folder STEM_ground_truth beside the picture
  bool stats = false;
  bool json = false;
};
int make_still(const StillOptions& options);

struct GoldenOptions {
  std::vector<std::string> scenarios;  // files, or names in the folder of scenarios, perhaps with "@1.5s"
  DeviceChoice device;
  std::string device_text = "auto";
  std::filesystem::path out = "out/golden";  // where pictures that failed are put, to be looked at
  std::string why;                           // approve and review
  std::filesystem::path junit;               // test: the results as JUnit XML; nowhere when empty
  int jobs = 0;                              // scenarios at once; 0: as many as there are cores
  bool all = false;                          // test: also what has not changed since it was good
  bool json = false;
};
int test_goldens(const GoldenOptions& options);
int report_goldens(const GoldenOptions& options);
int approve_goldens(const GoldenOptions& options);
int review_goldens(const GoldenOptions& options);
int list_goldens(const GoldenOptions& options);
int explain_goldens(const GoldenOptions& options);

/// Makes today's picture the golden, tells the figures before and after, and gives the comparison with it; nothing when
/// it is missing, as approved, or different within its limits where that is not to be approved too.
std::optional<GoldenResult> approve_golden(const JudgedScenario& judged, std::size_t index, const std::string& why,
                                           bool within_limits_too);

struct CompareOptions {
  std::filesystem::path first;  // two files, or two folders
  std::filesystem::path second;
  FileComparisonOptions comparison;
  std::optional<std::filesystem::path> difference;  // where the picture of the difference goes; of folders, a folder
  bool json = false;
};
int compare(const CompareOptions& options);

struct HapticOptions {
  std::filesystem::path scenario;
  Overrides overrides;
  std::string tool;                                 // the first of the scenario when empty
  std::optional<std::filesystem::path> trajectory;  // a recorded motion
  std::optional<std::filesystem::path> peer;        // the socket of a driver
  std::optional<double> duration;                   // seconds
  std::optional<std::filesystem::path> record;      // where the table of the ticks goes
  HapticForces forces = HapticForces::kAuto;
  bool real_time = true;
  bool json = false;
};
int drive_haptics(const HapticOptions& options);

struct DoctorOptions {
  DeviceChoice device;
  bool json = false;
};
int examine_machine(const DoctorOptions& options);

}  // namespace thinwall

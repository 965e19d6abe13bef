#include "studio/take/TakeReader.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <limits>
#include <utility>

#include "renderer/image/WholeFile.hpp"
#include "studio/record/RecordColumns.hpp"
#include "studio/take/Hdf5.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeLayout.hpp"
#include "studio/take/TakeRows.hpp"

namespace thinwall {
namespace {

using hdf5::Element;
using hdf5::Handle;

/// Seconds; a scenario's are at most one second long.
constexpr double kLongestStep = 1.001;

Double3 triple(const double* values) {
  return {values[0], values[1], values[2]};
}

/// Throws hdf5::Failure unless the columns of counts hold what an int can.
void require_counts(const TakeTable& bodies) {
  for (std::size_t k = 0; k < bodies.values.size(); ++k) {
    const BodyColumn& column = kBodyColumns[k % kBodyColumns.size()];
    if (column.count == nullptr) continue;
    const bool is_count = bodies.values[k] >= 0 && bodies.values[k] <= std::numeric_limits<int>::max();
    require_of_take(is_count, std::string(column.name) + " is no count");
  }
}

/// Who writes an HDF5 file holds its lock.
bool is_being_written(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return is_locked;
}

}  // namespace

struct TakeReader::Implementation {
  std::filesystem::path path;
  Handle file;
  TakeDescription description;
  TakeEnding ending;
  std::vector<double> times;
  Double3 gravity = {0, 0, 0};  // metres / second^2
  TakeTable planned_duration;
  std::vector<SurfaceRows> surfaces;
  std::vector<ToolRows> tools;
  std::vector<ScalarRows> scalars;
  std::vector<RecordRows> tool_records;
  std::vector<RecordRows> body_records;
  std::vector<TimedText> captions;
  std::vector<TimedText> chapters;

  void open();
  void require_format() const;
  void read_header();
  void read_layout();
  Moment read(std::size_t step) const;
  StepRecord read_record(std::size_t step) const;
};

void TakeReader::Implementation::open() {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    const std::filesystem::path stopped = unfinished_name(path);
    const std::string instead = std::filesystem::exists(stopped, error)
                                    ? ", but " + stopped.string() + " of a run that was stopped, which can be shown"
                                    : "";
    throw TakeError(path.string() + ": there is no such file" + instead);
  }
  if (std::filesystem::is_directory(path, error)) {
    const std::filesystem::path inside = path / "take.h5";
    throw TakeError(path.string() + ": this is a folder; give " +
                    (std::filesystem::exists(inside, error) ? inside.string() : "the take.h5 of a run"));
  }
  if (!std::filesystem::is_regular_file(path, error)) throw TakeError(path.string() + ": this is no file");
  std::array<char, 8> signature{};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw TakeError(path.string() + ": cannot be opened for reading");
  stream.read(signature.data(), signature.size());
  if (std::string(signature.data(), signature.size()) != "\x89HDF\r\n\x1a\n") {
    throw TakeError(path.string() + ": this is no take (not an HDF5 file); give the take.h5 of a run");
  }
  try {
    file = hdf5::open_file(path);
  } catch (const hdf5::Failure& failure) {
    if (is_being_written(path)) {
      throw TakeError(path.string() + ": a run is still writing this take; wait until it has ended");
    }
    throw TakeError(path.string() + ": the take is cut short or damaged (" + failure.what() + ")",
                    "run the scenario again");
  }
}

void TakeReader::Implementation::require_format() const {
  std::string format;
  try {
    format = hdf5::read_text_attribute(file, "format");
  } catch (const hdf5::Failure&) {
  }
  if (format != take_layout::kFormat) {
    throw TakeError(path.string() + ": this is an HDF5 file, but no take; give the take.h5 of a run");
  }
  const std::int64_t version = hdf5::read_integer_attribute(file, "format_version");
  if (version != take_layout::kFormatVersion) {
    throw TakeError(path.string() + ": take format version " + std::to_string(version) +
                    ", but this program reads version " + std::to_string(take_layout::kFormatVersion) +
                    "; run the scenario again with this program");
  }
}

void TakeReader::Implementation::read_header() {
  description.name = hdf5::read_text_attribute(file, "name");
  description.title = hdf5::read_text_attribute(file, "title");
  description.resolved = hdf5::read_text(file, "scenario");
  ending.complete = hdf5::read_integer_attribute(file, "complete") == 1;
  ending.state_digest = hdf5::read_text_attribute(file, "state_digest");
  if (hdf5::has_link(file, "warnings")) ending.warnings = hdf5::read_texts(file, "warnings");
  captions = read_timed_texts(file, "captions");
  chapters = read_timed_texts(file, "chapters");
}

void TakeReader::Implementation::read_layout() {
  const std::vector<hsize_t> shape = hdf5::shape_of(hdf5::open_dataset(file, "time"));
  require_of_take(shape.size() == 1, "time has another shape than it should");
  const std::size_t steps = shape[0];
  times = read_table(file, "time", steps, 1).values;
  require_of_take(std::is_sorted(times.begin(), times.end()), "times do not ascend");
  const bool begins_early = times.empty() || times.front() >= 0;
  const auto gap = std::adjacent_find(times.begin(), times.end(),
                                      [](double before, double after) { return after - before > kLongestStep; });
  require_of_take(begins_early && gap == times.end(), "times are not those of steps");
  planned_duration = read_table(file, "planned_duration", steps, 1);
  if (steps == 0) return;
  if (hdf5::has_link(file, "gravity")) gravity = triple(read_table(file, "gravity", 3, 1).row(0));
  const Handle surface_group = hdf5::open_group(file, "surfaces");
  for (const std::string& link : hdf5::link_names(surface_group)) {
    surfaces.push_back(read_surface(hdf5::open_group(surface_group, link), steps));
  }
  const Handle tool_group = hdf5::open_group(file, "tools");
  for (const std::string& link : hdf5::link_names(tool_group)) {
    tools.push_back(read_tool(hdf5::open_group(tool_group, link), steps));
  }
  const Handle scalar_group = hdf5::open_group(file, "scalars");
  for (const std::string& link : hdf5::link_names(scalar_group)) {
    const Handle dataset = hdf5::open_dataset(scalar_group, link);
    scalars.push_back({.layout = {.name = hdf5::read_text_attribute(dataset, "name"),
                                  .unit = hdf5::read_text_attribute(dataset, "unit")},
                       .values = read_table(scalar_group, link, steps, 1)});
  }
  const Handle records = hdf5::open_group(file, "records");
  tool_records = read_records(records, "tools", steps, kToolColumns.size(), true);
  body_records = read_records(records, "bodies", steps, kBodyColumns.size(), false);
  for (const RecordRows& rows : body_records) require_counts(rows.values);
}

StepRecord TakeReader::Implementation::read_record(std::size_t step) const {
  StepRecord record{.time = times[step], .tools = {}, .bodies = {}};
  for (const RecordRows& rows : tool_records) {
    ToolRecord tool{.tool = rows.name, .phase = rows.phases[step]};
    for (std::size_t c = 0; c < kToolColumns.size(); ++c) kToolColumns[c].value(tool) = rows.values.row(step)[c];
    record.tools.push_back(std::move(tool));
  }
  for (const RecordRows& rows : body_records) {
    BodyRecord body{.body = rows.name};
    for (std::size_t c = 0; c < kBodyColumns.size(); ++c) kBodyColumns[c].set(body, rows.values.row(step)[c]);
    record.bodies.push_back(std::move(body));
  }
  return record;
}

Moment TakeReader::Implementation::read(std::size_t step) const {
  Moment moment;
  moment.snapshot.time = times.at(step);
  moment.snapshot.gravity = gravity;
  for (const SurfaceRows& rows : surfaces) {
    const auto after = std::upper_bound(rows.epochs.begin(), rows.epochs.end(), step,
                                        [](std::size_t s, const EpochRows& epoch) { return s < epoch.first_step; });
    const EpochRows& epoch = *std::prev(after);
    const std::size_t row = step - epoch.first_step;
    SnapshotSurface surface{.body = rows.body, .topology = epoch.topology, .positions = {}, .fields = {}};
    surface.positions.resize(epoch.topology->rest_positions.size());
    hdf5::read_rows(epoch.positions, Element::kFloat32, row, 1, surface.positions.data());
    require_finite("the surface of " + rows.body, surface.positions);
    for (const FieldRows& field_rows : epoch.fields) {
      SnapshotField field = field_rows.layout;
      field.values.resize(field_rows.size);
      hdf5::read_rows(field_rows.dataset, Element::kFloat32, row, 1, field.values.data());
      require_finite("the field " + field.name, field.values);
      surface.fields.push_back(std::move(field));
    }
    moment.snapshot.surfaces.push_back(std::move(surface));
  }
  for (const ToolRows& rows : tools) {
    SnapshotTool tool = rows.layout;
    const double* state = rows.state.row(step);
    tool.tip = triple(state);
    tool.direction = triple(state + 3);
    tool.axis = triple(state + 6);
    tool.depth = state[9];
    tool.force = triple(state + 10);
    if (tool.kind == SnapshotToolKind::kForceps) tool.opening = *rows.opening.row(step);
    tool.phase = rows.phases[step];
    moment.snapshot.tools.push_back(std::move(tool));
  }
  for (const ScalarRows& rows : scalars) {
    moment.snapshot.scalars.push_back(rows.layout);
    moment.snapshot.scalars.back().value = *rows.values.row(step);
  }
  moment.record = read_record(step);
  moment.planned_duration = *planned_duration.row(step);
  moment.captions = captions;
  moment.chapters = chapters;
  return moment;
}

TakeReader::TakeReader(const std::filesystem::path& file) : implementation_(std::make_unique<Implementation>()) {
  implementation_->path = file;
  implementation_->open();
  try {
    implementation_->require_format();
    implementation_->read_header();
    implementation_->read_layout();
  } catch (const hdf5::Failure& failure) {
    throw TakeError(file.string() + ": the take is damaged (" + failure.what() + ")", "run the scenario again");
  }
}

TakeReader::~TakeReader() = default;
TakeReader::TakeReader(TakeReader&&) noexcept = default;
TakeReader& TakeReader::operator=(TakeReader&&) noexcept = default;

const TakeDescription& TakeReader::description() const {
  return implementation_->description;
}
const TakeEnding& TakeReader::ending() const {
  return implementation_->ending;
}
const std::vector<double>& TakeReader::times() const {
  return implementation_->times;
}

Moment TakeReader::moment(std::size_t step) const {
  try {
    return implementation_->read(step);
  } catch (const hdf5::Failure& failure) {
    throw TakeError(
        implementation_->path.string() + ": step " + std::to_string(step) + " is damaged (" + failure.what() + ")",
        "run the scenario again");
  }
}

std::optional<Moment> TakeSource::next() {
  if (step_ == take_.times().size()) return std::nullopt;
  return take_.moment(step_++);
}

}  // namespace thinwall

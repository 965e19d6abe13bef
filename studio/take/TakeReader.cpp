#include "studio/take/TakeReader.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <utility>

#include "studio/record/RecordColumns.hpp"
#include "studio/take/Hdf5.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeLayout.hpp"

namespace thinwall {
namespace {

using hdf5::Element;
using hdf5::Handle;

/// A number per step and column, all steps at once.
struct Table {
  std::size_t columns = 1;
  std::vector<double> values;  // (steps x columns)
  const double* row(std::size_t step) const { return values.data() + step * columns; }
};

struct FieldRows {
  SnapshotField layout;  // without values
  std::size_t size = 0;
  Handle dataset;
};

struct EpochRows {
  std::size_t first_step = 0;
  std::shared_ptr<const SnapshotTopology> topology;
  Handle positions;
  std::vector<FieldRows> fields;
};

struct SurfaceRows {
  std::string body;
  std::vector<EpochRows> epochs;
};

struct ToolRows {
  SnapshotTool layout;  // name, kind and sizes
  Table state;
  Table opening;  // of forceps only
  std::vector<std::string> phases;
};

struct ScalarRows {
  SnapshotScalar layout;
  Table values;
};

struct RecordRows {
  std::string name;
  Table values;
  std::vector<std::string> phases;
};

void require(bool condition, const std::string& complaint) {
  if (!condition) throw hdf5::Failure(complaint);
}

Table read_table(const Handle& parent, const std::string& name, std::size_t steps, std::size_t columns) {
  const Handle dataset = hdf5::open_dataset(parent, name);
  const std::vector<hsize_t> shape = hdf5::shape_of(dataset);
  const std::size_t found = shape.size() == 1 ? 1 : shape.size() == 2 ? shape[1] : 0;
  require(found == columns && shape[0] >= steps, name + " has another shape than it should");
  Table table{.columns = columns, .values = std::vector<double>(steps * columns)};
  hdf5::read_rows(dataset, Element::kFloat64, 0, steps, table.values.data());
  return table;
}

std::vector<std::string> read_phases(const Handle& parent, std::size_t steps) {
  std::vector<std::string> phases = hdf5::read_text_rows(hdf5::open_dataset(parent, "phase"), take_layout::kPhaseBytes);
  require(phases.size() >= steps, "phase has fewer rows than steps");
  return phases;
}

template <typename Row>
std::vector<Row> read_rows_of(const Handle& parent, const char* name, Element element, std::size_t row_elements) {
  const Handle dataset = hdf5::open_dataset(parent, name);
  const std::vector<hsize_t> shape = hdf5::shape_of(dataset);
  require(!shape.empty() && (shape.size() == 1 ? 1 : shape[1]) == row_elements && shape.size() <= 2,
          std::string(name) + " has another shape than it should");
  std::vector<Row> rows(shape[0]);
  hdf5::read_rows(dataset, element, 0, shape[0], rows.data());
  return rows;
}

std::shared_ptr<const SnapshotTopology> read_topology(const Handle& epoch) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = read_rows_of<Float3>(epoch, "rest_positions", Element::kFloat32, 3);
  topology->triangles = read_rows_of<Triangle>(epoch, "triangles", Element::kUint32, 3);
  topology->cap_triangles = read_rows_of<Triangle>(epoch, "cap_triangles", Element::kUint32, 3);
  topology->thickness = read_rows_of<float>(epoch, "thickness", Element::kFloat32, 1);
  if (hdf5::has_link(epoch, "rest_metric")) {
    topology->rest_metric = read_rows_of<Float3>(epoch, "rest_metric", Element::kFloat32, 3);
    require(topology->rest_metric.size() == topology->triangles.size(), "rest_metric and triangles differ in number");
  }
  if (hdf5::has_link(epoch, "cut_times")) {
    topology->cut_times = read_rows_of<float>(epoch, "cut_times", Element::kFloat32, 1);
    require(topology->cut_times.size() == topology->rest_positions.size(), "cut_times and vertices differ in number");
  }
  for (const auto* triangles : {&topology->triangles, &topology->cap_triangles}) {
    for (const Triangle& triangle : *triangles) {
      require(*std::max_element(triangle.begin(), triangle.end()) < topology->rest_positions.size(),
              "a triangle names a vertex that is not there");
    }
  }
  require(topology->thickness.size() == topology->triangles.size(), "thickness and triangles differ in number");
  return topology;
}

EpochRows read_epoch(const Handle& group, std::size_t steps_to_come) {
  EpochRows epoch{.first_step = static_cast<std::size_t>(hdf5::read_integer_attribute(group, "first_step")),
                  .topology = read_topology(group),
                  .positions = hdf5::open_dataset(group, "positions"),
                  .fields = {}};
  const std::vector<hsize_t> shape = hdf5::shape_of(epoch.positions);
  require(shape.size() == 3 && shape[1] == epoch.topology->rest_positions.size() && shape[2] == 3 &&
              shape[0] >= std::min<std::size_t>(steps_to_come, 1),
          "positions have another shape than they should");
  const Handle fields = hdf5::open_group(group, "fields");
  for (const std::string& link : hdf5::link_names(fields)) {
    Handle dataset = hdf5::open_dataset(fields, link);
    SnapshotField layout{.name = hdf5::read_text_attribute(dataset, "name"),
                         .unit = hdf5::read_text_attribute(dataset, "unit"),
                         .location = hdf5::read_text_attribute(dataset, "location") == "vertex"
                                         ? FieldLocation::kVertex
                                         : FieldLocation::kTriangle,
                         .values = {}};
    const std::size_t size = layout.location == FieldLocation::kVertex ? epoch.topology->rest_positions.size()
                                                                       : epoch.topology->triangles.size();
    const std::vector<hsize_t> field_shape = hdf5::shape_of(dataset);
    require(field_shape.size() == 2 && field_shape[1] == size, "the field " + layout.name + " has another shape");
    epoch.fields.push_back({.layout = std::move(layout), .size = size, .dataset = std::move(dataset)});
  }
  return epoch;
}

SurfaceRows read_surface(const Handle& group, std::size_t steps) {
  SurfaceRows surface{.body = hdf5::read_text_attribute(group, "name"), .epochs = {}};
  for (const std::string& link : hdf5::link_names(group)) {
    surface.epochs.push_back(read_epoch(hdf5::open_group(group, link), steps));
  }
  require(steps == 0 || (!surface.epochs.empty() && surface.epochs.front().first_step == 0),
          "the surface of " + surface.body + " has no topology at the first step");
  return surface;
}

SnapshotToolKind tool_kind(const std::string& name) {
  for (const auto& [kind, word] : take_layout::kToolKinds) {
    if (name == word) return kind;
  }
  require(false, "a tool of unknown kind `" + name + "`");
  return SnapshotToolKind::kPoint;
}

ToolRows read_tool(const Handle& group, std::size_t steps) {
  ToolRows tool;
  tool.layout.name = hdf5::read_text_attribute(group, "name");
  tool.layout.kind = tool_kind(hdf5::read_text_attribute(group, "kind"));
  tool.layout.radius = hdf5::read_real_attribute(group, "radius_m");
  tool.layout.length = hdf5::read_real_attribute(group, "length_m");
  if (take_layout::is_flat(tool.layout.kind)) {
    tool.layout.width = hdf5::read_real_attribute(group, "width_m");
    tool.layout.thickness = hdf5::read_real_attribute(group, "thickness_m");
  }
  if (tool.layout.kind == SnapshotToolKind::kForceps) tool.opening = read_table(group, "opening", steps, 1);
  tool.state = read_table(group, "state", steps, take_layout::kToolStateColumns);
  tool.phases = read_phases(group, steps);
  return tool;
}

std::vector<RecordRows> read_records(const Handle& parent, const char* name, std::size_t steps, std::size_t columns,
                                     bool phased) {
  const Handle all = hdf5::open_group(parent, name);
  std::vector<RecordRows> records;
  for (const std::string& link : hdf5::link_names(all)) {
    const Handle group = hdf5::open_group(all, link);
    records.push_back({.name = hdf5::read_text_attribute(group, "name"),
                       .values = read_table(group, "values", steps, columns),
                       .phases = phased ? read_phases(group, steps) : std::vector<std::string>{}});
  }
  return records;
}

std::vector<TimedText> read_timed_texts(const Handle& file, const char* name) {
  // A run that was killed did not come to write them.
  if (!hdf5::has_link(file, name)) return {};
  const Handle group = hdf5::open_group(file, name);
  const std::vector<std::string> words = hdf5::read_texts(group, "text");
  const Table spans = read_table(group, "span", words.size(), 2);
  std::vector<TimedText> texts;
  for (std::size_t i = 0; i < words.size(); ++i) {
    texts.push_back({.begin = spans.row(i)[0], .end = spans.row(i)[1], .text = words[i]});
  }
  return texts;
}

Double3 triple(const double* values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

struct TakeReader::Implementation {
  std::filesystem::path path;
  Handle file;
  TakeDescription description;
  TakeEnding ending;
  std::vector<double> times;
  Double3 gravity = {0, 0, 0};  // metres / second^2
  Table planned_duration;
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
  if (!std::filesystem::exists(path, error)) throw TakeError(path.string() + ": there is no such file");
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
    throw TakeError(path.string() + ": the take is cut short or damaged (" + failure.what() +
                    "); run the scenario again");
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
  const std::size_t steps = hdf5::shape_of(hdf5::open_dataset(file, "time")).at(0);
  times = read_table(file, "time", steps, 1).values;
  require(std::is_sorted(times.begin(), times.end()), "times do not ascend");
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
    for (const FieldRows& field_rows : epoch.fields) {
      SnapshotField field = field_rows.layout;
      field.values.resize(field_rows.size);
      hdf5::read_rows(field_rows.dataset, Element::kFloat32, row, 1, field.values.data());
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
    throw TakeError(file.string() + ": the take is damaged (" + failure.what() + "); run the scenario again");
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
    throw TakeError(implementation_->path.string() + ": step " + std::to_string(step) + " is damaged (" +
                    failure.what() + "); run the scenario again");
  }
}

std::optional<Moment> TakeSource::next() {
  if (step_ == take_.times().size()) return std::nullopt;
  return take_.moment(step_++);
}

}  // namespace thinwall

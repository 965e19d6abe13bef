#include "studio/take/TakeWriter.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "engine/simulation/SimulationFailure.hpp"
#include "renderer/image/PictureFailure.hpp"
#include "renderer/image/WholeFile.hpp"
#include "studio/record/RecordColumns.hpp"
#include "studio/take/Hdf5.hpp"
#include "studio/take/TakeLayout.hpp"

namespace thinwall {
namespace {

using hdf5::Element;
using hdf5::Handle;
using hdf5::RowWriter;

// Small rows are stored many together; a surface, which a reader wants one at a time, is a chunk of its own.
constexpr hsize_t kSmallRowsPerChunk = 128;
// A killed run loses at most this many steps, and no more than half of the first ones, which may have taken long. Not
// by the clock, which would put equal steps to other places in the file.
constexpr std::size_t kStepsBetweenFlushes = 100;

bool is_flushed_after(std::size_t steps) {
  return steps < kStepsBetweenFlushes ? std::has_single_bit(steps) : steps % kStepsBetweenFlushes == 0;
}

std::array<double, take_layout::kToolStateColumns> tool_state(const SnapshotTool& tool) {
  const auto& [tip, direction, axis, force] = std::tie(tool.tip, tool.direction, tool.axis, tool.force);
  return {tip[0],  tip[1],  tip[2],     direction[0], direction[1], direction[2], axis[0],
          axis[1], axis[2], tool.depth, force[0],     force[1],     force[2]};
}

std::array<double, kToolColumns.size()> tool_values(ToolRecord tool) {
  std::array<double, kToolColumns.size()> values{};
  for (std::size_t c = 0; c < values.size(); ++c) values[c] = kToolColumns[c].value(tool);
  return values;
}

std::array<double, kBodyColumns.size()> body_values(const BodyRecord& body) {
  std::array<double, kBodyColumns.size()> values{};
  for (std::size_t c = 0; c < values.size(); ++c) values[c] = kBodyColumns[c].get(body);
  return values;
}

template <typename Number>
void require_finite(const std::string& what, std::span<const Number> values, double time) {
  if (std::ranges::all_of(values, [](Number value) { return std::isfinite(value); })) return;
  throw SimulationFailure(what + " holds a value that is not finite at time " + std::to_string(time) + " s");
}

void require_finite(const Snapshot& snapshot) {
  for (const SnapshotSurface& surface : snapshot.surfaces) {
    const std::vector<Float3>& positions = surface.positions;
    if (positions.empty()) continue;
    require_finite("the surface of " + surface.body,
                   std::span<const float>(positions.front().data(), 3 * positions.size()), snapshot.time);
    for (const SnapshotField& field : surface.fields) {
      require_finite("the field " + field.name + " of " + surface.body, std::span<const float>(field.values),
                     snapshot.time);
    }
  }
  for (const SnapshotTool& tool : snapshot.tools) {
    const std::array<double, take_layout::kToolStateColumns> state = tool_state(tool);
    require_finite("the state of " + tool.name, std::span<const double>(state), snapshot.time);
  }
  for (const SnapshotScalar& scalar : snapshot.scalars) {
    require_finite(scalar.name, std::span<const double>(&scalar.value, 1), snapshot.time);
  }
}

void require_finite(const StepRecord& record) {
  for (const ToolRecord& tool : record.tools) {
    const std::array<double, kToolColumns.size()> values = tool_values(tool);
    require_finite("the record of " + tool.tool, std::span<const double>(values), record.time);
  }
  for (const BodyRecord& body : record.bodies) {
    const std::array<double, kBodyColumns.size()> values = body_values(body);
    require_finite("the record of " + body.body, std::span<const double>(values), record.time);
  }
}

bool same_topology(const SnapshotTopology& a, const SnapshotTopology& b) {
  return &a == &b || (a.rest_positions == b.rest_positions && a.triangles == b.triangles &&
                      a.cap_triangles == b.cap_triangles && a.thickness == b.thickness &&
                      a.rest_metric == b.rest_metric && a.cut_times == b.cut_times && a.is_scenery == b.is_scenery);
}

std::array<char, take_layout::kPhaseBytes> phase_bytes(const std::string& phase) {
  std::array<char, take_layout::kPhaseBytes> bytes{};
  if (phase.size() > bytes.size()) throw std::invalid_argument("the phase `" + phase + "` is longer than 16 bytes");
  std::copy(phase.begin(), phase.end(), bytes.begin());
  return bytes;
}

template <typename Columns>
std::string column_names(const Columns& columns) {
  std::string names;
  for (const auto& column : columns) names += (names.empty() ? "" : ",") + std::string(column.name);
  return names;
}

/// A stretch of steps in which a surface keeps its topology.
struct Epoch {
  std::shared_ptr<const SnapshotTopology> topology;
  RowWriter positions;
  std::vector<std::string> field_names;
  std::vector<RowWriter> fields;  // (field_names)
};

struct SurfaceWriter {
  Handle group;
  int epochs = 0;
  Epoch epoch;
};

struct PhasedWriter {
  RowWriter values;
  RowWriter phase;
};

Epoch begin_epoch(SurfaceWriter& rows, const SnapshotSurface& surface, std::size_t step) {
  const SnapshotTopology& topology = *surface.topology;
  const Handle group = hdf5::create_group(rows.group, "epoch_" + std::to_string(rows.epochs++));
  hdf5::write_attribute(group, "first_step", static_cast<std::int64_t>(step));
  if (topology.is_scenery) hdf5::write_attribute(group, "scenery", std::int64_t{1});
  const auto write = [&](const char* name, Element element, std::vector<hsize_t> shape, const void* values) {
    hdf5::write_array(group, name, element, shape, values);
  };
  write("rest_positions", Element::kFloat32, {topology.rest_positions.size(), 3}, topology.rest_positions.data());
  write("triangles", Element::kUint32, {topology.triangles.size(), 3}, topology.triangles.data());
  write("cap_triangles", Element::kUint32, {topology.cap_triangles.size(), 3}, topology.cap_triangles.data());
  write("thickness", Element::kFloat32, {topology.thickness.size()}, topology.thickness.data());
  if (!topology.rest_metric.empty()) {
    write("rest_metric", Element::kFloat32, {topology.rest_metric.size(), 3}, topology.rest_metric.data());
  }
  if (!topology.cut_times.empty()) {
    write("cut_times", Element::kFloat32, {topology.cut_times.size()}, topology.cut_times.data());
  }

  Epoch epoch{.topology = surface.topology,
              .positions = RowWriter(group, "positions", Element::kFloat32, {surface.positions.size(), 3}, 1),
              .field_names = {},
              .fields = {}};
  const Handle fields = hdf5::create_group(group, "fields");
  for (const SnapshotField& field : surface.fields) {
    epoch.field_names.push_back(field.name);
    epoch.fields.emplace_back(fields, take_layout::link_name(field.name), Element::kFloat32,
                              std::vector<hsize_t>{field.values.size()}, 1);
    const Handle& dataset = epoch.fields.back().dataset();
    hdf5::write_attribute(dataset, "name", field.name);
    hdf5::write_attribute(dataset, "unit", field.unit);
    hdf5::write_attribute(dataset, "location", field.location == FieldLocation::kVertex ? "vertex" : "triangle");
  }
  return epoch;
}

void write_surface(SurfaceWriter& rows, const SnapshotSurface& surface, std::size_t step) {
  if (surface.positions.empty() || surface.positions.size() != surface.topology->rest_positions.size()) {
    throw std::invalid_argument("the surface of " + surface.body + " does not fit its topology");
  }
  if (rows.epochs == 0 || !same_topology(*rows.epoch.topology, *surface.topology)) {
    rows.epoch = begin_epoch(rows, surface, step);
  }
  if (surface.fields.size() != rows.epoch.fields.size()) {
    throw std::invalid_argument("the surface of " + surface.body + " changed its fields");
  }
  rows.epoch.positions.append(surface.positions.data());
  for (std::size_t i = 0; i < surface.fields.size(); ++i) {
    const SnapshotField& field = surface.fields[i];
    if (field.name != rows.epoch.field_names[i]) {
      throw std::invalid_argument("the surface of " + surface.body + " changed its fields");
    }
    rows.epoch.fields[i].append(field.values.data());
  }
}

void write_timed_texts(const Handle& file, const char* name, const std::vector<TimedText>& texts) {
  const Handle group = hdf5::create_group(file, name);
  std::vector<double> spans;
  std::vector<std::string> words;
  for (const TimedText& text : texts) {
    spans.insert(spans.end(), {text.begin, text.end});
    words.push_back(text.text);
  }
  const std::array<hsize_t, 2> shape = {texts.size(), 2};
  hdf5::write_array(group, "span", Element::kFloat64, shape, spans.data());
  hdf5::write_texts(group, "text", words);
}

}  // namespace

struct TakeWriter::Implementation {
  std::filesystem::path target;
  Handle file;
  RowWriter time;
  RowWriter planned_duration;
  std::size_t steps = 0;
  std::vector<SurfaceWriter> surfaces;
  std::vector<PhasedWriter> tools;
  std::vector<RowWriter> openings;  // (tools), of forceps only
  std::vector<RowWriter> scalars;
  std::vector<PhasedWriter> tool_records;
  std::vector<RowWriter> body_records;
  std::vector<TimedText> captions;
  std::vector<TimedText> chapters;
  bool refused = false;  // whether the library could not write

  void begin(const TakeDescription& description);
  void lay_out(const Moment& first);
  void lay_out_records(const StepRecord& first);
  void append(const Moment& moment);
  void append_records(const StepRecord& record);
  void end(const TakeEnding& ending);

  template <typename Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (const hdf5::Failure& failure) {
      refused = true;
      throw PictureFailure("cannot write " + target.string() + ": " + failure.what() +
                           (failure.code() == 0 ? "" : "; " + cure_for_write_error(failure.code())));
    }
  }
};

void TakeWriter::Implementation::begin(const TakeDescription& description) {
  file = hdf5::create_file(unfinished_name(target));
  hdf5::write_attribute(file, "format", std::string(take_layout::kFormat));
  hdf5::write_attribute(file, "format_version", take_layout::kFormatVersion);
  hdf5::write_attribute(file, "program", std::string("thinwall " THINWALL_VERSION));
  hdf5::write_attribute(file, "name", description.name);
  hdf5::write_attribute(file, "title", description.title);
  hdf5::write_attribute(file, "complete", std::int64_t{0});
  hdf5::write_attribute(file, "state_digest", std::string());
  hdf5::write_text(file, "scenario", description.resolved);
  time = RowWriter(file, "time", Element::kFloat64, {}, kSmallRowsPerChunk);
  planned_duration = RowWriter(file, "planned_duration", Element::kFloat64, {}, kSmallRowsPerChunk);
}

void TakeWriter::Implementation::lay_out(const Moment& first) {
  hdf5::write_array(file, "gravity", Element::kFloat64, std::array<hsize_t, 1>{3}, first.snapshot.gravity.data());
  const Handle surface_group = hdf5::create_group(file, "surfaces");
  for (const SnapshotSurface& surface : first.snapshot.surfaces) {
    surfaces.push_back({.group = hdf5::create_group(surface_group, take_layout::link_name(surface.body)), .epoch = {}});
    hdf5::write_attribute(surfaces.back().group, "name", surface.body);
  }
  const Handle tool_group = hdf5::create_group(file, "tools");
  for (const SnapshotTool& tool : first.snapshot.tools) {
    const Handle group = hdf5::create_group(tool_group, take_layout::link_name(tool.name));
    hdf5::write_attribute(group, "name", tool.name);
    hdf5::write_attribute(group, "kind", std::string(kSnapshotToolKindNames.at(static_cast<std::size_t>(tool.kind))));
    hdf5::write_attribute(group, "radius_m", tool.radius);
    hdf5::write_attribute(group, "length_m", tool.length);
    if (take_layout::is_flat(tool.kind)) {
      hdf5::write_attribute(group, "width_m", tool.width);
      hdf5::write_attribute(group, "thickness_m", tool.thickness);
    }
    openings.push_back(tool.kind == SnapshotToolKind::kForceps
                           ? RowWriter(group, "opening", Element::kFloat64, {}, kSmallRowsPerChunk)
                           : RowWriter{});
    tools.push_back({RowWriter(group, "state", Element::kFloat64, {take_layout::kToolStateColumns}, kSmallRowsPerChunk),
                     RowWriter::of_texts(group, "phase", take_layout::kPhaseBytes, kSmallRowsPerChunk)});
  }
  const Handle scalar_group = hdf5::create_group(file, "scalars");
  for (const SnapshotScalar& scalar : first.snapshot.scalars) {
    scalars.emplace_back(scalar_group, take_layout::link_name(scalar.name), Element::kFloat64, std::vector<hsize_t>{},
                         kSmallRowsPerChunk);
    hdf5::write_attribute(scalars.back().dataset(), "name", scalar.name);
    hdf5::write_attribute(scalars.back().dataset(), "unit", scalar.unit);
  }
  lay_out_records(first.record);
}

void TakeWriter::Implementation::lay_out_records(const StepRecord& first) {
  const Handle records = hdf5::create_group(file, "records");
  const Handle tool_group = hdf5::create_group(records, "tools");
  for (const ToolRecord& tool : first.tools) {
    const Handle group = hdf5::create_group(tool_group, take_layout::link_name(tool.tool));
    hdf5::write_attribute(group, "name", tool.tool);
    hdf5::write_attribute(group, "columns", column_names(kToolColumns));
    tool_records.push_back({RowWriter(group, "values", Element::kFloat64, {kToolColumns.size()}, kSmallRowsPerChunk),
                            RowWriter::of_texts(group, "phase", take_layout::kPhaseBytes, kSmallRowsPerChunk)});
  }
  const Handle body_group = hdf5::create_group(records, "bodies");
  for (const BodyRecord& body : first.bodies) {
    const Handle group = hdf5::create_group(body_group, take_layout::link_name(body.body));
    hdf5::write_attribute(group, "name", body.body);
    hdf5::write_attribute(group, "columns", column_names(kBodyColumns));
    body_records.emplace_back(group, "values", Element::kFloat64, std::vector<hsize_t>{kBodyColumns.size()},
                              kSmallRowsPerChunk);
  }
}

void TakeWriter::Implementation::append(const Moment& moment) {
  const Snapshot& snapshot = moment.snapshot;
  require_finite(snapshot);
  require_finite(moment.record);
  if (steps == 0) lay_out(moment);
  if (snapshot.surfaces.size() != surfaces.size() || snapshot.tools.size() != tools.size() ||
      snapshot.scalars.size() != scalars.size() || moment.record.tools.size() != tool_records.size() ||
      moment.record.bodies.size() != body_records.size()) {
    throw std::invalid_argument("a step has other bodies, tools or scalars than the first");
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    write_surface(surfaces[i], snapshot.surfaces[i], steps);
  }
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const SnapshotTool& tool = snapshot.tools[i];
    tools[i].values.append(tool_state(tool).data());
    if (tool.kind == SnapshotToolKind::kForceps) openings[i].append(&tool.opening);
    tools[i].phase.append(phase_bytes(tool.phase).data());
  }
  for (std::size_t i = 0; i < scalars.size(); ++i) scalars[i].append(&snapshot.scalars[i].value);
  append_records(moment.record);
  planned_duration.append(&moment.planned_duration);
  captions = moment.captions;
  chapters = moment.chapters;
  // Last, so that the number of times is the number of steps that are there as a whole.
  time.append(&snapshot.time);
  ++steps;
  if (is_flushed_after(steps)) hdf5::flush(file);
}

void TakeWriter::Implementation::append_records(const StepRecord& record) {
  for (std::size_t i = 0; i < tool_records.size(); ++i) {
    tool_records[i].values.append(tool_values(record.tools[i]).data());
    tool_records[i].phase.append(phase_bytes(record.tools[i].phase).data());
  }
  for (std::size_t i = 0; i < body_records.size(); ++i) {
    body_records[i].append(body_values(record.bodies[i]).data());
  }
}

void TakeWriter::Implementation::end(const TakeEnding& ending) {
  if (steps == 0) lay_out(Moment{});
  write_timed_texts(file, "captions", captions);
  write_timed_texts(file, "chapters", chapters);
  hdf5::write_texts(file, "warnings", ending.warnings);
  hdf5::write_attribute(file, "state_digest", ending.state_digest);
  hdf5::write_attribute(file, "complete", std::int64_t{ending.complete ? 1 : 0});
  surfaces.clear();
  for (auto* rows : {&tools, &tool_records}) rows->clear();
  for (auto* rows : {&scalars, &body_records, &openings}) rows->clear();
  time = {};
  planned_duration = {};
  file.close();
}

TakeWriter::TakeWriter(std::filesystem::path target, const TakeDescription& description)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->target = std::move(target);
  implementation_->guarded([&] { implementation_->begin(description); });
}

TakeWriter::~TakeWriter() {
  if (!implementation_->refused && implementation_->file.id() >= 0) {
    try {
      implementation_->guarded([&] { implementation_->end({}); });
    } catch (const PictureFailure&) {
      // Whoever destroys a writer without finishing it already reports why.
    }
  }
  // HDF5 1.10 crashes when it closes a dataset that it failed to write: such a file is left open to the end of the
  // process.
  static auto* const left_open = new std::vector<std::unique_ptr<Implementation>>();
  if (implementation_->refused) left_open->push_back(std::move(implementation_));
}

void TakeWriter::write(const Moment& moment) {
  implementation_->guarded([&] { implementation_->append(moment); });
}

void TakeWriter::finish(const TakeEnding& ending) {
  implementation_->guarded([&] { implementation_->end(ending); });
  std::error_code error;
  std::filesystem::rename(unfinished_name(implementation_->target), implementation_->target, error);
  if (error) {
    throw PictureFailure("cannot write " + implementation_->target.string() + ": " + error.message() + "; " +
                         cure_for_write_error(error.value()));
  }
}

}  // namespace thinwall

#include "studio/take/TakeRows.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "studio/take/TakeLayout.hpp"

namespace thinwall {
namespace {

using hdf5::Element;
using hdf5::Handle;

std::vector<std::string> read_phases(const Handle& parent, std::size_t steps) {
  std::vector<std::string> phases = hdf5::read_text_rows(hdf5::open_dataset(parent, "phase"), take_layout::kPhaseBytes);
  require_of_take(phases.size() >= steps, "phase has fewer rows than steps");
  return phases;
}

template <typename Number>
void require_all_finite(const std::string& what, std::span<const Number> values) {
  const bool all = std::ranges::all_of(values, [](Number value) { return std::isfinite(value); });
  require_of_take(all, what + " holds a number that is not finite");
}

template <typename Row>
std::vector<Row> read_rows_of(const Handle& parent, const char* name, Element element, std::size_t row_elements) {
  const Handle dataset = hdf5::open_dataset(parent, name);
  const std::vector<hsize_t> shape = hdf5::shape_of(dataset);
  require_of_take(!shape.empty() && (shape.size() == 1 ? 1 : shape[1]) == row_elements && shape.size() <= 2,
                  std::string(name) + " has another shape than it should");
  std::vector<Row> rows(shape[0]);
  hdf5::read_rows(dataset, element, 0, shape[0], rows.data());
  if constexpr (!std::is_same_v<Row, Triangle>) require_finite(name, std::span<const Row>(rows));
  return rows;
}

double read_size(const Handle& tool, const char* name) {
  const double size = hdf5::read_real_attribute(tool, name);
  require_of_take(std::isfinite(size) && size >= 0, "a tool has no size for its " + std::string(name));
  return size;
}

std::shared_ptr<const SnapshotTopology> read_topology(const Handle& epoch) {
  auto topology = std::make_shared<SnapshotTopology>();
  topology->rest_positions = read_rows_of<Float3>(epoch, "rest_positions", Element::kFloat32, 3);
  topology->triangles = read_rows_of<Triangle>(epoch, "triangles", Element::kUint32, 3);
  topology->cap_triangles = read_rows_of<Triangle>(epoch, "cap_triangles", Element::kUint32, 3);
  topology->thickness = read_rows_of<float>(epoch, "thickness", Element::kFloat32, 1);
  if (hdf5::has_link(epoch, "rest_metric")) {
    topology->rest_metric = read_rows_of<Float3>(epoch, "rest_metric", Element::kFloat32, 3);
    require_of_take(topology->rest_metric.size() == topology->triangles.size(),
                    "rest_metric and triangles differ in number");
  }
  if (hdf5::has_link(epoch, "cut_times")) {
    topology->cut_times = read_rows_of<float>(epoch, "cut_times", Element::kFloat32, 1);
    require_of_take(topology->cut_times.size() == topology->rest_positions.size(),
                    "cut_times and vertices differ in number");
  }
  topology->is_scenery = hdf5::has_attribute(epoch, "scenery") && hdf5::read_integer_attribute(epoch, "scenery") != 0;
  for (const auto* triangles : {&topology->triangles, &topology->cap_triangles}) {
    for (const Triangle& triangle : *triangles) {
      require_of_take(*std::max_element(triangle.begin(), triangle.end()) < topology->rest_positions.size(),
                      "a triangle names a vertex that is not there");
    }
  }
  require_of_take(topology->thickness.size() == topology->triangles.size(), "thickness and triangles differ in number");
  return topology;
}

EpochRows read_epoch(const Handle& group, std::size_t steps_to_come) {
  EpochRows epoch{.first_step = static_cast<std::size_t>(hdf5::read_integer_attribute(group, "first_step")),
                  .topology = read_topology(group),
                  .positions = hdf5::open_dataset(group, "positions"),
                  .fields = {}};
  const std::vector<hsize_t> shape = hdf5::shape_of(epoch.positions);
  require_of_take(shape.size() == 3 && shape[1] == epoch.topology->rest_positions.size() && shape[2] == 3 &&
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
    require_of_take(field_shape.size() == 2 && field_shape[1] == size,
                    "the field " + layout.name + " has another shape");
    epoch.fields.push_back({.layout = std::move(layout), .size = size, .dataset = std::move(dataset)});
  }
  return epoch;
}

SnapshotToolKind tool_kind(const std::string& name) {
  const auto known = std::ranges::find(kSnapshotToolKindNames, name);
  if (known != kSnapshotToolKindNames.end()) {
    return static_cast<SnapshotToolKind>(known - kSnapshotToolKindNames.begin());
  }
  require_of_take(false, "a tool of unknown kind `" + name + "`");
  return SnapshotToolKind::kPoint;
}

}  // namespace

void require_of_take(bool condition, const std::string& complaint) {
  if (!condition) throw hdf5::Failure(complaint);
}

void require_finite(const std::string& what, std::span<const float> values) {
  require_all_finite(what, values);
}

void require_finite(const std::string& what, std::span<const double> values) {
  require_all_finite(what, values);
}

void require_finite(const std::string& what, std::span<const Float3> values) {
  for (const Float3& value : values) require_all_finite(what, std::span<const float>(value));
}

TakeTable read_table(const Handle& parent, const std::string& name, std::size_t steps, std::size_t columns) {
  const Handle dataset = hdf5::open_dataset(parent, name);
  const std::vector<hsize_t> shape = hdf5::shape_of(dataset);
  const std::size_t found = shape.size() == 1 ? 1 : shape.size() == 2 ? shape[1] : 0;
  require_of_take(found == columns && shape[0] >= steps, name + " has another shape than it should");
  TakeTable table{.columns = columns, .values = std::vector<double>(steps * columns)};
  hdf5::read_rows(dataset, Element::kFloat64, 0, steps, table.values.data());
  require_finite(name, table.values);
  return table;
}

SurfaceRows read_surface(const Handle& group, std::size_t steps) {
  SurfaceRows surface{.body = hdf5::read_text_attribute(group, "name"), .epochs = {}};
  for (const std::string& link : hdf5::link_names(group)) {
    surface.epochs.push_back(read_epoch(hdf5::open_group(group, link), steps));
  }
  require_of_take(steps == 0 || (!surface.epochs.empty() && surface.epochs.front().first_step == 0),
                  "the surface of " + surface.body + " has no topology at the first step");
  require_of_take(std::ranges::is_sorted(surface.epochs, {}, &EpochRows::first_step),
                  "the surface of " + surface.body + " changes its topology at steps that do not ascend");
  return surface;
}

ToolRows read_tool(const Handle& group, std::size_t steps) {
  ToolRows tool;
  tool.layout.name = hdf5::read_text_attribute(group, "name");
  tool.layout.kind = tool_kind(hdf5::read_text_attribute(group, "kind"));
  tool.layout.radius = read_size(group, "radius_m");
  tool.layout.length = read_size(group, "length_m");
  if (take_layout::is_flat(tool.layout.kind)) {
    tool.layout.width = read_size(group, "width_m");
    tool.layout.thickness = read_size(group, "thickness_m");
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
  const TakeTable spans = read_table(group, "span", words.size(), 2);
  std::vector<TimedText> texts;
  for (std::size_t i = 0; i < words.size(); ++i) {
    texts.push_back({.begin = spans.row(i)[0], .end = spans.row(i)[1], .text = words[i]});
  }
  return texts;
}

}  // namespace thinwall

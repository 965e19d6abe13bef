#include "studio/commands/DataViewRange.hpp"

#include <algorithm>
#include <vector>

#include "renderer/look/VertexAreas.hpp"
#include "renderer/overlay/Axis.hpp"
#include "renderer/picture/PictureFailure.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/take/TakeError.hpp"

namespace thinwall {

void require_data_range(const LookDefinition& look) {
  if (!look.data || (look.data->from && look.data->to)) return;
  throw UsageError(
      "look.data: `from` and `to` are needed here, because the range of the whole is known only at its end; give both, "
      "or "
      "leave them out and use thinwall render with the take");
}

namespace {

/// Values over these parts of the wall are left to the end colours: at the tips of cuts and under sharp tools stress
/// has no bound, and the rest would all be of one colour.
constexpr double kLowest = 0.005;
constexpr double kHighest = 0.01;

/// A number of the wall and how much of the wall it stands for. Near cuts there are many vertices on little wall.
struct WeighedValue {
  float value = 0;
  float area = 0;  // metres^2, stress-free
};

/// The value below which lies `part` of the wall.
double value_at(double part, std::vector<WeighedValue> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values, {}, &WeighedValue::value);
  double whole = 0, below = 0;
  for (const WeighedValue& value : values) whole += value.area;
  for (const WeighedValue& value : values) {
    below += value.area;
    if (below >= part * whole) return value.value;
  }
  return values.back().value;
}

/// (steps x vertices of all bodies)
std::vector<WeighedValue> all_values(const TakeReader& take, DataQuantity quantity, std::size_t steps) {
  std::vector<WeighedValue> all;
  for (std::size_t step = 0; step < steps; ++step) {
    throw_if_interrupted();
    const Moment moment = take.moment(step);
    for (const SnapshotSurface& surface : moment.snapshot.surfaces) {
      const std::vector<float> values = data_values(surface, quantity);
      const std::vector<double> areas = vertex_areas(*surface.topology);
      for (std::size_t v = 0; v < values.size(); ++v) all.push_back({values[v], static_cast<float>(areas[v])});
    }
  }
  return all;
}

/// Ends that are round numbers in the unit that the legend shows.
void round_outwards(double& from, double& to) {
  constexpr int kSteps = 5;
  if (!(to > from)) return;
  const Axis axis = enclosing_axis(from, to, kSteps);
  from = axis.lowest;
  to = axis.highest;
}

}  // namespace

void complete_data_range(const TakeReader& take, const std::filesystem::path& file, LookDefinition& look) {
  if (!look.data) return;
  DataView& data = *look.data;
  const std::size_t steps = data.from && data.to ? std::min<std::size_t>(1, take.times().size()) : take.times().size();
  std::vector<WeighedValue> values;
  try {
    values = all_values(take, data.quantity, steps);
  } catch (const PictureFailure& failure) {
    throw TakeError(file.string() + ": " + failure.what());
  }
  if (values.empty()) values.push_back({});
  const auto ends = std::ranges::minmax(values, {}, &WeighedValue::value);
  double from = data.from.value_or(value_at(kLowest, values));
  // Most of a wall is touched by nothing.
  std::erase_if(values, [](const WeighedValue& value) { return value.value == 0; });
  double to = data.to.value_or(std::max(from, value_at(1 - kHighest, values)));
  round_outwards(from, to);
  if (!data.from) {
    data.from = from;
    data.goes_on_below = ends.min.value < from;
  }
  if (!data.to) {
    data.to = to;
    data.goes_on_above = ends.max.value > to;
  }
}

}  // namespace thinwall

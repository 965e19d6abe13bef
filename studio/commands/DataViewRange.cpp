#include "studio/commands/DataViewRange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "renderer/image/PictureFailure.hpp"
#include "renderer/look/VertexAreas.hpp"
#include "renderer/overlay/Axis.hpp"
#include "studio/commands/ExitCode.hpp"
#include "studio/recorder/Interruption.hpp"
#include "studio/take/TakeError.hpp"
#include "studio/take/TakeReader.hpp"

namespace thinwall {

void require_data_range(const LookDefinition& look) {
  if (!look.data || (look.data->from && look.data->to)) return;
  throw UsageError(
      "look.data: `from` and `to` are needed here, because the range of the whole is known only at its end; give both, "
      "or leave them out and use thinwall render with the take");
}

namespace {

/// A number of the quantity in SI units, in words.
std::string in_words(double value, const DataQuantityRow& row) {
  return fmt::format("{:.4g}", value) + (row.unit.empty() ? "" : " " + std::string(row.unit));
}

double end_value(const std::string& option, const Quantity& end, const DataQuantityRow& row) {
  const Dimension wanted = row.unit.empty() ? kDimensionless : parse_unit(row.unit).dimension;
  const bool is_zero = end.value == 0 && end.dimension == kDimensionless;
  if (end.dimension == wanted || is_zero) return end.value;
  throw UsageError(fmt::format("{}: {} is {}, this is {}; write a value such as {}", option, row.word,
                               dimension_name(wanted), dimension_name(end.dimension), dimension_example(wanted)));
}

[[noreturn]] void refuse_ends(const DataView& data, double from, double to) {
  const DataQuantityRow& row = row_of(data.quantity);
  const bool lacks_to = data.from.has_value();
  throw UsageError(fmt::format(
      "data view: the colours of {} would begin at {} and end at {}, one of which is what the take's wall bears; give "
      "the {} end of the colours "
      "too, or another {}",
      row.word, in_words(from, row), in_words(to, row), lacks_to ? "upper" : "lower", lacks_to ? "lower" : "upper"));
}

/// Values over these parts of the wall are left to the end colours: at the tips of cuts and under sharp tools stress
/// has no bound, and the rest would all be of one colour.
constexpr double kLowest = 0.005;
constexpr double kHighest = 0.01;

/// And so are values farther above the upper quartile than this times the distance of the quartiles (Tukey's
/// fence): what a few triangles bear at a cut or in a thin duct must not make the rest of the wall dark. No more of the
/// wall than the second is left out by that.
constexpr double kFence = 1.5;
constexpr double kMostBeyond = 0.05;

/// A number of the wall and how much of the wall it stands for. Near cuts there are many vertices on little wall.
struct WeighedValue {
  float value = 0;
  float area = 0;        // metres^2, stress-free
  bool is_held = false;  // at its stress-free place: what is fixed of a wall under prestretch bears it for ever
};

/// The values below which lie `parts` of the wall.
template <std::size_t N>
std::array<double, N> values_at(const std::array<double, N>& parts, std::vector<WeighedValue> values) {
  std::array<double, N> found{};
  if (values.empty()) return found;
  std::ranges::sort(values, {}, &WeighedValue::value);
  double whole = 0;
  for (const WeighedValue& value : values) whole += value.area;
  for (std::size_t k = 0; k < N; ++k) {
    double below = 0;
    found[k] = values.back().value;
    for (const WeighedValue& value : values) {
      below += value.area;
      if (below < parts[k] * whole) continue;
      found[k] = value.value;
      break;
    }
  }
  return found;
}

double upper_end(std::vector<WeighedValue> values) {
  const auto [first, third, most, highest] =
      values_at<4>({0.25, 0.75, 1 - kMostBeyond, 1 - kHighest}, std::move(values));
  return std::min(highest, std::max(most, third + kFence * (third - first)));
}

/// Adds those of a take: (steps x vertices of all bodies). Of the first step alone when `is_first_enough`.
void add_values(const TakeReader& take, DataQuantity quantity, bool is_first_enough, std::vector<WeighedValue>& all) {
  const std::size_t steps = take.times().size();
  for (std::size_t step = 0; step < (is_first_enough ? std::min<std::size_t>(1, steps) : steps); ++step) {
    throw_if_interrupted();
    const Moment moment = take.moment(step);
    for (const SnapshotSurface& surface : moment.snapshot.surfaces) {
      const std::vector<float> values = data_values(surface, quantity);
      const std::vector<double> areas = vertex_areas(*surface.topology);
      for (std::size_t v = 0; v < values.size(); ++v) {
        const bool is_held = surface.positions[v] == surface.topology->rest_positions[v];
        all.push_back({values[v], static_cast<float>(areas[v]), is_held});
      }
    }
  }
}

std::vector<WeighedValue> all_values(const std::vector<std::filesystem::path>& takes, const DataView& data) {
  std::vector<WeighedValue> all;
  for (const std::filesystem::path& file : takes) {
    try {
      add_values(TakeReader(file), data.quantity, data.from && data.to, all);
    } catch (const PictureFailure& failure) {
      throw TakeError(file.string() + ": " + failure.what());
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

void change_data_view(const DataViewChanges& changes, LookDefinition& look) {
  if (!changes.from && !changes.to && !changes.scale) return;
  if (!look.data) {
    throw UsageError(
        std::string(changes.from ? "--data-from"
                    : changes.to ? "--data-to"
                                 : "--data-scale") +
        ": the pictures show no quantity in colours; name one with --data, or with --view a scenario whose "
        "`look` has `data`");
  }
  DataView& data = *look.data;
  const DataQuantityRow& row = row_of(data.quantity);
  if (changes.from) data.from = end_value("--data-from", *changes.from, row);
  if (changes.to) data.to = end_value("--data-to", *changes.to, row);
  if (changes.scale) data.scale = *changes.scale;
  if (data.from && data.to && *data.from >= *data.to) {
    throw UsageError(fmt::format("{}: the colours begin at {} and end at {}; the end must be more than the beginning",
                                 changes.to ? "--data-to" : "--data-from", in_words(*data.from, row),
                                 in_words(*data.to, row)));
  }
}

void complete_data_range(const std::vector<std::filesystem::path>& takes, LookDefinition& look) {
  if (!look.data) return;
  DataView& data = *look.data;
  std::vector<WeighedValue> values = all_values(takes, data);
  if (values.empty()) values.push_back({});
  const auto ends = std::ranges::minmax(values, {}, &WeighedValue::value);
  if (std::ranges::any_of(values, [](const WeighedValue& value) { return !value.is_held; })) {
    std::erase_if(values, [](const WeighedValue& value) { return value.is_held; });
  }
  double from = data.from.value_or(values_at<1>({kLowest}, values)[0]);
  // Most of a wall is touched by nothing.
  std::erase_if(values, [](const WeighedValue& value) { return value.value == 0; });
  double to = data.to.value_or(upper_end(values));
  if (data.from.has_value() != data.to.has_value() && from > to) refuse_ends(data, from, to);
  to = std::max(from, to);
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

#include "studio/commands/DataViewRange.hpp"

#include <algorithm>
#include <vector>

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

/// Values beyond this part are left to the end colours: at the tips of cuts and under sharp tools stress has no bound,
/// and the rest would all be of one colour.
constexpr double kOutermost = 0.01;

float value_at(double part, std::vector<float> values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

/// (steps x vertices of all bodies)
std::vector<float> all_values(const TakeReader& take, DataQuantity quantity, std::size_t steps) {
  std::vector<float> all;
  for (std::size_t step = 0; step < steps; ++step) {
    throw_if_interrupted();
    const Moment moment = take.moment(step);
    for (const SnapshotSurface& surface : moment.snapshot.surfaces) {
      const std::vector<float> values = data_values(surface, quantity);
      all.insert(all.end(), values.begin(), values.end());
    }
  }
  return all;
}

}  // namespace

void complete_data_range(const TakeReader& take, const std::filesystem::path& file, LookDefinition& look) {
  if (!look.data) return;
  DataView& data = *look.data;
  const std::size_t steps = data.from && data.to ? std::min<std::size_t>(1, take.times().size()) : take.times().size();
  std::vector<float> values;
  try {
    values = all_values(take, data.quantity, steps);
  } catch (const PictureFailure& failure) {
    throw TakeError(file.string() + ": " + failure.what());
  }
  if (!data.from) data.from = value_at(kOutermost, values);
  // Most of a wall is touched by nothing.
  std::erase(values, 0.0F);
  if (!data.to) data.to = std::max<double>(*data.from, value_at(1 - kOutermost, std::move(values)));
}

}  // namespace thinwall

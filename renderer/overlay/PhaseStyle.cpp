#include "renderer/overlay/PhaseStyle.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace thinwall {
namespace {

struct PhaseEntry {
  std::string_view phase;
  Color color;
};

constexpr Color kGrey{0.62, 0.66, 0.71};

constexpr PhaseEntry kPhases[] = {
    {"idle", kGrey},
    {"approach", {0.47, 0.67, 0.90}},
    {"contact", {0.96, 0.76, 0.36}},
    {"hold", {0.44, 0.80, 0.66}},
    {"rupture", {0.95, 0.42, 0.40}},
    {"sliding", {0.74, 0.60, 0.92}},
    {"cutting", {0.96, 0.58, 0.38}},
    {"withdrawal", {0.52, 0.76, 0.85}},
};

}  // namespace

Color phase_color(const std::string& phase) {
  const auto* entry = std::find_if(std::begin(kPhases), std::end(kPhases),
                                   [&](const PhaseEntry& candidate) { return candidate.phase == phase; });
  return entry == std::end(kPhases) ? kGrey : entry->color;
}

std::string phase_label(const std::string& phase) {
  std::string label = phase;
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

}  // namespace thinwall

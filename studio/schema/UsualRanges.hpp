#pragma once

#include <array>
#include <string_view>

#include "studio/schema/Range.hpp"

namespace thinwall {

/// What is usual of tissue, of tools and of hands. The bounds leave a factor of ten and more beyond what is met with,
/// so that what lies outside is rather a unit that has slipped.
struct UsualRange {
  std::string_view what;
  Range magnitudes;          // SI
  std::string_view example;  // in whose unit the bounds are told
};

inline constexpr UsualRange kUsualLengths{
    "thicknesses of walls, sizes and ways of tools", {.minimum = 1e-6, .maximum = 1}, "1 mm"};
inline constexpr UsualRange kUsualThicknesses{
    "thicknesses of blades, plates and jaws", {.minimum = 1e-6, .maximum = 0.1}, "1 mm"};
inline constexpr UsualRange kUsualPlaces{"places of tools and surfaces", {.minimum = 0, .maximum = 10}, "1 mm"};
inline constexpr UsualRange kUsualSpeeds{"speeds of tools", {.minimum = 1e-6, .maximum = 2}, "1 mm/s"};
inline constexpr UsualRange kUsualTimes{"times of clips", {.minimum = 1e-5, .maximum = 3600}, "1 s"};
inline constexpr UsualRange kUsualHoles{"holes between chambers", {.minimum = 1e-11, .maximum = 1e-2}, "1 mm^2"};
inline constexpr UsualRange kUsualVolumes{
    "volumes filled in or taken out", {.minimum = 1e-11, .maximum = 1e-2}, "1 ml"};
inline constexpr UsualRange kUsualDensities{"densities", {.minimum = 1e-3, .maximum = 2e4}, "1 kg/m^3"};
inline constexpr UsualRange kUsualModuli{"stiffnesses", {.minimum = 1, .maximum = 1e12}, "1 kPa"};
inline constexpr UsualRange kUsualToughness{"toughnesses", {.minimum = 1e-2, .maximum = 1e5}, "1 J/m^2"};
inline constexpr UsualRange kUsualPrestretch{"stretches by prestretch", {.minimum = 0.5, .maximum = 3}, "1"};
inline constexpr UsualRange kUsualFriction{"coefficients of friction", {.minimum = 0, .maximum = 2}, "1"};
inline constexpr UsualRange kUsualGravity{"accelerations of free fall", {.minimum = 0, .maximum = 100}, "1 m/s^2"};

/// All of them, for the reference page.
inline constexpr std::array kUsualRanges{&kUsualLengths, &kUsualThicknesses, &kUsualPlaces,     &kUsualSpeeds,
                                         &kUsualTimes,   &kUsualHoles,       &kUsualVolumes,    &kUsualDensities,
                                         &kUsualModuli,  &kUsualToughness,   &kUsualPrestretch, &kUsualFriction,
                                         &kUsualGravity};

/// What is 0 is left out on purpose, and as usual as can be.
inline bool is_usual(const UsualRange& usual, double number) {
  return number == 0 || holds(usual.magnitudes, number < 0 ? -number : number);
}

}  // namespace thinwall

#include "renderer/look/ColorMap.hpp"

#include <algorithm>
#include <array>

namespace thinwall {

Double3 color_map(double value) {
  constexpr std::array<Double3, 7> kCoefficients = {{{0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
                                                     {0.1050930431085774, 1.404613529898575, 1.384590162594685},
                                                     {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
                                                     {-4.634230498983486, -5.799100973351585, -19.33244095627987},
                                                     {6.228269936347081, 14.17993336680509, 56.69055260068105},
                                                     {4.776384997670288, -13.74514537774601, -65.35303263337234},
                                                     {-5.435455855934631, 4.645852612178535, 26.3124352495832}}};
  const double x = std::clamp(value, 0.0, 1.0);
  Double3 color{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t power = kCoefficients.size(); power-- > 0;) {
      color[channel] = color[channel] * x + kCoefficients[power][channel];
    }
    color[channel] = std::clamp(color[channel], 0.0, 1.0);
  }
  return color;
}

}  // namespace thinwall

#include "renderer/metric/FlipKernels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace thinwall {
namespace {

using std::numbers::pi;

/// a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees: the sensitivity in space, of which the frequency response is
/// Gaussian.
struct SensitivityGaussian {
  double a = 0;
  double b = 0;  // degrees^2
  double amplitude() const { return a * std::sqrt(pi / b); }
  double deviation() const { return std::sqrt(b / (2 * pi * pi)); }  // degrees
  double at(double degrees) const { return std::exp(-pi * pi * degrees * degrees / b); }
};

// Table 1 of the paper.
constexpr SensitivityGaussian kAchromatic{1, 0.0047};
constexpr SensitivityGaussian kRedGreen{1, 0.0053};
constexpr SensitivityGaussian kBlueYellow{34.1, 0.04};
constexpr SensitivityGaussian kBlueYellowNarrow{13.5, 0.025};

constexpr double kFeatureWidth = 0.082;  // degrees, of the centre of the eye's receptive field

Kernel sampled(int radius, const std::function<double(int)>& weight, double scale) {
  Kernel kernel;
  for (int k = 0; k <= radius; ++k) kernel.weights.push_back(static_cast<float>(scale * weight(k)));
  return kernel;
}

/// Over all distances of an even filter.
double sum(int radius, const std::function<double(int)>& weight) {
  double total = weight(0);
  for (int k = 1; k <= radius; ++k) total += 2 * weight(k);
  return total;
}

/// A Gaussian whose weights are below a millionth of its centre's beyond five deviations is not followed further.
Kernel sensitivity(const SensitivityGaussian& gaussian, int radius, double pixels_per_degree) {
  const auto weight = [&](int k) { return gaussian.at(k / pixels_per_degree); };
  const int needed = std::min(radius, static_cast<int>(std::ceil(5 * gaussian.deviation() * pixels_per_degree)));
  return sampled(needed, weight, 1 / sum(needed, weight));
}

/// The two Gaussians of blue against yellow: together they sum to one in the plane, where each is a product of rows and
/// columns.
void set_blue_yellow(FlipKernels& kernels, int radius, double pixels_per_degree) {
  const auto wide = [&](int k) { return kBlueYellow.at(k / pixels_per_degree); };
  const auto narrow = [&](int k) { return kBlueYellowNarrow.at(k / pixels_per_degree); };
  const double total = kBlueYellow.amplitude() * std::pow(sum(radius, wide), 2) +
                       kBlueYellowNarrow.amplitude() * std::pow(sum(radius, narrow), 2);
  kernels.blue_yellow = sampled(radius, wide, std::sqrt(kBlueYellow.amplitude() / total));
  kernels.blue_yellow_narrow = sampled(radius, narrow, std::sqrt(kBlueYellowNarrow.amplitude() / total));
}

void set_features(FlipKernels& kernels, double pixels_per_degree) {
  const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;  // pixels
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto smooth = [&](int k) { return std::exp(-0.5 * k * k / (deviation * deviation)); };
  const auto edge = [&](int k) { return k * smooth(k); };
  const auto point = [&](int k) { return (k * k / (deviation * deviation) - 1) * smooth(k); };
  // The weights of each sign sum to one, so that the answers to the strongest edge and point are one.
  double edge_sum = 0;
  double positive = 0;
  double negative = -point(0);
  for (int k = 1; k <= radius; ++k) {
    edge_sum += edge(k);
    (point(k) > 0 ? positive : negative) += 2 * std::abs(point(k));
  }
  kernels.smooth = sampled(radius, smooth, 1 / sum(radius, smooth));
  kernels.edge = sampled(radius, edge, 1 / edge_sum);
  kernels.edge.odd = true;
  kernels.point = sampled(
      radius, [&](int k) { return point(k) / (point(k) > 0 ? positive : negative); }, 1);
}

}  // namespace

FlipKernels flip_kernels(double pixels_per_degree) {
  FlipKernels kernels;
  // All sensitivities end where the widest of them has three deviations.
  const int radius = static_cast<int>(std::ceil(3 * kBlueYellow.deviation() * pixels_per_degree));
  kernels.achromatic = sensitivity(kAchromatic, radius, pixels_per_degree);
  kernels.red_green = sensitivity(kRedGreen, radius, pixels_per_degree);
  set_blue_yellow(kernels, radius, pixels_per_degree);
  set_features(kernels, pixels_per_degree);
  kernels.margin = std::max(radius, kernels.smooth.radius());
  return kernels;
}

}  // namespace thinwall

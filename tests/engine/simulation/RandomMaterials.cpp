#include "tests/engine/simulation/RandomMaterials.hpp"

#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace thinwall {

Material random_material(double shear_modulus, std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Material> possible;
  const double exponent = between(1.5, 6);
  const std::map<std::string, double, std::less<>> values = {{"shear_modulus", shear_modulus},
                                                             {"c1", 0.4 * shear_modulus},
                                                             {"c2", 0.1 * shear_modulus},
                                                             {"limit", between(5, 60)},
                                                             {"youngs_modulus", 3 * shear_modulus},
                                                             {"poisson_ratio", between(0, 0.49)},
                                                             {"c", 0.35 * shear_modulus},
                                                             {"a1", between(3, 12)},
                                                             {"a2", between(3, 12)},
                                                             {"a3", between(0, 2.5)},
                                                             {"a4", between(3, 12)},
                                                             {"k1", between(0.1, 2) * shear_modulus},
                                                             {"k2", between(0.5, 5)},
                                                             {"dispersion", between(0, 0.33)},
                                                             {"angle", between(0, 0.5 * std::numbers::pi)},
                                                             {"exponent", exponent},
                                                             {"modulus", 2 * shear_modulus / exponent}};
  for (const WallLaw& law : wall_laws()) {
    Material material{.law = &law, .parameters = {}};
    for (const LawParameter& parameter : law.parameters) {
      const auto known = values.find(parameter.name);
      if (known != values.end()) {
        material.parameters.push_back(known->second);
      } else if (parameter.fallback) {
        material.parameters.push_back(*parameter.fallback);
      }
    }
    if (material.parameters.size() == law.parameters.size()) possible.push_back(material);
  }
  const int count = static_cast<int>(possible.size());
  return possible[std::uniform_int_distribution<int>(0, count - 1)(random)];
}

}  // namespace thinwall

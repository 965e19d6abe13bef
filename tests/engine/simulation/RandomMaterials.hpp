#pragma once

#include <random>

#include "engine/body/BodyDefinition.hpp"

namespace thinwall {

/// One of the laws, as stiff as a shear modulus, pascal, all its parameters drawn where it has more.
Material random_material(double shear_modulus, std::mt19937& random);

}  // namespace thinwall

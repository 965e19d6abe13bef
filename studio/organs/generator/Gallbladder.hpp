#pragma once

#include "studio/organs/generator/OrganPlan.hpp"

namespace thinwall {

/// A filled human gallbladder with the start of its duct, lying along x: fundus at +x, about 80 mm from there to the
/// neck and 35 mm wide, neck and cystic duct bent like an S towards -x, the duct about 6 mm wide and closed at its end.
/// The origin lies in the body under its highest part. Its lower side is flattened where it rests in the liver's bed.
/// Groups: fundus, body, neck, duct, duct_end, liver_bed.
OrganPlan plan_gallbladder();

}  // namespace thinwall

#pragma once

#include "studio/organs/generator/OrganPlan.hpp"

namespace thinwall {

/// A moderately filled human stomach, J-shaped, with the last piece of the gullet and the first of the duodenum, both
/// closed at their ends. The frame is the patient's: x to the left, y to the head, z to the front, the origin in the
/// body; seen from the front the fundus is at the top right. About 200 mm high, flatter from front to back, since it
/// lies between the wall of the belly and the pancreas.
/// Groups: fundus, body, antrum, pylorus, duodenum, duodenum_end, cardia, oesophagus, oesophagus_end, and the bands
/// along which the omenta hang on, lesser_curvature and greater_curvature.
OrganPlan plan_stomach();

}  // namespace thinwall

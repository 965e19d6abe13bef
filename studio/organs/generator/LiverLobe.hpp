#pragma once

#include "studio/organs/generator/OrganPlan.hpp"

namespace thinwall {

/// The right lobe of a human liver, cut from the left one along the plane of Cantlie. The frame is the patient's: x to
/// the left, y to the head, z to the front, the origin in the middle of the lobe. The dome faces the diaphragm, to the
/// head, the right and the front; the hollow visceral surface faces down and back, with the bed of the gallbladder; the
/// two meet in the sharp inferior edge, while the back is thick and round.
/// Groups: dome, inferior_edge, visceral_surface, gallbladder_bed, and where the lobe is held: medial_face (it goes on
/// into the left lobe there) and bare_area (grown to the diaphragm).
OrganPlan plan_liver_lobe();

}  // namespace thinwall

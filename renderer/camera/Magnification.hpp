#pragma once

#include "renderer/camera/View.hpp"
#include "renderer/snapshot/MadeTopologies.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// By how much a scene is magnified before it is drawn: fluids on walls, drops and what is fine in tissue are as large
/// as on organs of some centimetres, and would cover a body of a millimetre. A power of two, 1 for scenes of more than
/// about a centimetre; told by the stress-free shapes, so it is the same throughout a take.
double magnification_of(const Snapshot& snapshot);

/// All lengths of a view times `factor`, so that the magnified scene is seen as the one that is.
ViewDefinition magnified(const ViewDefinition& view, double factor);
CameraDefinition magnified(const CameraDefinition& camera, double factor);

/// Magnifies snapshots one after the other; a topology that stays the same gives the same magnified one.
class Magnifier {
 public:
  Snapshot magnified(const Snapshot& snapshot, double factor);

 private:
  double factor_ = 1;
  MadeTopologies topologies_;
};

}  // namespace thinwall

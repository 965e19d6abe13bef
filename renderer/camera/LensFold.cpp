#include "renderer/camera/LensFold.hpp"

#include "renderer/camera/Camera.hpp"
#include "renderer/image/PictureFailure.hpp"

namespace thinwall {
namespace {

bool makes_a_whole_picture(CameraKind kind, const LensDistortion& lens, double field_of_view, ImageSize size) {
  // Where it stands does not matter.
  const CameraDefinition camera{.position = Double3{0, -1, 0},
                                .target = Double3{0, 0, 0},
                                .field_of_view = field_of_view,
                                .kind = kind,
                                .lens = lens};
  try {
    behind_the_lens(resolve_camera(camera, {}, size, 0));
    return true;
  } catch (const PictureFailure&) {
    return false;
  }
}

}  // namespace

double unfolded_field_of_view(CameraKind kind, const LensDistortion& lens, double wanted, ImageSize size) {
  if (lens == LensDistortion{} || makes_a_whole_picture(kind, lens, wanted, size)) return wanted;
  double whole = 0, folded = wanted;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (whole + folded);
    (makes_a_whole_picture(kind, lens, middle, size) ? whole : folded) = middle;
  }
  return whole;
}

}  // namespace thinwall

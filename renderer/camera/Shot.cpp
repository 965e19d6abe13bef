#include "renderer/camera/Shot.hpp"

#include "renderer/image/PictureFailure.hpp"
#include "renderer/snapshot/SameTime.hpp"

namespace thinwall {
namespace {

CameraDefinition camera_named(const ViewDefinition& view, const std::string& name) {
  if (name == "main") return view.camera;
  const auto found = view.cameras.find(name);
  if (found == view.cameras.end()) throw PictureFailure("a cut shows camera '" + name + "', which there is not");
  return found->second;
}

}  // namespace

Shot shot_at(const ViewDefinition& view, double time) {
  const CameraCut* shown = nullptr;
  for (const CameraCut& cut : view.cuts) {
    if (cut.time <= time + kSameTime) shown = &cut;
  }
  if (shown == nullptr) return {.camera = view.camera};
  Shot shot{.camera = camera_named(view, shown->camera), .corner = shown->corner.value_or(Shot{}.corner)};
  if (shown->beside) shot.beside = camera_named(view, *shown->beside);
  if (shown->inset) shot.inset = camera_named(view, *shown->inset);
  return shot;
}

}  // namespace thinwall

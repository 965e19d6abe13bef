#include "studio/recorder/ShotFollower.hpp"

#include "renderer/camera/Shot.hpp"

namespace thinwall {

ShotFollower::ShotFollower(const ViewDefinition& view) : view_(view) {
  const auto follow = [this](const CameraDefinition& camera) {
    if (!camera.follow) return;
    const auto& [tool, smoothing, travels] = *camera.follow;
    followers_.try_emplace({tool, smoothing}, tool, smoothing);
  };
  follow(view_.camera);
  for (const auto& [name, camera] : view_.cameras) follow(camera);
}

void ShotFollower::add(const Snapshot& snapshot) {
  for (auto& [key, follower] : followers_) follower.add(snapshot);
}

Shot ShotFollower::shot(const Snapshot& snapshot, double end) const {
  Shot shot = shot_at(view_, snapshot.time);
  shot.camera = as_it_is(std::move(shot.camera), snapshot, end);
  if (shot.beside) shot.beside = as_it_is(*std::move(shot.beside), snapshot, end);
  if (shot.inset) shot.inset = as_it_is(*std::move(shot.inset), snapshot, end);
  return shot;
}

CameraDefinition ShotFollower::as_it_is(CameraDefinition camera, const Snapshot& snapshot, double end) const {
  if (camera.orbit_speed != 0) camera.orbit_end = end;
  if (!camera.follow) return camera;
  camera.followed_point = followers_.at({camera.follow->tool, camera.follow->smoothing}).at(snapshot);
  return camera;
}

}  // namespace thinwall

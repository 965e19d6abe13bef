#include "studio/recorder/ShotFollower.hpp"

#include "renderer/picture/Shot.hpp"

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

Shot ShotFollower::shot(const Snapshot& snapshot) const {
  Shot shot = shot_at(view_, snapshot.time);
  shot.camera = with_subject(std::move(shot.camera), snapshot);
  if (shot.beside) shot.beside = with_subject(*std::move(shot.beside), snapshot);
  if (shot.inset) shot.inset = with_subject(*std::move(shot.inset), snapshot);
  return shot;
}

CameraDefinition ShotFollower::with_subject(CameraDefinition camera, const Snapshot& snapshot) const {
  if (!camera.follow) return camera;
  camera.followed_point = followers_.at({camera.follow->tool, camera.follow->smoothing}).at(snapshot);
  return camera;
}

}  // namespace thinwall

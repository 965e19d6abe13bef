#include "studio/haptics/PeerDevice.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace thinwall {
namespace {

/// By which axes may fail to be perpendicular units, as a driver in single precision has them.
constexpr double kAxisSlack = 1e-4;

constexpr int kPollMilliseconds = 100;

Eigen::Vector3d vector_of(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// Nothing where the numbers are no pose.
std::optional<ToolPose> pose_of(const PeerPose& packet) {
  ToolPose pose{.tip = vector_of(packet.tip),
                .direction = vector_of(packet.direction),
                .axis = vector_of(packet.axis),
                .opening = packet.opening};
  // Asked this way round, what is not a number is no pose either.
  if (!(pose.tip.norm() <= kFarthestHand) || !std::isfinite(pose.opening)) return std::nullopt;
  const double errors =
      std::abs(pose.direction.norm() - 1) + std::abs(pose.axis.norm() - 1) + std::abs(pose.direction.dot(pose.axis));
  if (!(errors <= kAxisSlack)) return std::nullopt;
  pose.direction.normalize();
  pose.axis = (pose.axis - pose.direction * pose.direction.dot(pose.axis)).normalized();
  return pose;
}

}  // namespace

struct PeerDevice::Address {
  sockaddr_un name{};
  socklen_t size = 0;
};

PeerDevice::PeerDevice(const std::filesystem::path& path) : path_(path), driver_(std::make_unique<Address>()) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  const std::string text = path.string();
  if (text.empty() || text.size() >= sizeof(name.sun_path)) {
    throw PeerError(fmt::format("`{}`: the path of a socket has 1 to {} characters", text, sizeof(name.sun_path) - 1));
  }
  if (std::filesystem::exists(path)) {
    throw PeerError(fmt::format("`{}` is there already; name a new path, or remove it if no program uses it", text));
  }
  std::memcpy(name.sun_path, text.c_str(), text.size() + 1);
  socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0 || bind(socket_, reinterpret_cast<const sockaddr*>(&name), sizeof(name)) != 0) {
    const std::string reason = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    throw PeerError(fmt::format("`{}`: no socket can be opened there: {}", text, reason));
  }
}

PeerDevice::~PeerDevice() {
  close(socket_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

bool PeerDevice::receive() {
  PeerPose packet;
  Address sender;
  sender.size = sizeof(sender.name);
  const ssize_t size = recvfrom(socket_, &packet, sizeof(packet), MSG_DONTWAIT | MSG_TRUNC,
                                reinterpret_cast<sockaddr*>(&sender.name), &sender.size);
  if (size < 0) return false;
  if (size != sizeof(packet) || packet.magic != PeerPose::kMagic) return true;
  if (packet.ends != 0) has_ended_ = true;
  if (const std::optional<ToolPose> pose = pose_of(packet)) {
    pose_ = pose;
    number_ = packet.number;
    *driver_ = sender;
  }
  return true;
}

ToolPose PeerDevice::wait_for_first_pose(double patience, const std::function<void()>& idle) {
  for (double waited = 0; !pose_; waited += 1e-3 * kPollMilliseconds) {
    if (waited > patience) {
      throw PeerError(fmt::format("`{}`: no driver has sent a pose within {:.0f} s", path_.string(), patience));
    }
    idle();
    pollfd wait{.fd = socket_, .events = POLLIN, .revents = 0};
    poll(&wait, 1, kPollMilliseconds);
    while (receive()) {
    }
  }
  return *pose_;
}

std::optional<ToolPose> PeerDevice::pose_at(double) {
  while (receive()) {
  }
  return has_ended_ ? std::nullopt : pose_;
}

void PeerDevice::feel(double time, const Eigen::Vector3d& force) {
  PeerForce packet{.number = number_, .time = time};
  for (int k = 0; k < 3; ++k) packet.force[k] = force[k];
  // A driver that is not there any more, or does not read, is no reason to stop.
  sendto(socket_, &packet, sizeof(packet), MSG_DONTWAIT | MSG_NOSIGNAL,
         reinterpret_cast<const sockaddr*>(&driver_->name), driver_->size);
}

}  // namespace thinwall

#include "studio/haptics/PeerDevice.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace thinwall {
namespace {

/// By which axes may fail to be perpendicular units, as a driver in single precision has them.
constexpr double kAxisSlack = 1e-4;

constexpr int kPollMilliseconds = 100;

Eigen::Vector3d vector_of(const double* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

constexpr const char* kWrongSize = "a datagram has come that has not the 96 bytes of a pose";
static_assert(sizeof(PeerPose) == 96);
constexpr const char* kWrongMagic = "a datagram has come that does not begin with the bytes `TWHP` of a pose";
constexpr const char* kNameless =
    "a pose has come from a socket without a name, to which no force can be sent; the driver has to bind its own";

/// Why the numbers are no pose of a hand; nullptr where they are one. Asked so that what is not a number is none
/// either.
const char* flaw_of(const PeerPose& packet) {
  const Eigen::Vector3d direction = vector_of(packet.direction), axis = vector_of(packet.axis);
  if (!(vector_of(packet.tip).norm() <= kFarthestHand)) {
    return "its tip is not finite, or farther than 10 m from the origin; poses are in metres";
  }
  if (!(packet.opening >= 0 && packet.opening <= kFarthestHand)) return "its opening is not from 0 to 10 m";
  const double errors = std::abs(direction.norm() - 1) + std::abs(axis.norm() - 1) + std::abs(direction.dot(axis));
  return errors <= kAxisSlack ? nullptr : "its direction and axis are not perpendicular units";
}

ToolPose pose_of(const PeerPose& packet) {
  ToolPose pose{.tip = vector_of(packet.tip),
                .direction = vector_of(packet.direction).normalized(),
                .axis = vector_of(packet.axis),
                .opening = packet.opening};
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
  const bool is_nameless = sender.size <= offsetof(sockaddr_un, sun_path);
  const char* misunderstood = nullptr;
  if (size != sizeof(packet)) {
    misunderstood = kWrongSize;
  } else if (packet.magic != PeerPose::kMagic) {
    misunderstood = kWrongMagic;
  } else if (is_nameless) {
    misunderstood = kNameless;
  }
  if (misunderstood != nullptr) {
    misunderstood_ = misunderstood;
    ++figures_.passed_over;
  } else {
    take(packet, sender);
  }
  return true;
}

bool PeerDevice::is_driver(const Address& sender) const {
  return sender.size == driver_->size && std::memcmp(&sender.name, &driver_->name, sender.size) == 0;
}

void PeerDevice::take(const PeerPose& packet, const Address& sender) {
  const bool has_driver = pose_.has_value() && !gone_since_;
  if (has_driver && !is_driver(sender)) {
    ++figures_.passed_over;
    return;
  }
  if (packet.ends != 0) has_ended_ = true;
  if (const char* flaw = flaw_of(packet)) {
    flaw_ = flaw;
    ++figures_.passed_over;
    return;
  }
  pose_ = pose_of(packet);
  number_ = packet.number;
  *driver_ = sender;
  gone_since_.reset();
  ++figures_.poses;
}

ToolPose PeerDevice::wait_for_first_pose(double patience, const std::function<void()>& idle) {
  // By the clock: where something comes that is no pose a poll ends at once.
  const auto begin = std::chrono::steady_clock::now();
  while (!pose_) {
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > patience) {
      throw PeerError(fmt::format("`{}`: no driver has sent a pose within {:.0f} s{}", path_.string(), patience,
                                  flaw_ != nullptr ? fmt::format("; of the last that came {}", flaw_) : ""));
    }
    idle();
    pollfd wait{.fd = socket_, .events = POLLIN, .revents = 0};
    poll(&wait, 1, kPollMilliseconds);
    while (receive()) {
    }
    if (misunderstood_ != nullptr && !pose_) {
      throw PeerError(
          fmt::format("`{}`: {}; README.md tells under \"A driver\" what a pose is", path_.string(), misunderstood_));
    }
  }
  return *pose_;
}

std::optional<ToolPose> PeerDevice::pose_at(double time) {
  const long before = figures_.poses;
  while (receive()) {
  }
  if (figures_.poses > before) last_pose_ = time;
  figures_.longest_silence = std::max(figures_.longest_silence, time - last_pose_);
  if (gone_since_ && time - *gone_since_ > kPatienceWithLost) {
    figures_.lost = *gone_since_;
    return std::nullopt;
  }
  return has_ended_ ? std::nullopt : pose_;
}

bool PeerDevice::send(const PeerForce& packet) {
  return sendto(socket_, &packet, sizeof(packet), MSG_DONTWAIT | MSG_NOSIGNAL,
                reinterpret_cast<const sockaddr*>(&driver_->name), driver_->size) == sizeof(packet);
}

void PeerDevice::feel(double time, const Eigen::Vector3d& force) {
  PeerForce packet{.number = number_, .time = time};
  for (int k = 0; k < 3; ++k) packet.force[k] = force[k];
  last_felt_ = time;
  if (send(packet)) {
    gone_since_.reset();
    return;
  }
  // One that is there and does not read keeps the loop.
  const bool is_there = errno == EAGAIN || errno == ENOBUFS;
  ++figures_.undelivered;
  if (!is_there && !gone_since_) gone_since_ = time;
}

void PeerDevice::let_go() {
  if (pose_) send({.ends = 1, .number = number_, .time = last_felt_});
}

}  // namespace thinwall

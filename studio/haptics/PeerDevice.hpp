#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

#include "engine/haptics/HapticDevice.hpp"

namespace thinwall {

/// What a driver sends: where the hand holds the tool. As it lies in memory, little-endian, without gaps.
struct PeerPose {
  static constexpr std::uint32_t kMagic = 0x50485754;  // "TWHP"
  std::uint32_t magic = kMagic;
  std::uint32_t ends = 0;  // 1: the hand has let go, the loop ends
  std::uint64_t number = 0;
  double tip[3] = {0, 0, 0};         // metres
  double direction[3] = {0, 0, -1};  // unit, z' of the tool
  double axis[3] = {0, 1, 0};        // unit, y' of the tool
  double opening = 0;                // metres, of forceps
};
static_assert(sizeof(PeerPose) == 16 + 10 * sizeof(double));

/// What it is sent back once a tick.
struct PeerForce {
  static constexpr std::uint32_t kMagic = 0x46485754;  // "TWHF"
  std::uint32_t magic = kMagic;
  std::uint32_t zero = 0;
  std::uint64_t number = 0;     // of the last pose that was received
  double time = 0;              // seconds since the loop began
  double force[3] = {0, 0, 0};  // newton, what the tissue does to the tool
};
static_assert(sizeof(PeerForce) == 16 + 4 * sizeof(double));

/// A socket that cannot be opened, or a driver that does not come.
class PeerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A driver of a real device, or of another program, on this machine: it binds a datagram socket of its own in the file
/// system, sends PeerPose to ours whenever it likes, and receives PeerForce once a tick. The latest pose counts; a pose
/// that is no pose of a hand (not finite, farther than kFarthestHand, axes that are not perpendicular units) is passed
/// over.
class PeerDevice final : public HapticDevice {
 public:
  /// Opens the socket at `path`, which must not be there. Throws PeerError.
  explicit PeerDevice(const std::filesystem::path& path);
  ~PeerDevice() override;
  PeerDevice(const PeerDevice&) = delete;
  PeerDevice& operator=(const PeerDevice&) = delete;

  /// Until the first pose has come. `idle` is called ten times a second and may throw. Throws PeerError after
  /// `patience` seconds.
  ToolPose wait_for_first_pose(double patience, const std::function<void()>& idle);

  std::optional<ToolPose> pose_at(double time) override;
  void feel(double time, const Eigen::Vector3d& force) override;

 private:
  struct Address;
  bool receive();

  std::filesystem::path path_;
  int socket_ = -1;
  std::unique_ptr<Address> driver_;
  std::optional<ToolPose> pose_;
  std::uint64_t number_ = 0;
  bool has_ended_ = false;
};

}  // namespace thinwall

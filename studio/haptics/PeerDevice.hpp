#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>

#include "engine/haptics/HapticDevice.hpp"

namespace thinwall {

/// What a driver sends: where the hand holds the tool, in the scenario's own axes (right-handed). 96 bytes as they lie
/// in memory, little-endian, without gaps.
struct PeerPose {
  static constexpr std::uint32_t kMagic = 0x50485754;  // "TWHP"
  std::uint32_t magic = kMagic;
  std::uint32_t ends = 0;            // 1: the hand has let go, the loop ends
  std::uint64_t number = 0;          // of the driver's choice, comes back with the force
  double tip[3] = {0, 0, 0};         // metres
  double direction[3] = {0, 0, -1};  // unit, z' of the tool
  double axis[3] = {0, 1, 0};        // unit, y' of the tool
  double opening = 0;                // metres, of forceps, not below 0
};
static_assert(sizeof(PeerPose) == 16 + 10 * sizeof(double));

/// What it is sent back once a tick, 48 bytes.
struct PeerForce {
  static constexpr std::uint32_t kMagic = 0x46485754;  // "TWHF"
  std::uint32_t magic = kMagic;
  std::uint32_t ends = 0;       // 1: the loop has ended, the force is zero, and nothing follows
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

/// What came of a session with a driver.
struct PeerFigures {
  long poses = 0;              // that counted
  long passed_over = 0;        // datagrams that are no pose of a hand, or came from another driver
  long undelivered = 0;        // forces that the driver was not there to take, or had no room for
  double longest_silence = 0;  // seconds without a pose
  double lost = -1;            // seconds, when the driver had gone for good; below 0: it had not
};

/// A driver of a real device, or of another program, on this machine: it binds a datagram socket of its own in the file
/// system, sends PeerPose to ours whenever it likes, and receives PeerForce once a tick. The latest pose counts, and
/// holds until the next; a pose that is no pose of a hand (not finite, farther than kFarthestHand, axes that are not
/// perpendicular units) is passed over. One driver has the loop, until its socket is no more; if no driver sends a pose
/// within kPatienceWithLost from then on the motion has ended.
class PeerDevice final : public HapticDevice {
 public:
  /// Opens the socket at `path`, which must not be there. Throws PeerError.
  explicit PeerDevice(const std::filesystem::path& path);
  ~PeerDevice() override;
  PeerDevice(const PeerDevice&) = delete;
  PeerDevice& operator=(const PeerDevice&) = delete;

  /// Until the first pose has come. `idle` is called ten times a second at least and may throw. Throws PeerError after
  /// `patience` seconds, and at once when what comes is not as PeerPose lies in memory or has no address for an answer.
  ToolPose wait_for_first_pose(double patience, const std::function<void()>& idle);

  std::optional<ToolPose> pose_at(double time) override;
  void feel(double time, const Eigen::Vector3d& force) override;
  void let_go() override;

  const PeerFigures& figures() const { return figures_; }

  /// Seconds that a driver which has gone may take to come back.
  static constexpr double kPatienceWithLost = 2;

 private:
  struct Address;
  bool receive();
  void take(const PeerPose& packet, const Address& sender);
  bool is_driver(const Address& sender) const;
  /// Whether it could be delivered.
  bool send(const PeerForce& packet);

  std::filesystem::path path_;
  int socket_ = -1;
  std::unique_ptr<Address> driver_;
  std::optional<ToolPose> pose_;
  std::uint64_t number_ = 0;
  bool has_ended_ = false;
  const char* misunderstood_ = nullptr;   // why what has come cannot be a driver's
  const char* flaw_ = nullptr;            // of the last pose that was no pose of a hand
  double last_pose_ = 0, last_felt_ = 0;  // seconds
  std::optional<double> gone_since_;      // seconds
  PeerFigures figures_;
};

}  // namespace thinwall

#include "studio/haptics/PeerDevice.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>

#include "tests/studio/TemporaryFolder.hpp"

namespace thinwall {
namespace {

sockaddr_un address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, path.c_str());
  return address;
}

/// A driver as another program would have it.
class Driver {
 public:
  Driver(const std::filesystem::path& own, const std::filesystem::path& loop) : loop_(address_of(loop)) {
    const sockaddr_un address = address_of(own);
    socket_ = socket(AF_UNIX, SOCK_DGRAM, 0);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  ~Driver() { close(socket_); }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  template <typename Packet>
  void send(const Packet& packet) {
    sendto(socket_, &packet, sizeof(packet), 0, reinterpret_cast<const sockaddr*>(&loop_), sizeof(loop_));
  }
  PeerForce receive() {
    PeerForce force;
    EXPECT_EQ(recv(socket_, &force, sizeof(force), MSG_DONTWAIT), static_cast<ssize_t>(sizeof(force)));
    return force;
  }

 private:
  sockaddr_un loop_;
  int socket_;
};

PeerPose pose_number(std::uint64_t number, double z) {
  PeerPose pose{.number = number};
  pose.tip[2] = z;
  return pose;
}

class PeerDeviceTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  PeerDevice device_{folder_ / "loop"};
  Driver driver_{folder_ / "driver", folder_ / "loop"};
};

TEST_F(PeerDeviceTest, ThePoseComesAndTheForceGoesBack) {
  driver_.send(pose_number(7, 0.02));
  EXPECT_EQ(device_.wait_for_first_pose(1, [] {}).tip.z(), 0.02);
  EXPECT_EQ(device_.pose_at(0)->tip, Eigen::Vector3d(0, 0, 0.02));
  device_.feel(0.5, {1, 2, 3});
  const PeerForce force = driver_.receive();
  EXPECT_EQ(force.magic, PeerForce::kMagic);
  EXPECT_EQ(force.number, 7U);
  EXPECT_EQ(force.time, 0.5);
  EXPECT_EQ(force.force[2], 3);
}

TEST_F(PeerDeviceTest, TheLatestPoseCountsAndStaysUntilTheNext) {
  driver_.send(pose_number(1, 0.01));
  driver_.send(pose_number(2, 0.03));
  EXPECT_EQ(device_.pose_at(0)->tip.z(), 0.03);
  EXPECT_EQ(device_.pose_at(1e-3)->tip.z(), 0.03);
}

TEST_F(PeerDeviceTest, WhatIsNoPoseIsPassedOver) {
  driver_.send(pose_number(1, 0.01));
  PeerPose bad = pose_number(2, std::nan(""));
  driver_.send(bad);
  driver_.send(pose_number(2, 1e6));
  bad = pose_number(3, 0.02);
  bad.axis[2] = 1;
  driver_.send(bad);
  bad = pose_number(4, 0.02);
  bad.magic = 0;
  driver_.send(bad);
  driver_.send(std::uint32_t{PeerPose::kMagic});
  driver_.send(std::array<double, 64>{});
  EXPECT_EQ(device_.pose_at(0)->tip.z(), 0.01);
}

TEST_F(PeerDeviceTest, TheDriverEndsTheLoop) {
  PeerPose last = pose_number(1, 0.01);
  last.ends = 1;
  driver_.send(last);
  EXPECT_FALSE(device_.pose_at(0).has_value());
}

TEST_F(PeerDeviceTest, ADriverThatDoesNotComeAndAPathThatIsTakenAreTold) {
  EXPECT_THROW(device_.wait_for_first_pose(0.15, [] {}), PeerError);
  EXPECT_THROW(PeerDevice(folder_ / "loop"), PeerError);
  EXPECT_THROW(PeerDevice(folder_ / "missing" / "loop"), PeerError);
}

}  // namespace
}  // namespace thinwall

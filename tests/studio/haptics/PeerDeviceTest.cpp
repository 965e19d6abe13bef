#include "studio/haptics/PeerDevice.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>

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
  ~Driver() { close_socket(); }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  void close_socket() {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
  }

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

TEST_F(PeerDeviceTest, IsWaitedForHoweverManyPosesThatAreNoneComeBefore) {
  int calls = 0;
  const auto send_next = [&] {
    PeerPose pose = pose_number(1, 0.02);
    if (++calls < 100) pose.direction[2] = 0;
    driver_.send(pose);
  };
  EXPECT_EQ(device_.wait_for_first_pose(5, send_next).tip.z(), 0.02);
  EXPECT_EQ(device_.figures().passed_over, 99);
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
  bad = pose_number(5, 0.02);
  bad.opening = -1;
  driver_.send(bad);
  driver_.send(std::uint32_t{PeerPose::kMagic});
  driver_.send(std::array<double, 64>{});
  EXPECT_EQ(device_.pose_at(0)->tip.z(), 0.01);
  EXPECT_EQ(device_.figures().passed_over, 7);
}

TEST_F(PeerDeviceTest, TheDriverEndsTheLoop) {
  PeerPose last = pose_number(1, 0.01);
  last.ends = 1;
  driver_.send(last);
  EXPECT_FALSE(device_.pose_at(0).has_value());
}

TEST_F(PeerDeviceTest, AnotherDriverIsPassedOverWhileTheFirstIsThere) {
  Driver other(folder_ / "other", folder_ / "loop");
  driver_.send(pose_number(1, 0.01));
  PeerPose last = pose_number(2, 0.03);
  last.ends = 1;
  other.send(last);
  ASSERT_TRUE(device_.pose_at(0).has_value());
  EXPECT_EQ(device_.pose_at(0)->tip.z(), 0.01);
  device_.feel(0, {1, 2, 3});
  EXPECT_EQ(driver_.receive().number, 1U);
  EXPECT_EQ(device_.figures().poses, 1);
  EXPECT_EQ(device_.figures().passed_over, 1);
}

TEST_F(PeerDeviceTest, ADriverThatHasGoneMayComeBackAndElseEndsTheMotion) {
  std::optional<Driver> first(std::in_place, folder_ / "first", folder_ / "loop");
  first->send(pose_number(1, 0.01));
  ASSERT_TRUE(device_.pose_at(0).has_value());
  first.reset();
  device_.feel(0.1, {1, 2, 3});
  EXPECT_EQ(device_.figures().undelivered, 1);
  EXPECT_EQ(device_.pose_at(2)->tip.z(), 0.01) << "it stays where it was";
  driver_.send(pose_number(2, 0.02));
  EXPECT_EQ(device_.pose_at(2.05)->tip.z(), 0.02);
  device_.feel(2.05, {1, 2, 3});
  EXPECT_EQ(driver_.receive().force[2], 3);
  EXPECT_TRUE(device_.pose_at(60).has_value()) << "one that is there may be silent";
  EXPECT_NEAR(device_.figures().longest_silence, 57.95, 1e-9);
  EXPECT_LT(device_.figures().lost, 0);
  driver_.close_socket();
  device_.feel(60, {1, 2, 3});
  EXPECT_TRUE(device_.pose_at(60 + 0.9 * PeerDevice::kPatienceWithLost).has_value());
  EXPECT_FALSE(device_.pose_at(60 + 1.1 * PeerDevice::kPatienceWithLost).has_value());
  EXPECT_EQ(device_.figures().lost, 60);
}

TEST_F(PeerDeviceTest, TheDriverIsToldThatTheLoopHasEnded) {
  driver_.send(pose_number(5, 0.01));
  ASSERT_TRUE(device_.pose_at(0).has_value());
  device_.feel(0.5, {1, 2, 3});
  EXPECT_EQ(driver_.receive().ends, 0U);
  device_.let_go();
  const PeerForce last = driver_.receive();
  EXPECT_EQ(last.ends, 1U);
  EXPECT_EQ(last.time, 0.5);
  for (const double part : last.force) EXPECT_EQ(part, 0);
}

TEST_F(PeerDeviceTest, ADriverThatSpeaksAnotherProtocolIsToldOfAtOnce) {
  const auto refusal_of = [&](const auto& send) {
    PeerDevice device(folder_ / "fresh");
    Driver driver(folder_ / "sender", folder_ / "fresh");
    send(driver);
    std::string said = "it was taken";
    try {
      device.wait_for_first_pose(0.3, [] {});
    } catch (const PeerError& error) {
      said = error.what();
    }
    std::filesystem::remove(folder_ / "sender");
    return said;
  };
  EXPECT_NE(refusal_of([](Driver& driver) { driver.send(std::array<double, 11>{}); }).find("96 bytes"),
            std::string::npos);
  EXPECT_NE(refusal_of([](Driver& driver) {
              PeerPose pose;
              pose.magic = PeerForce::kMagic;
              driver.send(pose);
            }).find("TWHP"),
            std::string::npos);
  // One that may only begin with a pose that is none is waited for.
  EXPECT_NE(refusal_of([](Driver& driver) { driver.send(pose_number(1, 25)); }).find("poses are in metres"),
            std::string::npos);
}

TEST_F(PeerDeviceTest, ADriverThatNoForceCanBeSentToIsTold) {
  const int nameless = socket(AF_UNIX, SOCK_DGRAM, 0);
  const sockaddr_un loop = address_of(folder_ / "loop");
  const PeerPose pose = pose_number(1, 0.01);
  sendto(nameless, &pose, sizeof(pose), 0, reinterpret_cast<const sockaddr*>(&loop), sizeof(loop));
  close(nameless);
  EXPECT_THROW(device_.wait_for_first_pose(0.3, [] {}), PeerError);
}

TEST_F(PeerDeviceTest, ADriverThatDoesNotComeAndAPathThatIsTakenAreTold) {
  EXPECT_THROW(device_.wait_for_first_pose(0.15, [] {}), PeerError);
  EXPECT_THROW(PeerDevice(folder_ / "loop"), PeerError);
  EXPECT_THROW(PeerDevice(folder_ / "missing" / "loop"), PeerError);
}

}  // namespace
}  // namespace thinwall

#include "studio/recorder/Interruption.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "engine/mesh/Shapes.hpp"
#include "engine/solver/NodeOrder.hpp"

namespace thinwall {
namespace {

sighandler_t handler_of(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler;
}

/// The signal comes when METIS has set its own handler for a terminate signal, and is at work.
void order_nodes_and_exit_as_interrupted(int signal) {
  note_interruptions();
  const SurfaceMesh mesh = make_sphere(1, 20480);
  const BlockPattern pattern = make_block_pattern(static_cast<int>(mesh.vertices.size()), mesh.triangles);
  std::thread([signal, before = handler_of(SIGTERM)] {
    while (handler_of(SIGTERM) == before) std::this_thread::yield();
    kill(getpid(), signal);
  }).detach();
  try {
    for (;;) {
      nested_dissection(pattern);
      throw_if_interrupted();
    }
  } catch (const Interrupted& interrupted) {
    std::exit(interrupted.exit_code());
  }
}

void interrupt_twice(int first, int second) {
  note_interruptions();
  kill(getpid(), first);
  EXPECT_THROW(for (;;) throw_if_interrupted(), Interrupted);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(getpid(), second);
  for (;;) pause();
}

/// As `timeout` does: to the program, and to the group that it is in.
void interrupt_twice_at_once_and_exit() {
  note_interruptions();
  kill(getpid(), SIGTERM);
  try {
    for (;;) throw_if_interrupted();
  } catch (const Interrupted& interrupted) {
    kill(getpid(), SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::exit(interrupted.exit_code());
  }
}

class InterruptionDeathTest : public ::testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(InterruptionDeathTest, IsNotedWhileMetisOrdersNodesWithAHandlerOfItsOwn) {
  EXPECT_EXIT(order_nodes_and_exit_as_interrupted(SIGTERM), ::testing::ExitedWithCode(143), "");
  EXPECT_EXIT(order_nodes_and_exit_as_interrupted(SIGINT), ::testing::ExitedWithCode(130), "");
}

TEST_F(InterruptionDeathTest, ASecondOneEndsTheProgramAtOnce) {
  EXPECT_EXIT(interrupt_twice(SIGINT, SIGINT), ::testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(interrupt_twice(SIGINT, SIGTERM), ::testing::KilledBySignal(SIGTERM), "");
}

TEST_F(InterruptionDeathTest, OneThatIsSentTwiceAtOnceIsOneWish) {
  EXPECT_EXIT(interrupt_twice_at_once_and_exit(), ::testing::ExitedWithCode(143), "");
}

}  // namespace
}  // namespace thinwall

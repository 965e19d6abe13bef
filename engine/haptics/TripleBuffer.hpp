#pragma once

#include <array>
#include <atomic>

namespace thinwall {

/// Hands values from one thread to one other without a lock: of three places one belongs to the writer, one to the
/// reader, and the third holds the latest whole value. Neither ever waits, values that nobody has read in time are
/// lost, and memory that a value holds goes to and fro with it.
template <typename Value>
class TripleBuffer {
 public:
  /// The writer's place, to be filled.
  Value& back() { return places_[back_]; }

  /// Makes what was filled the latest value.
  void publish() { back_ = latest_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kPlace; }

  /// The reader's: whether there is a value newer than the front.
  bool has_fresh() const { return (latest_.load(std::memory_order_relaxed) & kFresh) != 0; }

  /// Brings the latest value to the front; false when the front is the latest.
  bool take() {
    if (!has_fresh()) return false;
    front_ = latest_.exchange(front_, std::memory_order_acq_rel) & kPlace;
    return true;
  }

  const Value& front() const { return places_[front_]; }

 private:
  static constexpr unsigned kPlace = 3, kFresh = 4;

  std::array<Value, 3> places_ = {};
  unsigned back_ = 0;
  unsigned front_ = 1;
  std::atomic<unsigned> latest_ = 2;
};

}  // namespace thinwall

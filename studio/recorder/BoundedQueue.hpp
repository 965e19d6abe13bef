#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace thinwall {

/// Hands values from one thread to another in order; the giver waits while `capacity` of them wait, so that a fast
/// stage does not fill the memory.
template <typename Value>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// False, and the value dropped, when the queue was aborted.
  bool push(Value value) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return aborted_ || values_.size() < capacity_; });
    if (aborted_) return false;
    values_.push_back(std::move(value));
    changed_.notify_all();
    return true;
  }

  /// The next value; empty when all were taken and the queue is closed, or at once when it was aborted.
  std::optional<Value> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return aborted_ || closed_ || !values_.empty(); });
    if (aborted_ || values_.empty()) return std::nullopt;
    std::optional<Value> value(std::move(values_.front()));
    values_.pop_front();
    changed_.notify_all();
    return value;
  }

  /// No more values will come; those that wait are still given out.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  /// Wakes both sides for good.
  void abort() {
    const std::lock_guard lock(mutex_);
    aborted_ = true;
    values_.clear();
    changed_.notify_all();
  }

 private:
  std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Value> values_;
  bool closed_ = false;
  bool aborted_ = false;
};

}  // namespace thinwall

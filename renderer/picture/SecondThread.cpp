#include "renderer/picture/SecondThread.hpp"

#include <utility>

namespace thinwall {

SecondThread::SecondThread() : thread_([this] { work(); }) {}

SecondThread::~SecondThread() {
  {
    const std::lock_guard guard(lock_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void SecondThread::share(const std::function<void()>& here, const std::function<void()>& beside) {
  {
    const std::lock_guard guard(lock_);
    beside_ = &beside;
  }
  changed_.notify_all();
  std::exception_ptr failure;
  try {
    here();
  } catch (...) {
    failure = std::current_exception();
  }
  const std::exception_ptr other = wait();
  if (failure || other) std::rethrow_exception(failure ? failure : other);
}

std::exception_ptr SecondThread::wait() {
  std::unique_lock guard(lock_);
  changed_.wait(guard, [&] { return beside_ == nullptr; });
  return std::exchange(failure_, nullptr);
}

void SecondThread::work() {
  std::unique_lock guard(lock_);
  for (;;) {
    changed_.wait(guard, [&] { return beside_ != nullptr || ends_; });
    if (ends_) return;
    guard.unlock();
    std::exception_ptr failure;
    try {
      (*beside_)();
    } catch (...) {
      failure = std::current_exception();
    }
    guard.lock();
    failure_ = failure;
    beside_ = nullptr;
    changed_.notify_all();
  }
}

}  // namespace thinwall

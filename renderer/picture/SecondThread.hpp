#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace thinwall {

/// A thread that waits for work, for pieces that take less time than it takes to start one.
class SecondThread {
 public:
  SecondThread();
  ~SecondThread();
  SecondThread(const SecondThread&) = delete;
  SecondThread& operator=(const SecondThread&) = delete;

  /// Does `here` on the calling thread and `beside` on this one, and returns when both are done. Throws what `here`
  /// threw, or else what `beside` did.
  void share(const std::function<void()>& here, const std::function<void()>& beside);

 private:
  void work();
  /// Until `beside` is done; gives what it threw, or none.
  std::exception_ptr wait();

  std::mutex lock_;
  std::condition_variable changed_;
  const std::function<void()>* beside_ = nullptr;  // under way or to be done
  std::exception_ptr failure_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace thinwall

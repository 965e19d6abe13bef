#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>

namespace thinwall {

/// The line that shows how far a recording is: a bar that is drawn over and over on a terminal, a line per 10 %
/// otherwise. May be told from several threads.
class Progress {
 public:
  /// `out` is the stream that it is written to; nothing is written when it is null.
  Progress(std::FILE* out, std::string doing);

  /// `fraction` of the whole, 0 to 1; smaller ones than before are taken as no news.
  void reach(double fraction);

  /// Ends the bar's line, so that other messages start on their own.
  void end();

 private:
  std::string time_left(double fraction) const;

  std::mutex mutex_;
  std::FILE* out_;
  bool terminal_;
  std::string doing_;
  std::chrono::steady_clock::time_point start_;
  int shown_ = -1;  // per cent on a terminal, tens of per cent otherwise
  bool line_open_ = false;
};

}  // namespace thinwall

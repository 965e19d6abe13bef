#include "studio/recorder/Progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "studio/recorder/Messages.hpp"

namespace thinwall {
namespace {

constexpr int kBarWidth = 30;

}  // namespace

Progress::Progress(std::FILE* out, std::string doing)
    : out_(out),
      terminal_(out != nullptr && isatty(fileno(out)) == 1),
      doing_(std::move(doing)),
      start_(std::chrono::steady_clock::now()) {}

void Progress::reach(double fraction) {
  const std::lock_guard lock(mutex_);
  if (out_ == nullptr) return;
  const int percent = std::clamp(static_cast<int>(std::floor(100 * fraction + 1e-6)), 0, 100);
  const int step = terminal_ ? percent : percent / 10;
  if (step <= shown_) return;
  shown_ = step;
  if (terminal_) {
    const int filled = percent * kBarWidth / 100;
    print_message(out_, "\r{} [{:<{}}] {:3} % {:<16}", doing_, std::string(static_cast<std::size_t>(filled), '#'),
                  kBarWidth, percent, time_left(fraction));
    line_open_ = true;
  } else {
    print_message(out_, "{} {} %{}\n", doing_, 10 * step, time_left(fraction));
  }
  std::fflush(out_);
}

void Progress::end() {
  const std::lock_guard lock(mutex_);
  if (line_open_) print_message(out_, "\n");
  line_open_ = false;
}

std::string Progress::time_left(double fraction) const {
  if (fraction <= 0.01 || fraction >= 1) return "";
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const auto left = static_cast<int>(std::lround(spent * (1 - fraction) / fraction));
  return fmt::format(", {}:{:02} left", left / 60, left % 60);
}

}  // namespace thinwall

#include "studio/commands/StandardOutput.hpp"

#include <cerrno>
#include <cstdio>

namespace thinwall {
namespace {

int first_error = 0;  // the stream itself keeps only that there was one

void note(bool has_arrived) {
  if (!has_arrived && first_error == 0) first_error = errno != 0 ? errno : EIO;
}

}  // namespace

void say_result(std::string_view text) {
  errno = 0;
  note(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

int standard_output_error() {
  errno = 0;
  note(std::fflush(stdout) == 0 && std::ferror(stdout) == 0);
  return first_error;
}

}  // namespace thinwall

#pragma once

#include <stdexcept>

namespace thinwall {

/// A take that cannot be read: the message names the file, what is wrong with it, and the cure. Exit code 2.
class TakeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace thinwall

#pragma once

#include <stdexcept>

namespace thinwall {

/// A step that could not be saved: the message says where, when and why.
class SimulationFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace thinwall

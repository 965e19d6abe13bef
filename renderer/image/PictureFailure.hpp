#pragma once

#include <stdexcept>

namespace thinwall {

/// No picture or file could be made (driver, codec, disk): the message says why and what helps.
class PictureFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace thinwall

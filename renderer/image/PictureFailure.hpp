#pragma once

#include <stdexcept>

namespace thinwall {

/// No picture or file could be made (driver, codec, disk): the message says why and what helps.
class PictureFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file could not be written, whatever it was to hold: the disk is full, the folder is somebody else's.
class FileUnwritable : public PictureFailure {
 public:
  using PictureFailure::PictureFailure;
};

}  // namespace thinwall

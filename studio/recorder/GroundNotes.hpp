#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/camera/View.hpp"
#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// Notices pictures without the floor or drape that they ask for.
class GroundNotes {
 public:
  explicit GroundNotes(ViewDefinition view) : view_(std::move(view)) {}

  /// Of pictures that are drawn.
  void see(const Snapshot& snapshot, const Shot& shot);

  std::vector<std::string> notes() const;

 private:
  ViewDefinition view_;
  bool is_missed_ = false;
};

}  // namespace thinwall

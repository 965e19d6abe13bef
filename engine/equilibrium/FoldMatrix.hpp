#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/contact/SelfContact.hpp"
#include "engine/equilibrium/BodyModel.hpp"
#include "engine/solver/BlockPattern.hpp"
#include "engine/solver/SparseFactor.hpp"

namespace thinwall {

/// The matrix of a body whose wall touches itself: parts in contact couple vertices that the wall itself does not, so
/// that its pattern is a wider one with a factor of its own. It is analysed anew only when parts come into contact that
/// were not near when it was analysed last; without contacts it costs nothing.
class FoldMatrix {
 public:
  explicit FoldMatrix(const BodyModel& model) : model_(model) {}

  /// Makes room for the folds; true when there are any, so that the matrix must be factorised here.
  bool prepare(const SelfContactTerms& folds, const SelfContact& contact);

  /// The values of the body's own pattern with those of the folds: the exact second derivatives, or their convex part.
  std::span<const double> assemble(std::span<const double> values, const SelfContactTerms& folds, bool exact);

  SparseFactor& factor() { return *factor_; }

 private:
  bool has_room(const SelfContactTerms& folds) const;

  const BodyModel& model_;
  ExtendedPattern extended_;
  std::optional<SparseFactor> factor_;
  std::vector<double> values_;
};

/// Adds the curvature of contacts with floors, which lies in the body's own pattern.
void add_floors(const BodyModel& model, const SelfContactTerms& folds, std::span<double> values);

}  // namespace thinwall

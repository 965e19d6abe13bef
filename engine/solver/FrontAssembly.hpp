#pragma once

#include <cstddef>
#include <span>

#include "engine/solver/FrontFactor.hpp"
#include "engine/solver/SupernodeTree.hpp"

namespace thinwall {

/// Sets to zero what is read of a front, its columns and its update: the lower triangle, by kFrontRows columns and rows
/// together.
void clear(const Front<double>& front);
void clear(const Front<float>& front);

/// Adds what a front below has left, `update`, to the front that takes it up, by the runs of its rows: none of them
/// goes on past the pivots of that front.
void take_up(std::span<const RowRun> runs, const double* update, std::ptrdiff_t update_stride,
             const Front<double>& front);
void take_up(std::span<const RowRun> runs, const float* update, std::ptrdiff_t update_stride,
             const Front<float>& front);

}  // namespace thinwall

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "studio/record/Moment.hpp"

namespace thinwall {

/// What became of the main quantities of a simulation, step by step: small enough to be kept beside a golden picture,
/// in a text that shows in a review what has changed.
struct GoldenHistory {
  struct Row {
    std::size_t step = 0;
    double time = 0;             // seconds
    std::vector<double> values;  // (columns), each in the unit that its column's name ends with
  };
  std::vector<std::string> columns;  // "probe.force_N", "organ.pressure_Pa", ...
  std::vector<Row> rows;             // in order of time
};

/// Adds a step. Of each tool force and depth, of each body volume, pressure, stored and spent energy, cut and open
/// area; likewise of the take that it is compared with, in columns that begin with "second_take.".
void add_step(GoldenHistory& history, std::size_t step, const Moment& moment);

/// The history as comma-separated values with at most `kHistoryRows` rows: every k-th step, and the last one.
std::string history_text(const GoldenHistory& history);
inline constexpr std::size_t kHistoryRows = 300;

/// Throws GoldenError, naming `file`, when the text is no history.
GoldenHistory parse_history(const std::string& text, const std::string& file);

/// Numbers closer than this, relative to the largest of their column, are the same: other machines stay below it, and
/// what is written in nine digits too.
inline constexpr double kSameHistory = 1e-5;

struct HistoryChange {
  bool comparable = false;  // there is a history of the golden, of the same quantities
  bool changed = false;
  std::size_t step = 0;  // the first one that differs
  double time = 0;       // of that step, seconds
  std::string first;     // the quantity that differs most in that step
  std::string quantity;  // the one that differs most at the end; where none does there, in the step where one does most
  double before = 0;     // its value there, in the golden
  double after = 0;      // and today
  std::string sentence;  // "from step 120 on (0.6 s): contact force of probe 0.31 N instead of 0.3 N (+3.1 %) ..."
};

HistoryChange compare_histories(const GoldenHistory& golden, const GoldenHistory& today);

}  // namespace thinwall

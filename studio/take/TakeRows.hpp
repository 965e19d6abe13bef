#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"
#include "studio/record/TimedText.hpp"
#include "studio/take/Hdf5.hpp"

namespace thinwall {

/// A number per step and column, all steps at once.
struct TakeTable {
  std::size_t columns = 1;
  std::vector<double> values;  // (steps x columns)
  const double* row(std::size_t step) const { return values.data() + step * columns; }
};

/// A field of the surface between two cuts.
struct FieldRows {
  SnapshotField layout;  // without values
  std::size_t size = 0;  // vertices or triangles
  hdf5::Handle dataset;
};

/// A surface between two cuts. Its positions and fields stay in the file.
struct EpochRows {
  std::size_t first_step = 0;
  std::shared_ptr<const SnapshotTopology> topology;
  hdf5::Handle positions;
  std::vector<FieldRows> fields;
};

/// A surface in all steps, the first of its epochs from the first step on.
struct SurfaceRows {
  std::string body;
  std::vector<EpochRows> epochs;
};

/// A tool in all steps.
struct ToolRows {
  SnapshotTool layout;  // name, kind and sizes
  TakeTable state;
  TakeTable opening;  // of forceps only
  std::vector<std::string> phases;
};

/// A scalar in all steps.
struct ScalarRows {
  SnapshotScalar layout;
  TakeTable values;
};

/// What the record says of a tool or a body in all steps.
struct RecordRows {
  std::string name;
  TakeTable values;
  std::vector<std::string> phases;
};

// What a take holds of all its steps, see TakeLayout.hpp. All throw hdf5::Failure when it is not there, or of another
// shape than it should be.

/// Throws hdf5::Failure with the complaint unless the condition holds.
void require_of_take(bool condition, const std::string& complaint);

/// Throws hdf5::Failure unless all numbers are finite: a run writes no others.
void require_finite(const std::string& what, std::span<const float> values);
void require_finite(const std::string& what, std::span<const double> values);
void require_finite(const std::string& what, std::span<const Float3> values);

/// A dataset (at least `steps` x `columns`), or (at least `steps`) for one column.
TakeTable read_table(const hdf5::Handle& parent, const std::string& name, std::size_t steps, std::size_t columns);

/// `group`: /surfaces/BODY; `steps`: of the take.
SurfaceRows read_surface(const hdf5::Handle& group, std::size_t steps);

/// `group`: /tools/TOOL.
ToolRows read_tool(const hdf5::Handle& group, std::size_t steps);

/// `phased`: whether each step has a phase too.
std::vector<RecordRows> read_records(const hdf5::Handle& parent, const char* name, std::size_t steps,
                                     std::size_t columns, bool phased);

/// Empty when there are none: a run that was killed did not come to write them.
std::vector<TimedText> read_timed_texts(const hdf5::Handle& file, const char* name);

}  // namespace thinwall

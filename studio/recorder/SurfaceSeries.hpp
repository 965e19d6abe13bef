#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/snapshot/Snapshot.hpp"

namespace thinwall {

/// A surface as a VTK PolyData file (XML, appended raw little-endian data): wall triangles with their thickness at rest
/// and the snapshot's fields, named with their units.
std::string vtk_poly_data(const SnapshotSurface& surface);

/// The deforming surfaces of a recording as ParaView opens them: `surfaces/surfaces.pvd` names a file per frame and
/// body.
class SurfaceSeries {
 public:
  /// Collects in `folder`/surfaces.unfinished. Throws PictureFailure.
  explicit SurfaceSeries(const std::filesystem::path& folder);
  void write(const Snapshot& snapshot);
  /// Gives the folder its name. Throws PictureFailure.
  void finish();

 private:
  struct Entry {
    double time = 0;  // seconds
    std::size_t part = 0;
    std::string file;
  };
  std::filesystem::path target_;
  std::vector<Entry> entries_;
  std::size_t frames_ = 0;
};

}  // namespace thinwall

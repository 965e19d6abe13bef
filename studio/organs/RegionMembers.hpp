#pragma once

#include <string>
#include <vector>

#include "engine/mesh/Region.hpp"
#include "studio/scenario/InputError.hpp"

namespace thinwall {

/// Finds what lies in a body's regions and collects the mistakes in them: groups that the surface lacks, regions that
/// hold nothing. `path` is the key's path of the region, `location` where it stands.
class RegionMembers {
 public:
  explicit RegionMembers(const SurfaceMesh& mesh) : mesh_(mesh) {}

  std::vector<int> triangles(const Region& region, const std::string& path, const SourceLocation& location);
  std::vector<int> vertices(const Region& region, const std::string& path, const SourceLocation& location);
  /// Tells of a region that has vertices, but not both ends of any edge.
  void edges(const Region& region, const std::string& path, const SourceLocation& location);

  const SurfaceMesh& mesh() const { return mesh_; }
  std::vector<Diagnostic>& errors() { return errors_; }

 private:
  void check_found(const std::vector<int>& found, const char* what, const Region& region, const std::string& path,
                   const SourceLocation& location);
  bool is_known(const Region& region, const std::string& path, const SourceLocation& location);

  const SurfaceMesh& mesh_;
  std::vector<Diagnostic> errors_;
};

}  // namespace thinwall

#pragma once

#include <string>
#include <vector>

#include "engine/body/BodyDefinition.hpp"
#include "studio/organs/RegionMembers.hpp"
#include "studio/organs/TableFields.hpp"
#include "studio/scenario/Scenario.hpp"

namespace thinwall {

/// What differs from place to place of a body's wall, triangle by triangle. Mistakes go to the errors of `regions`:
/// regions that hold nothing, what TableFields refuses, directions that are zero or stand on the wall, parameters that
/// do not go together. What is read from tables is told in `notes`.
class WallFieldResolver {
 public:
  WallFieldResolver(const BodyScenario& body, RegionMembers& regions, std::vector<std::string>& notes)
      : body_(body),
        regions_(regions),
        tables_(body.surface, regions.mesh(), notes),
        path_("bodies." + body.name + ".wall") {}

  std::vector<double> thickness();        // (triangles), metres
  std::vector<double> toughness();        // none, (1) or (triangles), joule / metre^2
  std::vector<Material> materials();      // (1) when it is the same everywhere, or (triangles)
  std::vector<Eigen::Vector3d> fibres();  // none, (1) or (triangles)
  std::vector<Prestretch> prestretch();   // (1) or (triangles)

 private:
  /// The value of each triangle, and where the scenario says it.
  template <typename Value>
  struct Resolved {
    std::vector<Value> values;              // (triangles)
    std::vector<const SourceLocation*> at;  // (triangles)
  };

  template <typename Value>
  Resolved<Value> resolve(const Field<Value>& field, const std::string& path);
  /// The numbers of a table, triangle by triangle; none after a mistake.
  template <typename Value>
  void fill_from_table(const Field<Value>& field, const std::string& path, std::vector<Value>& values);

  Eigen::Vector3d corner(std::size_t triangle, int k) const;
  std::string place_of(std::size_t triangle) const;
  bool lies_in_plane(const Eigen::Vector3d& direction, std::size_t triangle) const;
  void check_materials(const std::vector<Material>& materials);

  const BodyScenario& body_;
  RegionMembers& regions_;
  TableFields tables_;
  std::string path_;  // of the wall
};

}  // namespace thinwall

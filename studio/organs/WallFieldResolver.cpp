#include "studio/organs/WallFieldResolver.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>

namespace thinwall {

template <typename Value>
WallFieldResolver::Resolved<Value> WallFieldResolver::resolve(const Field<Value>& field, const std::string& path) {
  const std::size_t triangles = regions_.mesh().triangles.size();
  Resolved<Value> result{std::vector<Value>(triangles, field.standard),
                         std::vector<const SourceLocation*>(triangles, &field.location)};
  for (std::size_t i = 0; i < field.regions.size(); ++i) {
    const FieldRegion<Value>& part = field.regions[i];
    const std::string inner = fmt::format("{}.regions[{}].in", path, i + 1);
    for (const int t : regions_.triangles(part.region, inner, part.location)) {
      result.values[t] = part.value;
      result.at[t] = &part.location;
    }
  }
  return result;
}

std::vector<double> WallFieldResolver::thickness() {
  return resolve(body_.thickness, path_ + ".thickness").values;
}

std::vector<Material> WallFieldResolver::materials() {
  if (body_.parameter_fields.empty()) return {body_.material};
  std::vector<Material> materials(regions_.mesh().triangles.size(), body_.material);
  const std::size_t known = regions_.errors().size();
  for (const ParameterField& field : body_.parameter_fields) {
    const std::vector<double> values = resolve(field.values, path_ + ".material." + field.path).values;
    for (std::size_t t = 0; t < materials.size(); ++t) materials[t].parameters[field.index] = values[t];
  }
  if (regions_.errors().size() == known) check_materials(materials);
  return materials;
}

/// Each parameter is in range, but not all go together.
void WallFieldResolver::check_materials(const std::vector<Material>& materials) {
  const auto complaint = body_.material.law->complaint;
  if (complaint == nullptr) return;
  for (std::size_t t = 0; t < materials.size(); ++t) {
    if (t > 0 && materials[t].parameters == materials[t - 1].parameters) continue;
    const std::string words = complaint(materials[t].parameters);
    if (words.empty()) continue;
    regions_.errors().push_back(
        {body_.material_location, fmt::format("{}.material: at {}: {}", path_, place_of(t), words)});
    return;
  }
}

std::vector<Eigen::Vector3d> WallFieldResolver::fibres() {
  if (!body_.fibres) return {};
  const Resolved<Eigen::Vector3d> fibres = resolve(*body_.fibres, path_ + ".fibres");
  for (std::size_t t = 0; t < fibres.values.size(); ++t) {
    if (lies_in_plane(fibres.values[t], t)) continue;
    regions_.errors().push_back(
        {*fibres.at[t], fmt::format("{}.fibres: the fibres stand perpendicular to the wall at {}; give the wall there "
                                    "a direction of its own with `regions`",
                                    path_, place_of(t))});
    break;
  }
  return is_uniform(*body_.fibres) ? std::vector{body_.fibres->standard} : fibres.values;
}

std::vector<Prestretch> WallFieldResolver::prestretch() {
  const Resolved<Prestretch> prestretch = resolve(body_.prestretch, path_ + ".prestretch");
  for (std::size_t t = 0; t < prestretch.values.size(); ++t) {
    const Prestretch& value = prestretch.values[t];
    if (value.first == value.second || lies_in_plane(value.along, t)) continue;
    regions_.errors().push_back(
        {*prestretch.at[t], fmt::format("{}.prestretch: `along` stands perpendicular to the wall at {}; give the wall "
                                        "there a direction of its own with `regions`",
                                        path_, place_of(t))});
    break;
  }
  return is_uniform(body_.prestretch) ? std::vector{body_.prestretch.standard} : prestretch.values;
}

Eigen::Vector3d WallFieldResolver::corner(std::size_t triangle, int k) const {
  return regions_.mesh().vertices[static_cast<std::size_t>(regions_.mesh().triangles[triangle][k])];
}

/// "[1, 2.5, 0] mm": the triangle's centroid.
std::string WallFieldResolver::place_of(std::size_t triangle) const {
  const Eigen::Vector3d at = 1e3 * (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3;
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}] mm", at.x() + 0.0, at.y() + 0.0, at.z() + 0.0);
}

/// Whether a direction has a part in the plane of a triangle that means something: a thousandth of it.
bool WallFieldResolver::lies_in_plane(const Eigen::Vector3d& direction, std::size_t triangle) const {
  const Eigen::Vector3d first = corner(triangle, 1) - corner(triangle, 0);
  const Eigen::Vector3d normal = first.cross(corner(triangle, 2) - corner(triangle, 0)).normalized();
  return direction.cross(normal).norm() > 1e-3 * direction.norm();
}

}  // namespace thinwall

#include "studio/organs/WallFieldResolver.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace thinwall {
namespace {

/// Of three that are the same the mean is the same to the last bit.
double mean(const std::array<double, 3>& corners) {
  if (corners[0] == corners[1] && corners[0] == corners[2]) return corners[0];
  return (corners[0] + corners[1] + corners[2]) / 3;
}

/// Fibres have no sense: each direction is turned towards the first before the mean is taken. Zero when one is.
Eigen::Vector3d mean_direction(const std::vector<CornerNumbers>& columns, std::size_t triangle) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d along(columns[0][triangle][k], columns[1][triangle][k], columns[2][triangle][k]);
    if (along.isZero(0)) return along;
    along.normalize();
    sum += along.dot(sum) < 0 ? (-along).eval() : along;
  }
  return sum.normalized();
}

/// What the columns of a table must be, and the value that they make.
double value_of(const std::vector<CornerNumbers>& columns, std::size_t triangle, const double&) {
  return mean(columns[0][triangle]);
}
Eigen::Vector3d value_of(const std::vector<CornerNumbers>& columns, std::size_t triangle, const Eigen::Vector3d&) {
  return mean_direction(columns, triangle);
}
Prestretch value_of(const std::vector<CornerNumbers>& columns, std::size_t triangle, const Prestretch&) {
  const double first = mean(columns[columns.size() == 1 ? 0 : 3][triangle]);
  if (columns.size() == 1) return {.first = first, .second = first};
  return {.along = mean_direction(columns, triangle), .first = first, .second = mean(columns[4][triangle])};
}

std::string trouble_of(const Eigen::Vector3d& direction) {
  return direction.isZero(0) ? "are zero" : "stand perpendicular to the wall";
}

/// Directions have components of any size.
std::vector<Range> ranges_of(const FieldTable& table) {
  std::vector<Range> ranges(table.columns.size(), table.range);
  if (ranges.size() >= 3) std::fill_n(ranges.begin(), 3, Range{});
  return ranges;
}

}  // namespace

template <typename Value>
void WallFieldResolver::fill_from_table(const Field<Value>& field, const std::string& path,
                                        std::vector<Value>& values) {
  try {
    const std::vector<CornerNumbers> columns =
        tables_.read(*field.table, ranges_of(*field.table), path, field.location);
    for (std::size_t t = 0; t < values.size(); ++t) values[t] = value_of(columns, t, Value());
  } catch (const InputErrors& mistakes) {
    std::vector<Diagnostic>& errors = regions_.errors();
    errors.insert(errors.end(), mistakes.diagnostics().begin(), mistakes.diagnostics().end());
    values.clear();
  }
}

template <typename Value>
WallFieldResolver::Resolved<Value> WallFieldResolver::resolve(const Field<Value>& field, const std::string& path) {
  const std::size_t triangles = regions_.mesh().triangles.size();
  Resolved<Value> result{std::vector<Value>(triangles, field.standard),
                         std::vector<const SourceLocation*>(triangles, &field.location)};
  if (field.table) fill_from_table(field, path, result.values);
  if (result.values.empty()) return result;
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

std::vector<double> WallFieldResolver::toughness() {
  if (!body_.toughness) return {};
  if (is_uniform(*body_.toughness)) return {body_.toughness->standard};
  return resolve(*body_.toughness, path_ + ".toughness").values;
}

std::vector<Material> WallFieldResolver::materials() {
  if (body_.parameter_fields.empty()) return {body_.material};
  std::vector<Material> materials(regions_.mesh().triangles.size(), body_.material);
  const std::size_t known = regions_.errors().size();
  for (const ParameterField& field : body_.parameter_fields) {
    const std::vector<double> values = resolve(field.values, path_ + ".material." + field.path).values;
    for (std::size_t t = 0; t < values.size(); ++t) materials[t].parameters[field.index] = values[t];
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
        {*fibres.at[t],
         fmt::format("{}.fibres: the fibres {} at {}; give the wall there a direction of its own{}", path_,
                     trouble_of(fibres.values[t]), place_of(t), body_.fibres->table ? "" : " with `regions`")});
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
        {*prestretch.at[t],
         fmt::format("{}.prestretch: its directions {} at {}; give the wall there a direction of its own{}", path_,
                     trouble_of(value.along), place_of(t), body_.prestretch.table ? "" : " with `regions`")});
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

#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "engine/contact/SelfContact.hpp"

namespace thinwall {

inline Eigen::VectorXd position_of(const SurfaceMesh& mesh) {
  Eigen::VectorXd position(3 * mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    position.segment<3>(3 * static_cast<int>(v)) = mesh.vertices[v];
  return position;
}

inline SelfContactTerms evaluated(SelfContact& contact, const Eigen::VectorXd& position, Eigen::VectorXd& gradient) {
  SelfContactTerms terms;
  gradient.setZero(position.size());
  contact.look(position);
  contact.evaluate(position, terms, gradient);
  return terms;
}

/// A wall and its contact with itself, which pushes with 1 kPa.
struct Wall {
  explicit Wall(SurfaceMesh the_mesh, double the_thickness = 1e-3, std::vector<FloorPlane> floors = {})
      : mesh(std::move(the_mesh)),
        rest(position_of(mesh)),
        thickness(mesh.triangles.size(), the_thickness),
        fixed(rest.size(), 0),
        contact({.triangles = mesh.triangles,
                 .position = rest,
                 .thickness = thickness,
                 .fixed = fixed,
                 .floors = std::move(floors),
                 .pressure = 1e3}) {}

  SelfContactTerms evaluate(const Eigen::VectorXd& position, Eigen::VectorXd& gradient) {
    return evaluated(contact, position, gradient);
  }

  SurfaceMesh mesh;
  Eigen::VectorXd rest;
  std::vector<double> thickness;
  std::vector<char> fixed;
  SelfContact contact;
};

}  // namespace thinwall

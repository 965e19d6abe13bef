#include "engine/simulation/PartedContents.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/fluid/EnclosedVolume.hpp"
#include "engine/fluid/LipCap.hpp"
#include "engine/mesh/MeshTopology.hpp"
#include "engine/simulation/CutTransfer.hpp"

namespace thinwall {
namespace {

/// Area of wall and caps over that of the openings from which on a part is a bowl.
constexpr double kBowl = 1.5;

/// Volume over the rest volume that counts as none.
constexpr double kNoVolume = 1e-10;

/// A part of wall and caps after a cut.
struct Part {
  int first_triangle = -1;
  int before = -1;  // chamber that its wall belonged to
  double volume = 0, area = 0, open_area = 0;
  std::vector<int> loops;  // into the pieces's

  bool is_bowl() const { return area >= kBowl * open_area; }
};

/// The chamber before a cut that a triangle's place belonged to.
class ChamberBefore {
 public:
  ChamberBefore(const BodyModel& before, const Cut& cut) : before_(before) {
    for (const TriangleSource& source : cut.triangles) sources_[source.triangle] = main_source(source);
  }
  int of(int triangle) const {
    const auto found = sources_.find(triangle);
    return before_.chamber[found == sources_.end() ? triangle : found->second];
  }

 private:
  const BodyModel& before_;
  std::map<int, int> sources_;
};

std::vector<Part> parts_of(const SurfaceMesh& mesh, const std::vector<Eigen::Vector3i>& surface,
                           const MeshPieces& pieces, const ChamberBefore& chamber_before) {
  std::vector<Part> parts(static_cast<std::size_t>(pieces.component_count));
  std::vector<int> part_of_vertex(mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < surface.size(); ++t) {
    Part& part = parts[pieces.triangle_component[t]];
    const auto triangle = static_cast<int>(t);
    if (part.first_triangle < 0 && t < mesh.triangles.size()) {
      part.first_triangle = triangle;
      part.before = chamber_before.of(triangle);
    }
    const std::array<Eigen::Vector3d, 3> corners = {mesh.vertices[surface[t][0]], mesh.vertices[surface[t][1]],
                                                    mesh.vertices[surface[t][2]]};
    part.volume += volume_of(corners);
    part.area += 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    for (const int vertex : surface[t]) part_of_vertex[vertex] = pieces.triangle_component[t];
  }
  for (std::size_t k = 0; k < pieces.boundary_loops.size(); ++k) {
    const std::vector<int>& loop = pieces.boundary_loops[k];
    Part& part = parts[part_of_vertex[loop.front()]];
    Eigen::Matrix3Xd lips(3, loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) lips.col(static_cast<Eigen::Index>(i)) = mesh.vertices[loop[i]];
    const LipCap cap = lip_cap_of(lips);
    part.volume += cap.volume;
    part.open_area += cap.area.norm();
    part.loops.push_back(static_cast<int>(k));
  }
  return parts;
}

/// The part that keeps each chamber.
std::vector<int> keepers(const std::vector<Part>& parts, std::size_t chambers) {
  std::vector<int> keeper(chambers, -1);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].before < 0) continue;
    int& best = keeper[parts[k].before];
    if (best < 0 || parts[k].volume > parts[best].volume) best = static_cast<int>(k);
  }
  return keeper;
}

PressureField field_of(const BodyModel& model, int chamber, double pressure, const Eigen::Vector3d& gravity) {
  PressureField field{.slope = model.definition.fluid.density * gravity, .suction = false};
  field.at_origin = pressure - field.slope.dot(model.chambers[chamber].level);
  return field;
}

/// Volume below the free surface that the pressure tells, by Archimedes' principle, metres^3. `field`: of the
/// weight.
double volume_below_surface(const BodyModel& model, const Eigen::VectorXd& position, int chamber,
                            const PressureField& field) {
  Eigen::Vector3d load = Eigen::Vector3d::Zero();
  double share = 1;  // of the triangle that is added
  const auto add = [&](const std::array<Eigen::Vector3d, 3>& corners) -> Eigen::Matrix<double, 9, 1> {
    Eigen::Matrix<double, 9, 1> part = pressure_load_of(corners, field);
    for (int k = 0; k < 3; ++k) load += share * part.segment<3>(3 * k);
    return part;
  };
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    share = model.share[t];
    if (model.chamber[t] == chamber) add(corners_of(model.surface[t], position));
  }
  share = 1;
  for (const OpeningModel& opening : model.openings) {
    if (opening.chamber == chamber) lip_sum_of(opening.at(position), add);
  }
  return std::max(0.0, load.dot(field.slope) / field.slope.squaredNorm());
}

/// A chamber after a cut and what it comes from.
struct Heir {
  int before = -1;
  double pressure = 0;  // pascal, at its own level
  double volume = 0;    // metres^3
  double weight = 0;    // metres^3, by which fluid is shared out
};

std::vector<Heir> heirs_of(const BodyModel& before, const BodyState& state, const BodyModel& after, const Cut& cut,
                           const Eigen::Vector3d& gravity, const Eigen::VectorXd& position) {
  const ChamberBefore chamber_before(before, cut);
  const Eigen::VectorXd volumes = enclosed_volumes(after, position);
  std::vector<Heir> heirs(after.chambers.size());
  for (int c = 0; c < static_cast<int>(heirs.size()); ++c) {
    Heir& heir = heirs[c];
    heir.before = chamber_before.of(*after.definition.fluid.chambers[c].wall);
    const Eigen::Vector3d lift = after.chambers[c].level - before.chambers[heir.before].level;
    heir.pressure = state.equilibrium.pressure[heir.before] + after.definition.fluid.density * gravity.dot(lift);
    heir.volume = heir.weight = volumes[c];
    if (state.air[heir.before] > 0 && !gravity.isZero()) {
      heir.weight = volume_below_surface(after, position, c, field_of(after, c, heir.pressure, gravity));
    }
    heir.weight = std::max(0.0, heir.weight);
  }
  return heirs;
}

/// Space that the fluid of a chamber fills over its volume at the reference pressure.
double expansion(const BodyModel& model, const BodyState& state, int chamber, bool has_air) {
  if (model.definition.fluid.kind != FluidKind::kCompressible) return 1;
  const double at = state.equilibrium.pressure[chamber], pressure = has_air ? bulk_pressure_beside_air(at) : at;
  return 1 - (pressure - state.reference_pressure[chamber]) / model.definition.fluid.bulk_modulus;
}

/// Lets what finds no room flow out.
void spill(const BodyModel& after, int chamber, bool had_air, const Eigen::Vector3d& gravity, BodyState& carried) {
  const double held = expansion(after, carried, chamber, had_air);
  const double room = std::max(0.0, carried.volume[chamber] / held);
  const double excess = carried.fluid_volume[chamber] - room;
  const bool leaks = may_leak(after, chamber);
  if (leaks && excess > kNoVolume * std::abs(after.chambers[chamber].rest_volume)) {
    carried.fluid_volume[chamber] = room;
    carried.leaked[chamber] += excess;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    int openings = 0;
    for (const OpeningModel& opening : after.openings) {
      if (opening.chamber != chamber) continue;
      center += opening.at(carried.equilibrium.position).rowwise().mean();
      ++openings;
    }
    carried.leaked_gravity -= after.definition.fluid.density * excess * gravity.dot(center / openings);
  }
  carried.air[chamber] = had_air ? std::max(0.0, carried.volume[chamber] - held * carried.fluid_volume[chamber]) : 0;
}

/// The fluid moves as before; what it encloses has other moments.
void carry_motion(const BodyModel& before, const BodyState& state, const BodyModel& after,
                  const std::vector<Heir>& heirs, BodyState& carried) {
  if (state.fluid_motion.empty()) return;
  const Eigen::Matrix3Xd moments = first_moments(after, carried.equilibrium.position);
  carried.fluid_motion.assign(heirs.size(), {});
  for (std::size_t c = 0; c < heirs.size(); ++c) {
    const FluidMotion& old = state.fluid_motion[heirs[c].before];
    const bool is_alone = std::ranges::count(heirs, heirs[c].before, &Heir::before) == 1;
    const double share = is_alone || old.volume <= 0 ? 1 : heirs[c].volume / old.volume;
    FluidMotion& motion = carried.fluid_motion[c];
    motion.moment = moments.col(static_cast<Eigen::Index>(c));
    motion.volume = heirs[c].volume;
    motion.velocity = share * old.velocity;
    motion.acceleration = share * old.acceleration;
    motion.previous_velocity = share * old.previous_velocity;
    motion.previous_moment = old.previous_moment + motion.moment - old.moment;
    motion.previous_volume = old.previous_volume + motion.volume - old.volume;
  }
  // Differences do not reach back across a change of what hangs together.
  if (after.chambers.size() != before.chambers.size()) carried.previous_step = 0;
}

}  // namespace

PartedContents parted_contents(const BodyModel& before, const SurfaceMesh& mesh, const Cut& cut) {
  const std::vector<Eigen::Vector3i> surface = closed_surface(mesh);
  const MeshPieces pieces = pieces_of(static_cast<int>(mesh.vertices.size()), surface);
  const std::vector<Part> parts = parts_of(mesh, surface, pieces, ChamberBefore(before, cut));
  std::vector<int> holders = keepers(parts, before.chambers.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const int chamber = parts[k].before;
    if (chamber >= 0 && holders[chamber] != static_cast<int>(k) && parts[k].is_bowl()) {
      holders.push_back(static_cast<int>(k));
    }
  }
  PartedContents contents;
  for (std::size_t c = 0; c < holders.size(); ++c) {
    const Part& part = parts[holders[c]];
    ChamberDefinition chamber{.wall = part.first_triangle};
    chamber.initial_pressure = before.chambers[part.before].initial_pressure;
    if (c < before.chambers.size()) chamber.name = before.chambers[c].name;
    contents.chambers.push_back(chamber);
    for (const int loop : part.loops) contents.openings.push_back({.lips = pieces.boundary_loops[loop]});
  }
  return contents;
}

void carry_contents(const BodyModel& before, const BodyState& state, const BodyModel& after, const Cut& cut,
                    const Eigen::Vector3d& gravity, BodyState& carried) {
  if (!after.has_fluid()) return;
  std::vector<Heir> heirs = heirs_of(before, state, after, cut, gravity, carried.equilibrium.position);
  std::vector<double> whole(before.chambers.size(), 0);
  for (const Heir& heir : heirs) whole[heir.before] += heir.weight;
  const auto count = static_cast<Eigen::Index>(heirs.size());
  for (Eigen::VectorXd BodyState::*values : {&BodyState::volume, &BodyState::fluid_volume, &BodyState::leaked,
                                             &BodyState::air, &BodyState::reference_pressure}) {
    carried.*values = Eigen::VectorXd::Zero(count);
  }
  carried.equilibrium.pressure = Eigen::VectorXd::Zero(count);
  for (Eigen::Index c = 0; c < count; ++c) {
    Heir& heir = heirs[c];
    const bool keeps = c < state.leaked.size();
    // Where no part has room for the fluid, it stays in the one that keeps the chamber.
    const double undivided = keeps ? 1 : 0;
    const double share = whole[heir.before] > 0 ? heir.weight / whole[heir.before] : undivided;
    // What does not run out keeps its volume, whatever cap spans the lips from now on.
    if (!after.definition.fluid.leaks) heir.volume = share * state.volume[heir.before];
    carried.volume[c] = heir.volume;
    carried.equilibrium.pressure[c] = heir.pressure;
    // At another level the fluid is as dense as before.
    const double at = state.equilibrium.pressure[heir.before];
    const bool has_air = state.air[heir.before] > 0;
    carried.reference_pressure[c] =
        state.reference_pressure[heir.before] +
        (has_air ? bulk_pressure_beside_air(heir.pressure) - bulk_pressure_beside_air(at) : heir.pressure - at);
    carried.fluid_volume[c] = share * state.fluid_volume[heir.before];
    carried.leaked[c] = keeps ? state.leaked[c] : 0;
    spill(after, static_cast<int>(c), state.air[heir.before] > 0, gravity, carried);
  }
  carry_motion(before, state, after, heirs, carried);
}

}  // namespace thinwall

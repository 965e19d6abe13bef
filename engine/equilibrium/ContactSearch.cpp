#include "engine/equilibrium/ContactSearch.hpp"

#include <algorithm>
#include <limits>

namespace thinwall {
namespace {

/// Part of an edge beyond the range of a contact within which a triangle is kept in view: a step may overrun it.
constexpr double kContactMargin = 0.5;

/// Edges beyond that within which the distances of vertices from a solid are found exactly.
constexpr double kFarAway = 4;

double square(double value) {
  return value * value;
}

/// Metres, within which sites are near a solid.
double nearness(const BodyModel& model, const SolidContact& contact) {
  return contact.reach() + kContactMargin * model.edge_length;
}

/// Metres, from the solid: exact near it. Far away the distance from a ball around it says enough, and is quicker
/// found.
double distance_of(const SolidContact& contact, const Eigen::Vector3d& place, double exact_within) {
  const double bound = (place - contact.solid.center).norm() - contact.solid.extent();
  return bound > exact_within ? bound : distance_from(contact.solid, place);
}

/// Whether a site is farther from a solid than `reach`, metres, as the distances of the triangle's corners alone show:
/// no distance changes faster than its place. Without a root, because it is asked of every site again and again.
bool is_clearly_apart(const Eigen::VectorXd& position, const Eigen::Vector3i& triangle,
                      const std::vector<double>& distances, const ContactSite& site, double reach) {
  const int a = triangle[site.corner], b = triangle[(site.corner + 1) % 3], c = triangle[(site.corner + 2) % 3];
  const double from_a = distances[a] - reach;
  if (site.part == SitePart::kCorner) return from_a >= 0;
  const auto edge = [&](int one, int other) {
    return (position.segment<3>(3 * one) - position.segment<3>(3 * other)).squaredNorm();
  };
  const double from_b = distances[b] - reach, ab = edge(a, b);
  if (site.part == SitePart::kEdge) return from_a + from_b >= 0 && square(from_a + from_b) >= ab;
  const double from_c = distances[c] - reach, ac = edge(a, c), bc = edge(b, c);
  return (from_a >= 0 && square(from_a) >= std::max(ab, ac)) || (from_b >= 0 && square(from_b) >= std::max(ab, bc)) ||
         (from_c >= 0 && square(from_c) >= std::max(ac, bc));
}

/// Whether all parts of a triangle are, which is asked of each once: it has several sites.
bool is_clearly_apart(const Eigen::VectorXd& position, const Eigen::Vector3i& triangle,
                      const std::vector<double>& distances, double reach) {
  const auto [a, b, c] = corners_of(triangle, position);
  const double nearest = std::min({distances[triangle[0]], distances[triangle[1]], distances[triangle[2]]}) - reach;
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return nearest >= 0 && square(nearest) >= longest;
}

/// What of a wall is near a body or hull. Its rims and corners lie within it, so that nothing else is near these:
/// forceps have forty of them, and each would look at the whole wall.
struct Surroundings {
  std::vector<double> distances;  // (vertices), metres, from the solid that was measured last
  std::vector<char> are_apart;    // (triangles), whether they are farther than anything of the hull is felt
  std::vector<int> vertices;      // of the other triangles, ascending
  std::vector<int> sites;         // of the other triangles, ascending
  std::vector<char> is_near;      // (vertices)
};

/// Those of solid `hull` and of its parts, which follow it.
void look_around(const BodyModel& model, const EquilibriumProblem& problem, std::size_t hull,
                 const Eigen::VectorXd& position, Surroundings& around) {
  double near = nearness(model, problem.solids[hull]);
  for (std::size_t k = hull + 1; k < problem.solids.size() && problem.solids[k].solid.is_part(); ++k) {
    near = std::max(near, nearness(model, problem.solids[k]));
  }
  around.distances.resize(model.vertices());
  for (int v = 0; v < model.vertices(); ++v) {
    around.distances[v] =
        distance_of(problem.solids[hull], position.segment<3>(3 * v), near + kFarAway * model.edge_length);
  }
  around.are_apart.resize(model.surface.size());
  around.is_near.assign(model.vertices(), 0);
  for (std::size_t t = 0; t < model.surface.size(); ++t) {
    const Eigen::Vector3i& triangle = model.surface[t];
    around.are_apart[t] = is_clearly_apart(position, triangle, around.distances, near);
    if (around.are_apart[t]) continue;
    for (const int vertex : triangle) around.is_near[vertex] = 1;
  }
  around.vertices.clear();
  for (int v = 0; v < model.vertices(); ++v) {
    if (around.is_near[v]) around.vertices.push_back(v);
  }
  around.sites.clear();
  for (std::size_t s = 0; s < model.sites.size(); ++s) {
    if (!around.are_apart[model.sites[s].triangle]) around.sites.push_back(static_cast<int>(s));
  }
}

/// Whether the solid presses on a site that is not near its hull any more, as where a tool has been set back.
bool presses_far_away(const BodyModel& model, const SolidContact& contact, const Surroundings& around) {
  for (std::size_t s = 0; s < contact.forces.size(); ++s) {
    if (contact.forces[s] > 0 && around.are_apart[model.sites[s].triangle]) return true;
  }
  return false;
}

/// `near`: metres, of solid `solid`.
void add_if_met(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position, int solid,
                double near, int s, const std::vector<double>& distances, EquilibriumTerms& terms) {
  const SolidContact& contact = problem.solids[solid];
  const ContactSite& site = model.sites[s];
  if (!contact.meets(site.part) || problem.is_free(contact.tool, site.triangle)) return;
  if (problem.passes(contact.tool, s)) return;
  const Eigen::Vector3i& triangle = model.surface[site.triangle];
  const double reach = contact.forces[s] > 0 ? std::numeric_limits<double>::infinity() : near;
  if (is_clearly_apart(position, triangle, distances, site, reach)) return;
  const auto gap = contact.gap(s, site, contact.solid, reach, corners_of(triangle, position),
                               contact.forces[s] != 0 ? GapTerms::kHessian : GapTerms::kGradient);
  // The gap of a site whose deepest point lies on its border is that of another site.
  if (!gap || (gap->part != site.part && contact.forces[s] == 0)) return;
  terms.contacts.push_back(
      {.solid = solid, .site = s, .triangle = site.triangle, .potential = contact.potential(s, site), .gap = *gap});
}

}  // namespace

void find_contacts(const BodyModel& model, const EquilibriumProblem& problem, const Eigen::VectorXd& position,
                   EquilibriumTerms& terms) {
  thread_local Surroundings around;
  for (std::size_t k = 0; k < problem.solids.size(); ++k) {
    const SolidContact& contact = problem.solids[k];
    // All parts of a tool are in the wall, or none.
    if (contact.in_wall) continue;
    if (!contact.solid.is_part()) look_around(model, problem, k, position, around);
    const double near = nearness(model, contact);
    const auto measure = [&](int vertex) {
      const double exact_within = near + kFarAway * model.edge_length;
      around.distances[vertex] = distance_of(contact, position.segment<3>(3 * vertex), exact_within);
    };
    const auto add = [&](int site) {
      add_if_met(model, problem, position, static_cast<int>(k), near, site, around.distances, terms);
    };
    if (presses_far_away(model, contact, around)) {
      for (int vertex = 0; vertex < model.vertices(); ++vertex) measure(vertex);
      for (int site = 0; site < static_cast<int>(model.sites.size()); ++site) add(site);
    } else {
      if (contact.solid.is_part()) std::ranges::for_each(around.vertices, measure);
      std::ranges::for_each(around.sites, add);
    }
  }
}

}  // namespace thinwall

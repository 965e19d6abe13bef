#include "engine/cutting/PathSnapping.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace thinwall {
namespace {

constexpr int kBetween = 1000;           // choices from here on are nodes between a stop and the next one
constexpr double kFarthestInward = 0.6;  // edge lengths, by which a beginning or end is moved along the path
constexpr double kFarthestEnd = 0.2;     // edge lengths, by which an end that goes on is moved off the path
constexpr double kRefused = 1e6, kTooSharp = 100, kTooShort = 50;  // penalties

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double scale_in(const CutPatch& patch, int facet, const Eigen::Vector3d& position) {
  return patch.scale[patch.locate(facet, position).first];
}

/// An edge that stays, and its point nearest to a place.
struct NearestSide {
  PatchPlace place;
  double distance = std::numeric_limits<double>::infinity();
  bool border = false;
};

NearestSide nearest_side(const CutPatch& patch, int facet, const Eigen::Vector3d& position) {
  NearestSide nearest;
  for (int t = 0; t < patch.triangle_count(); ++t) {
    if (patch.facet[t] != facet) continue;
    for (int k = 0; k < 3; ++k) {
      if (!patch.is_crease(t, k)) continue;
      const int from = patch.triangles[t][k], to = patch.triangles[t][(k + 1) % 3];
      const Eigen::Vector3d edge = patch.positions[to] - patch.positions[from];
      const double along = std::clamp((position - patch.positions[from]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      const Eigen::Vector3d point = patch.positions[from] + along * edge;
      if ((point - position).norm() >= nearest.distance) continue;
      nearest.distance = (point - position).norm();
      nearest.border = patch.neighbours[t][k] < 0;
      nearest.place = {.kind = PlaceKind::kSide, .from = from, .to = to, .along = along, .position = point};
    }
  }
  return nearest;
}

// ---- Nodes within a facet

/// Douglas and Peucker: corners without which the polyline would be off by more than `tolerance`.
void keep_corners(std::span<const Eigen::Vector3d> line, double tolerance, std::vector<char>& kept, int begin,
                  int end) {
  double farthest = tolerance;
  int corner = -1;
  const std::array<Eigen::Vector3d, 2> chord = {line[begin], line[end]};
  for (int i = begin + 1; i < end; ++i) {
    const double distance = distance_to(chord, line[i]);
    if (distance <= farthest) continue;
    farthest = distance;
    corner = i;
  }
  if (corner < 0) return;
  kept[corner] = 1;
  keep_corners(line, tolerance, kept, begin, corner);
  keep_corners(line, tolerance, kept, corner, end);
}

std::vector<Eigen::Vector3d> evenly_spaced(std::span<const Eigen::Vector3d> line, double scale, int least_pieces) {
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  keep_corners(line, 0.06 * scale, kept, 0, static_cast<int>(line.size()) - 1);
  std::vector<Eigen::Vector3d> nodes = {line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (!kept[i]) continue;
    const Eigen::Vector3d begin = nodes.back();
    const double length = (line[i] - begin).norm();
    const int pieces = std::max(least_pieces, static_cast<int>(std::ceil(length / (1.25 * scale))));
    for (int piece = 1; piece <= pieces; ++piece) nodes.push_back(begin + double(piece) / pieces * (line[i] - begin));
  }
  return nodes;
}

/// The path from a stop to the next one.
std::vector<Eigen::Vector3d> line_after(std::span<const PathStop> stops, int index) {
  std::vector<Eigen::Vector3d> line = {stops[index].place.position};
  line.insert(line.end(), stops[index].between.begin(), stops[index].between.end());
  if (index + 1 < static_cast<int>(stops.size())) line.push_back(stops[index + 1].place.position);
  return line;
}

struct NodeBetween {
  int choice = 0;
  PatchPlace place;
  Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
};

PatchPlace place_at(const CutPatch& patch, int vertex) {
  return {.kind = PlaceKind::kVertex, .vertex = vertex, .position = patch.positions[vertex]};
}

int nearest_corner(const CutPatch& patch, int facet, const Eigen::Vector3d& position) {
  const Eigen::Vector3i& corners = patch.triangles[patch.locate(facet, position).first];
  return *std::ranges::min_element(corners, {},
                                   [&](int corner) { return (patch.positions[corner] - position).squaredNorm(); });
}

/// Nodes between two stops: on the path, far enough from each other; close to an edge that stays its nearer end.
std::vector<NodeBetween> nodes_between(const CutPatch& patch, std::span<const PathStop> stops, int index,
                                       const RefusedChoices& refused, int least_pieces) {
  const PathStop& stop = stops[index];
  const std::vector<Eigen::Vector3d> line = line_after(stops, index);
  const double scale = scale_in(patch, stop.facet, line[line.size() / 2]);
  std::vector<NodeBetween> nodes;
  int number = 0;
  Eigen::Vector3d last = line.front();
  for (const Eigen::Vector3d& wanted : evenly_spaced(line, scale, least_pieces)) {
    const double step = std::min((wanted - last).norm(), (wanted - line.back()).norm());
    if (step < kLeastStep * scale) continue;
    last = wanted;
    // Its choices: the place itself, a vertex, none.
    NodeBetween node{.choice = kBetween + 2 * number++,
                     .place = {.kind = PlaceKind::kFace, .facet = stop.facet, .position = wanted},
                     .wanted = wanted};
    const NearestSide side = nearest_side(patch, stop.facet, wanted);
    const bool close = side.distance < kClearance * scale;
    if (close || refused.count({index, node.choice})) {
      ++node.choice;
      node.place = close ? place_at(patch, side.place.along < 0.5 ? side.place.from : side.place.to)
                         : place_at(patch, nearest_corner(patch, stop.facet, wanted));
    }
    if (!refused.count({index, node.choice})) nodes.push_back(node);
  }
  return nodes;
}

// ---- Choices at stops

std::vector<PatchPlace> choices_on_side(const CutPatch& patch, const PatchPlace& place, double scale) {
  const Eigen::Vector3d &a = patch.positions[place.from], &b = patch.positions[place.to];
  std::vector<PatchPlace> choices;
  // A vertex on a straight edge can slide to where the path crosses.
  const int end = place.along < 0.5 ? place.from : place.to;
  if (patch.freedom[end] == VertexFreedom::kLine) choices.push_back(place);
  const double least = std::max(kLeastPart, kLeastPart * scale / (b - a).norm());
  if (least <= 0.5) {
    std::vector<double> parts;
    for (const double part : {std::clamp(place.along, least, 1 - least), least, 0.5, 1 - least}) {
      if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
    }
    for (const double part : parts) {
      PatchPlace choice = place;
      choice.along = part;
      choice.position = part == place.along ? place.position : Eigen::Vector3d(a + part * (b - a));
      choices.push_back(choice);
    }
  }
  for (const int vertex : {place.from, place.to}) {
    choices.push_back(place_at(patch, vertex));
  }
  return choices;
}

/// The first place along a line (which starts at a beginning or end of the path and leads into it) that is far enough
/// from edges that stay, neither far along nor closer than a step to the line's end.
std::optional<PatchPlace> first_clear_place(const CutPatch& patch, int facet, std::span<const Eigen::Vector3d> line,
                                            double scale) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = (line[i + 1] - line[i]).norm();
    const int steps = static_cast<int>(std::ceil(length / (0.05 * scale)));
    for (int step = 0; step < steps; ++step) {
      const Eigen::Vector3d position = line[i] + double(step) / steps * (line[i + 1] - line[i]);
      if ((position - line.front()).norm() > kFarthestInward * scale) return std::nullopt;
      if ((position - line.back()).norm() < kLeastStep * scale) continue;
      if (nearest_side(patch, facet, position).distance < kClearance * scale) continue;
      return PatchPlace{.kind = PlaceKind::kFace, .facet = facet, .position = position};
    }
  }
  return std::nullopt;
}

/// Places for a beginning or end within a facet: there, or on the edge nearby, or farther in; at a vertex. None: the
/// path stops short.
std::vector<PatchPlace> choices_in_face(const CutPatch& patch, const PatchPlace& place,
                                        std::span<const Eigen::Vector3d> line, double scale, bool is_beginning) {
  const NearestSide side = nearest_side(patch, place.facet, place.position);
  const bool clear = side.distance >= kClearance * scale;
  if (!clear && !side.border && (side.place.position - line.back()).norm() >= kLeastStep * scale) {
    return choices_on_side(patch, side.place, scale);
  }
  const auto inner = clear ? std::optional(place) : first_clear_place(patch, place.facet, line, scale);
  // A cut may begin at a border that its path begins close to, but not break through one that it ends close to.
  if (!inner && !is_beginning) return {};
  if (!inner) return {place_at(patch, side.place.along < 0.5 ? side.place.from : side.place.to)};
  const PatchPlace corner = place_at(patch, nearest_corner(patch, place.facet, inner->position));
  if (patch.path_goes_on && !is_beginning && (corner.position - inner->position).norm() > kFarthestEnd * scale)
    return {*inner};
  return {*inner, corner};
}

struct Slot {
  int stop = 0;
  int passed = 0;  // the last stop that a cut to here has behind it
  Eigen::Vector3d wanted;
  double scale = 0;
  double least_angle = 0;  // radians, for what leaves here
  std::vector<PatchPlace> choices;
  std::vector<NodeBetween> between;  // to the next slot
  int facet = -1;
};

bool all_refused(const RefusedChoices& refused, int stop, int choices) {
  for (int choice = 0; choice < choices; ++choice) {
    if (!refused.count({stop, choice})) return false;
  }
  return true;
}

std::vector<Slot> make_slots(const CutPatch& patch, std::span<const PathStop> stops, const RefusedChoices& refused) {
  std::vector<Slot> slots;
  const int count = static_cast<int>(stops.size());
  for (int i = 0; i < count; ++i) {
    const PathStop& stop = stops[i];
    const PatchPlace& place = stop.place;
    const bool last = i + 1 == count;
    const int facet = last ? (i > 0 ? stops[i - 1].facet : facets_at(patch, place).front()) : stop.facet;
    const int triangle = patch.locate(facet, place.position).first;
    constexpr double kMargin = 1.05;
    Slot slot{.stop = i,
              .passed = i,
              .wanted = place.position,
              .scale = patch.scale[triangle],
              .least_angle = kMargin * patch.allowed_at(triangle),
              .choices = {},
              .between = {},
              .facet = stop.facet};
    if (place.kind == PlaceKind::kVertex) slot.choices = {place};
    if (place.kind == PlaceKind::kSide) slot.choices = choices_on_side(patch, place, slot.scale);
    if (place.kind == PlaceKind::kFace) {
      std::vector<Eigen::Vector3d> line = line_after(stops, std::max(0, last ? i - 1 : i));
      if (last) std::ranges::reverse(line);
      slot.choices = choices_in_face(patch, place, line, slot.scale, !last);
      // A cut that stops short has the end of the path still before it.
      if (last && !slot.choices.empty() && slot.choices.front().kind == PlaceKind::kFace) {
        slot.wanted = slot.choices.front().position;
        if (slot.wanted != place.position) slot.passed = i - 1;
      }
      if (all_refused(refused, i, static_cast<int>(slot.choices.size()))) slot.choices.clear();
    }
    if (!last) {
      const bool alone = count == 2 && place.kind == PlaceKind::kFace && stops[1].place.kind == PlaceKind::kFace;
      slot.between = nodes_between(patch, stops, i, refused, alone ? 2 : 1);
    }
    slots.push_back(std::move(slot));
  }
  return slots;
}

// ---- Which choices go together

/// The least angle between a direction from a place and the edges there that bound the facet; 0 along them.
double angle_to_edges(const CutPatch& patch, const PatchPlace& place, int facet, const Eigen::Vector3d& direction) {
  double least = std::numbers::pi;
  const auto compare = [&](int end) {
    least = std::min(least, angle_between(direction, patch.positions[end] - place.position));
  };
  if (place.kind == PlaceKind::kSide) {
    compare(place.from);
    compare(place.to);
  }
  if (place.kind == PlaceKind::kVertex) {
    for (const PatchCorner& corner : patch.fan_of(place.vertex).corners) {
      if (patch.facet[corner.triangle] != facet) continue;
      const Eigen::Vector3i& t = patch.triangles[corner.triangle];
      if (patch.is_crease(corner.triangle, corner.corner)) compare(t[(corner.corner + 1) % 3]);
      if (patch.is_crease(corner.triangle, (corner.corner + 2) % 3)) compare(t[(corner.corner + 2) % 3]);
    }
  }
  return least;
}

double sharpness_penalty(double angle, double least_angle) {
  constexpr double kAlong = 1e-6, kComfortable = 0.6;  // radians
  if (angle < kAlong) return 0;
  if (angle < least_angle) return kTooSharp * (1 + (least_angle - angle) / least_angle);
  return angle < kComfortable ? 0.1 * (kComfortable - angle) / kComfortable : 0;
}

double transition_penalty(const CutPatch& patch, const Slot& slot, const PatchPlace& from, const PatchPlace& to) {
  const bool vertices = from.kind == PlaceKind::kVertex && to.kind == PlaceKind::kVertex;
  if (slot.between.empty() && vertices && (from.vertex == to.vertex || patch.are_joined(from.vertex, to.vertex))) {
    return 0;
  }
  const Eigen::Vector3d first = slot.between.empty() ? to.position : slot.between.front().place.position;
  const Eigen::Vector3d last = slot.between.empty() ? from.position : slot.between.back().place.position;
  double penalty = 0;
  if ((first - from.position).norm() < kLeastPart * slot.scale) penalty += kTooShort;
  if ((last - to.position).norm() < kLeastPart * slot.scale) penalty += kTooShort;
  penalty += sharpness_penalty(angle_to_edges(patch, from, slot.facet, first - from.position), slot.least_angle);
  penalty += sharpness_penalty(angle_to_edges(patch, to, slot.facet, last - to.position), slot.least_angle);
  return penalty;
}

/// The cheapest choice for each slot.
std::vector<int> choose(const CutPatch& patch, std::span<const Slot> slots, const RefusedChoices& refused) {
  std::vector<std::vector<double>> cost(slots.size());
  std::vector<std::vector<int>> from(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Slot& slot = slots[i];
    for (int c = 0; c < static_cast<int>(slot.choices.size()); ++c) {
      const Eigen::Vector3d off = slot.choices[c].position - slot.wanted;
      const double own = off.squaredNorm() / (slot.scale * slot.scale) + (refused.count({slot.stop, c}) ? kRefused : 0);
      double best = i == 0 ? 0 : std::numeric_limits<double>::infinity();
      int best_from = -1;
      for (int b = 0; i > 0 && b < static_cast<int>(slots[i - 1].choices.size()); ++b) {
        const Slot& earlier = slots[i - 1];
        const Eigen::Vector3d change = off - (earlier.choices[b].position - earlier.wanted);
        const double value = cost[i - 1][b] + 0.5 * change.squaredNorm() / (slot.scale * slot.scale) +
                             transition_penalty(patch, earlier, earlier.choices[b], slot.choices[c]);
        if (value >= best) continue;
        best = value;
        best_from = b;
      }
      cost[i].push_back(own + best);
      from[i].push_back(best_from);
    }
  }
  std::vector<int> chosen(slots.size(), -1);
  if (slots.empty()) return chosen;
  chosen.back() = static_cast<int>(std::min_element(cost.back().begin(), cost.back().end()) - cost.back().begin());
  for (std::size_t i = slots.size() - 1; i > 0; --i) chosen[i - 1] = from[i][chosen[i]];
  return chosen;
}

/// Takes out repeated nodes, and nodes that only lead off the path and back.
void remove_detours(std::vector<PathNode>& nodes) {
  const auto is_same_vertex = [](const PathNode& a, const PathNode& b) {
    return a.place.kind == PlaceKind::kVertex && b.place.kind == PlaceKind::kVertex && a.place.vertex == b.place.vertex;
  };
  for (std::size_t i = 0; i + 1 < nodes.size();) {
    if (is_same_vertex(nodes[i], nodes[i + 1])) {
      nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
      continue;
    }
    if (i > 0 && is_same_vertex(nodes[i - 1], nodes[i + 1])) {
      const double step = (nodes[i].place.position - nodes[i - 1].place.position).norm();
      if ((nodes[i].wanted - nodes[i - 1].place.position).norm() < 0.5 * step) {
        nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(i - 1),
                    nodes.begin() + static_cast<std::ptrdiff_t>(i + 1));
        i = i > 1 ? i - 2 : 0;
        continue;
      }
    }
    ++i;
  }
}

}  // namespace

std::vector<PathNode> snap_path(const CutPatch& patch, std::span<const PathStop> stops, const RefusedChoices& refused) {
  std::vector<Slot> slots = make_slots(patch, stops, refused);
  std::vector<PathNode> nodes;
  const auto add_between = [&](const Slot& slot) {
    for (const NodeBetween& node : slot.between) {
      nodes.push_back({.place = node.place,
                       .facet = slot.facet,
                       .stop = slot.stop,
                       .passed = slot.stop,
                       .choice = node.choice,
                       .wanted = node.wanted});
    }
  };
  // A beginning or an end without a place is left out; the nodes between stay.
  if (!slots.empty() && slots.front().choices.empty()) {
    add_between(slots.front());
    slots.erase(slots.begin());
  }
  if (!slots.empty() && slots.back().choices.empty()) slots.pop_back();
  const std::vector<int> chosen = choose(patch, slots, refused);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    nodes.push_back({.place = slots[i].choices[chosen[i]],
                     .facet = slots[i].facet,
                     .stop = slots[i].stop,
                     .passed = slots[i].passed,
                     .choice = chosen[i],
                     .wanted = slots[i].wanted});
    add_between(slots[i]);
  }
  remove_detours(nodes);
  return nodes;
}

}  // namespace thinwall

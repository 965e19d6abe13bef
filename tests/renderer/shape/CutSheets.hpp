#pragma once

#include "tests/renderer/shape/TestMeshes.hpp"

namespace thinwall::test {

/// A strip of three squares of 2 mm along x, cut between the first and the second: vertices 2 and 3 have the twins
/// 8, 9.
inline SnapshotTopology cut_strip() {
  SnapshotTopology topology;
  for (const float x : {0.0f, 0.002f, 0.004f, 0.006f}) {
    topology.rest_positions.push_back({x, 0, 0});
    topology.rest_positions.push_back({x, 0.002f, 0});
  }
  topology.rest_positions.push_back({0.002f, 0, 0});
  topology.rest_positions.push_back({0.002f, 0.002f, 0});
  topology.triangles = {{0, 2, 3}, {0, 3, 1}, {8, 4, 5}, {8, 5, 9}, {4, 6, 7}, {4, 7, 5}};
  return topology;
}

/// A sheet in `parts` x `parts` squares of `square` metres, cut along y = 0 at time 0 but for `whole` squares at either
/// end and turned by `steepness` (radians) about the cut, so that it falls towards -y.
inline SnapshotSurface slit_sheet(int parts, double square, double steepness, std::uint32_t whole = 1) {
  auto topology = std::make_shared<SnapshotTopology>();
  const auto row = static_cast<std::uint32_t>(parts + 1);
  const int middle = parts / 2;
  for (int j = 0; j <= parts; ++j) {
    for (int i = 0; i <= parts; ++i) {
      const double x = square * (i - middle), y = square * (j - middle);
      topology->rest_positions.push_back({static_cast<float>(x), static_cast<float>(y * std::cos(steepness)),
                                          static_cast<float>(y * std::sin(steepness))});
    }
  }
  // Twins of the inner places of the slit, for the triangles on the side of +y.
  std::map<std::uint32_t, std::uint32_t> twins;
  for (std::uint32_t i = whole + 1; i + whole + 1 < row; ++i) {
    const std::uint32_t place = static_cast<std::uint32_t>(middle) * row + i;
    twins[place] = static_cast<std::uint32_t>(topology->rest_positions.size());
    topology->rest_positions.push_back(topology->rest_positions[place]);
  }
  for (std::uint32_t j = 0; j + 1 < row; ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = j * row + i;
      for (Triangle triangle : {Triangle{a, a + 1, a + row + 1}, Triangle{a, a + row + 1, a + row}}) {
        for (std::uint32_t& corner : triangle) {
          if (j >= static_cast<std::uint32_t>(middle) && twins.contains(corner)) corner = twins[corner];
        }
        topology->triangles.push_back(triangle);
      }
    }
  }
  topology->thickness.assign(topology->triangles.size(), 0.002f);
  topology->cut_times.assign(topology->rest_positions.size(), kNeverCut);
  for (const auto& [place, twin] : twins) topology->cut_times[place] = topology->cut_times[twin] = 0;
  for (const std::uint32_t end : {whole, row - 1 - whole}) {
    topology->cut_times[static_cast<std::uint32_t>(middle) * row + end] = 0;
  }
  return {.body = "organ", .topology = topology, .positions = topology->rest_positions, .fields = {}};
}

/// A level sheet in `parts` x `parts` squares of `square` metres, out of whose middle `patch` x `patch` of them are
/// cut. The patch has the last (patch + 1)^2 vertices.
inline SnapshotSurface patched_sheet(int parts, double square, int patch) {
  std::vector<Float3> places;
  std::vector<Triangle> triangles;
  const auto add = [&](int from, int to, const auto& has) {
    const auto offset = static_cast<std::uint32_t>(places.size()), row = static_cast<std::uint32_t>(to - from + 1);
    for (int j = from; j <= to; ++j) {
      for (int i = from; i <= to; ++i)
        places.push_back({static_cast<float>(square * i), static_cast<float>(square * j), 0});
    }
    for (int j = from; j < to; ++j) {
      for (int i = from; i < to; ++i) {
        const std::uint32_t a =
            offset + static_cast<std::uint32_t>(j - from) * row + static_cast<std::uint32_t>(i - from);
        if (has(i, j)) triangles.insert(triangles.end(), {{a, a + 1, a + row + 1}, {a, a + row + 1, a + row}});
      }
    }
  };
  const auto is_patch = [&](int i, int j) { return std::abs(2 * i + 1) < patch && std::abs(2 * j + 1) < patch; };
  add(-parts / 2, parts / 2, [&](int i, int j) { return !is_patch(i, j); });
  add(-patch / 2, patch / 2, is_patch);
  return surface_of("organ", places, triangles);
}

}  // namespace thinwall::test

#include "engine/mesh/ShapePatterns.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace thinwall {
namespace {

int add_vertex(Pattern& pattern, double first, double second) {
  pattern.coordinates.emplace_back(first, second);
  return static_cast<int>(pattern.coordinates.size()) - 1;
}

/// Triangles between a row of n and a row of n + 1 vertices whose first coordinate is greater, or less when `mirrored`.
void join_rows(Pattern& pattern, const std::vector<int>& shorter, const std::vector<int>& longer, bool mirrored) {
  const auto add = [&](int a, int b, int c) {
    pattern.triangles.push_back(mirrored ? Eigen::Vector3i(a, c, b) : Eigen::Vector3i(a, b, c));
  };
  for (std::size_t k = 0; k < shorter.size(); ++k) {
    add(shorter[k], longer[k], longer[k + 1]);
    if (k + 1 < shorter.size()) add(shorter[k], longer[k + 1], shorter[k + 1]);
  }
}

}  // namespace

Pattern staggered_rows(int strips, int segments, bool wrapped) {
  assert(strips >= 1 && segments >= 1 && (!wrapped || strips % 2 == 0));
  Pattern pattern;
  const int rows = wrapped ? strips : strips + 1;
  for (int i = 0; i < rows; ++i) {
    const bool shifted = i % 2 == 1;
    std::vector<int> row;
    for (int k = 0; k <= segments + (shifted ? 1 : 0); ++k) {
      // Differences of integers: mirrored vertices get mirrored coordinates to the last bit.
      const double along = static_cast<double>(2 * k - (shifted ? 1 : 0) - segments) / (2 * segments);
      const double across = static_cast<double>(2 * i - strips) / (2 * strips);
      row.push_back(add_vertex(pattern, across, std::clamp(along, -0.5, 0.5)));
    }
    pattern.rows.push_back(std::move(row));
  }
  for (int i = 0; i < strips; ++i) {
    const std::vector<int>& row = pattern.rows[i];
    const std::vector<int>& next = pattern.rows[(i + 1) % rows];
    if (i % 2 == 0) {
      join_rows(pattern, row, next, false);
    } else {
      join_rows(pattern, next, row, true);
    }
  }
  return pattern;
}

Pattern centred_rings(int sectors, int rings) {
  assert(sectors >= 3 && rings >= 1);
  Pattern pattern;
  pattern.rows.push_back({add_vertex(pattern, 0, 0)});
  for (int ring = 1; ring <= rings; ++ring) {
    std::vector<int> row;
    for (int j = 0; j < sectors * ring; ++j) {
      row.push_back(add_vertex(pattern, static_cast<double>(ring) / rings, static_cast<double>(j) / (sectors * ring)));
    }
    const std::vector<int>& inner = pattern.rows.back();
    for (int sector = 0; sector < sectors; ++sector) {
      std::vector<int> shorter;
      std::vector<int> longer;
      for (int j = 0; j < ring; ++j) shorter.push_back(inner[(sector * (ring - 1) + j) % inner.size()]);
      for (int j = 0; j <= ring; ++j) longer.push_back(row[(sector * ring + j) % row.size()]);
      join_rows(pattern, shorter, longer, false);
    }
    pattern.rows.push_back(std::move(row));
  }
  return pattern;
}

Pattern staggered_circles(int rings, int around) {
  assert(rings >= 1 && around >= 3);
  Pattern pattern;
  for (int ring = 0; ring <= rings; ++ring) {
    std::vector<int> row;
    for (int j = 0; j < around; ++j) {
      row.push_back(add_vertex(pattern, static_cast<double>(ring) / rings, (j + (ring % 2 == 1 ? 0.5 : 0.0)) / around));
    }
    pattern.rows.push_back(std::move(row));
  }
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<int>& inner = pattern.rows[ring];
    const std::vector<int>& outer = pattern.rows[ring + 1];
    const int lead = ring % 2 == 0 ? 0 : 1;  // which outer vertex follows inner vertex j in the sense of the turn
    for (int j = 0; j < around; ++j) {
      const int next = (j + 1) % around;
      const int after = outer[(j + lead) % around];
      const int before = outer[(j + lead + around - 1) % around];
      pattern.triangles.emplace_back(inner[j], before, after);
      pattern.triangles.emplace_back(inner[j], after, inner[next]);
    }
  }
  return pattern;
}

std::vector<Eigen::Vector3i> fill_polygon(std::span<const int> polygon) {
  assert(polygon.size() >= 3);
  std::vector<Eigen::Vector3i> triangles;
  std::vector<int> left(polygon.begin(), polygon.end());
  while (left.size() > 3) {
    std::vector<int> kept;
    const std::size_t count = left.size();
    for (std::size_t i = 0; i < count; i += 2) {
      kept.push_back(left[i]);
      if (i + 1 < count) triangles.emplace_back(left[i], left[i + 1], left[(i + 2) % count]);
    }
    // An odd polygon keeps its last vertex beside its first.
    left = std::move(kept);
    if (left.size() == 2) return triangles;
  }
  triangles.emplace_back(left[0], left[1], left[2]);
  return triangles;
}

Division closest_division(int wanted, int least_across, int step, int least_along,
                          const std::function<int(Division)>& count, const std::function<double(Division)>& aspect) {
  Division best{least_across, least_along};
  double least_cost = std::numeric_limits<double>::infinity();
  for (int across = least_across; count({across, least_along}) <= 4 * wanted || across == least_across;
       across += step) {
    int along = least_along;
    const auto consider = [&](const Division& division) {
      const double off = std::log(static_cast<double>(count(division)) / wanted);
      const double shape = std::log(aspect(division));
      const double cost = std::abs(off) + shape * shape;
      if (cost < least_cost) {
        least_cost = cost;
        best = division;
      }
    };
    while (count({across, along}) < wanted) {
      consider({across, along});
      ++along;
    }
    consider({across, along});
  }
  return best;
}

int closest_square(int wanted, int factor) {
  int n = 1;
  while (factor * (n + 1) * (n + 1) <= wanted) ++n;
  const int below = wanted - factor * n * n;
  const int above = factor * (n + 1) * (n + 1) - wanted;
  return above < below ? n + 1 : n;
}

}  // namespace thinwall

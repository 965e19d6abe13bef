#include "engine/wall/MembraneLanes.hpp"

#include <algorithm>
#include <cassert>

#include "engine/solver/BlockPattern.hpp"

namespace thinwall {
namespace {

/// Lanes of what the law needs and of what it answers.
struct Strain {
  Lanes first[3], second[3];  // columns of the deformation gradient
  Lanes c[3];                 // (C11, C22, C12)
};
struct Response {
  Lanes stress[3];                     // joule: (S11, S22, S12) times the rest volume
  Lanes d00, d11, d22, d01, d02, d12;  // joule: the tangent times the rest volume
};
struct Rest {
  Lanes one[2], two[2];  // shape gradients of the second and the third corner, 1 / metre
};

/// A block of the Hessian from the shape gradients of its two corners. `symmetric`: of a corner with itself, whose
/// upper triangle nobody asks for.
template <bool symmetric>
[[gnu::always_inline]] inline void couple(const Strain& strain, const Response& response, const Lanes (&a)[2],
                                          const Lanes (&b)[2], Lanes (&block)[9]) {
  const Response& d = response;
  const Lanes p00 = d.d00 * b[0] + d.d02 * b[1], p01 = d.d01 * b[1] + d.d02 * b[0];
  const Lanes p10 = d.d01 * b[0] + d.d12 * b[1], p11 = d.d11 * b[1] + d.d12 * b[0];
  const Lanes p20 = d.d02 * b[0] + d.d22 * b[1], p21 = d.d12 * b[1] + d.d22 * b[0];
  const Lanes m00 = a[0] * p00 + a[1] * p20, m01 = a[0] * p01 + a[1] * p21;
  const Lanes m10 = a[1] * p10 + a[0] * p20, m11 = a[1] * p11 + a[0] * p21;
  const Lanes geometric =
      a[0] * (d.stress[0] * b[0] + d.stress[2] * b[1]) + a[1] * (d.stress[2] * b[0] + d.stress[1] * b[1]);
#pragma GCC unroll 3
  for (int column = 0; column < 3; ++column) {
    const Lanes by_first = m00 * strain.first[column] + m01 * strain.second[column];
    const Lanes by_second = m10 * strain.first[column] + m11 * strain.second[column];
#pragma GCC unroll 3
    for (int row = symmetric ? column : 0; row < 3; ++row) {
      block[3 * column + row] = strain.first[row] * by_first + strain.second[row] * by_second;
    }
    block[4 * column] += geometric;
  }
}

THINWALL_FOR_ALL_PROCESSORS void find_strain(const Lanes* corners, const Rest& rest, Strain& strain) {
  for (int k = 0; k < 3; ++k) {
    const Lanes one = corners[3 + k] - corners[k], two = corners[6 + k] - corners[k];
    strain.first[k] = one * rest.one[0] + two * rest.two[0];
    strain.second[k] = one * rest.one[1] + two * rest.two[1];
  }
  const auto& f = strain.first;
  const auto& s = strain.second;
  strain.c[0] = f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
  strain.c[1] = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
  strain.c[2] = f[0] * s[0] + f[1] * s[1] + f[2] * s[2];
}

THINWALL_FOR_ALL_PROCESSORS void find_forces(const Rest& rest, const Strain& strain, const Response& response,
                                             MembraneLanes& terms) {
  Lanes largest = {};
  for (int k = 0; k < 3; ++k) {
    const Lanes along = response.stress[0] * strain.first[k] + response.stress[2] * strain.second[k];
    const Lanes across = response.stress[2] * strain.first[k] + response.stress[1] * strain.second[k];
    const Lanes one = rest.one[0] * along + rest.one[1] * across, two = rest.two[0] * along + rest.two[1] * across;
    const Lanes gradient[3] = {-one - two, one, two};
    for (int corner = 0; corner < 3; ++corner) {
      const Lanes size = gradient[corner] < 0 ? -gradient[corner] : gradient[corner];
      largest = size > largest ? size : largest;
      store(gradient[corner], terms.gradient[3 * corner + k].data());
    }
  }
  store(largest, terms.largest_force.data());
}

THINWALL_FOR_ALL_PROCESSORS void find_hessian(const Rest& rest, const Strain& strain, const Response& response,
                                              MembraneLanes& terms) {
  Lanes blocks[6][9];
  couple<true>(strain, response, rest.one, rest.one, blocks[1]);
  couple<true>(strain, response, rest.two, rest.two, blocks[2]);
  couple<false>(strain, response, rest.one, rest.two, blocks[4]);
#pragma GCC unroll 3
  for (int column = 0; column < 3; ++column) {
#pragma GCC unroll 3
    for (int row = 0; row < 3; ++row) {
      const int at = 3 * column + row, mirrored = 3 * row + column, lower = row < column ? mirrored : at;
      blocks[3][at] = -(blocks[1][lower] + blocks[4][mirrored]);
      blocks[5][at] = -(blocks[2][lower] + blocks[4][at]);
      if (row >= column) blocks[0][at] = (blocks[1][at] + blocks[2][at]) + (blocks[4][at] + blocks[4][mirrored]);
    }
  }
  for (int block = 0; block < 6; ++block) {
    const auto [i, j] = kBlockCorners[block];
    for (int column = 0; column < 3; ++column) {
      for (int row = i == j ? column : 0; row < 3; ++row) {
        store(blocks[block][3 * column + row], terms.hessian[block][3 * column + row].data());
      }
    }
  }
}

}  // namespace

void membrane_lanes(std::span<const MembraneTriangle> triangles, bool with_hessian, MembraneLanes& terms) {
  assert(!triangles.empty() && triangles.size() <= kLanes);
  const int last = static_cast<int>(triangles.size()) - 1;
  Rest rest;
  Lanes corners[9];
  for (int lane = 0; lane < kLanes; ++lane) {
    const MembraneTriangle& triangle = triangles[std::min(lane, last)];
    for (int k = 0; k < 2; ++k) {
      rest.one[k][lane] = triangle.rest->inverse_edges(0, k);
      rest.two[k][lane] = triangle.rest->inverse_edges(1, k);
    }
    for (int corner = 0; corner < 3; ++corner) {
      for (int k = 0; k < 3; ++k) corners[3 * corner + k][lane] = triangle.corners[corner][k];
    }
  }
  Strain strain;
  find_strain(corners, rest, strain);
  Response response;
  for (int lane = 0; lane < kLanes; ++lane) {
    const MembraneTriangle& triangle = triangles[std::min(lane, last)];
    const MembraneResponse own = membrane_response(
        *triangle.material, {strain.c[0][lane], strain.c[1][lane], strain.c[2][lane]}, triangle.memory);
    const double volume = triangle.rest->area * triangle.rest->thickness;
    terms.energy[lane] = volume * own.whole.energy;
    terms.strain_energy[lane] = volume * own.strain_energy;
    for (int k = 0; k < 3; ++k) response.stress[k][lane] = volume * own.whole.second_piola_kirchhoff[k];
    const Eigen::Matrix3d& tangent = own.whole.tangent;
    response.d00[lane] = volume * tangent(0, 0);
    response.d11[lane] = volume * tangent(1, 1);
    response.d22[lane] = volume * tangent(2, 2);
    response.d01[lane] = volume * tangent(0, 1);
    response.d02[lane] = volume * tangent(0, 2);
    response.d12[lane] = volume * tangent(1, 2);
  }
  find_forces(rest, strain, response, terms);
  if (with_hessian) find_hessian(rest, strain, response, terms);
}

}  // namespace thinwall

#pragma once

#include <cstring>

#include "renderer/image/AllProcessors.hpp"

/// Eight numbers at once, and functions of them. The compiler makes of them what the processor has; as each lane is
/// computed alone and nothing is contracted, the results are the same to the last bit on every width of its registers.
namespace thinwall::lanes {

inline constexpr int kCount = 8;

using Lanes = float __attribute__((vector_size(4 * kCount)));
using IntLanes = int __attribute__((vector_size(4 * kCount)));

// Inlined always, so that they are compiled for the processor that the calling function is compiled for. That also
// makes it of no consequence how vectors would be passed.
#define THINWALL_LANE_FUNCTION [[gnu::always_inline]] inline

THINWALL_LANE_FUNCTION void load(Lanes& lanes, const float* from) {
  std::memcpy(&lanes, from, sizeof(lanes));
}
THINWALL_LANE_FUNCTION void store(const Lanes& lanes, float* to) {
  std::memcpy(to, &lanes, sizeof(lanes));
}

/// x becomes its cube root: two of Halley's steps from a guess by the exponent, relative error below 3e-7. x >= 1e-6.
THINWALL_LANE_FUNCTION void cube_root(Lanes& x) {
  IntLanes bits;
  std::memcpy(&bits, &x, sizeof(bits));
  // A third of the exponent, and two thirds of its bias; the constant also halves the guess's largest error.
  bits = __builtin_convertvector(__builtin_convertvector(bits, Lanes) * (1.0F / 3), IntLanes) + 709921077;
  Lanes y;
  std::memcpy(&y, &bits, sizeof(y));
  for (int step = 0; step < 2; ++step) {
    const Lanes cube = y * y * y;
    y = y * (cube + x + x) / (cube + cube + x);
  }
  x = y;
}

/// x becomes x to the power p, relative error below 3e-6 for results above 1e-6: 2^(p log2 x), log2 by the series of
/// artanh, 2^z by Taylor's. 0 gives 0. 0 <= x <= 1e6, 0 <= p <= 1.
THINWALL_LANE_FUNCTION void power(Lanes& x, const Lanes& p) {
  const Lanes zero = {};
  const Lanes smallest = zero + 1e-30F;
  const Lanes base = x > smallest ? x : smallest;
  IntLanes bits;
  std::memcpy(&bits, &base, sizeof(bits));
  // The mantissa between sqrt(1/2) and sqrt(2): 0x3f3504f3 is sqrt(1/2).
  const IntLanes exponent = (bits - 0x3f3504f3) >> 23;
  bits -= exponent << 23;
  Lanes mantissa;
  std::memcpy(&mantissa, &bits, sizeof(mantissa));
  const Lanes s = (mantissa - 1) / (mantissa + 1);
  const Lanes q = s * s;
  const Lanes series = s * (1 + q * (1.0F / 3 + q * (1.0F / 5 + q * (1.0F / 7 + q * (1.0F / 9)))));
  const Lanes z = p * (__builtin_convertvector(exponent, Lanes) + series * 2.885390081777927F);
  const Lanes half = z < zero ? zero - 0.5F : zero + 0.5F;
  const IntLanes whole = __builtin_convertvector(z + half, IntLanes);
  const Lanes t = (z - __builtin_convertvector(whole, Lanes)) * 0.6931471805599453F;
  const Lanes fraction = 1 + t * (1 + t * (1.0F / 2 + t * (1.0F / 6 + t * (1.0F / 24 + t * (1.0F / 120 + t / 720)))));
  const IntLanes scale_bits = (whole + 127) << 23;
  Lanes scale;
  std::memcpy(&scale, &scale_bits, sizeof(scale));
  x = x > zero ? fraction * scale : zero;
}

}  // namespace thinwall::lanes

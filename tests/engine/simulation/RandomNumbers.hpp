#pragma once

#include <random>

namespace thinwall {

/// Numbers that are a function of a seed and a number alone.
class RandomNumbers {
 public:
  RandomNumbers(unsigned seed, unsigned number) {
    std::seed_seq sequence{seed, number};
    engine.seed(sequence);
  }

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  /// From 0 to count - 1.
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine); }

  std::mt19937 engine;
};

}  // namespace thinwall

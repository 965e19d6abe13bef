#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace thinwall {

/// A straight part of a section, from one node to another. Parts that end at the same node meet there.
struct SectionSegment {
  int triangle = 0;                             // in which it lies
  std::array<std::uint64_t, 2> nodes = {0, 0};  // keys of its ends
};

/// A step along a chain of segments.
struct ChainStep {
  int segment = 0;
  int from = 0;  // 0 or 1: the end at which the chain enters the segment
};

struct SegmentChain {
  std::vector<ChainStep> steps;
  bool closed = false;
};

/// Strings segments into chains: two segments at a node go on into each other, one alone ends there, and so do three or
/// more. Open chains come first; each in the order of the first segment that begins it, so that the result depends on
/// the order of the segments alone. Every segment is in one chain, once.
std::vector<SegmentChain> chains_of(const std::vector<SectionSegment>& segments);

}  // namespace thinwall

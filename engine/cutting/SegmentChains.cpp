#include "engine/cutting/SegmentChains.hpp"

#include <algorithm>
#include <utility>

namespace thinwall {
namespace {

constexpr int kNone = -1;

/// Of each end of each segment (2 segments) the end that it goes on into, or kNone.
std::vector<int> partners_of(const std::vector<SectionSegment>& segments) {
  std::vector<std::pair<std::uint64_t, int>> ends;
  for (int s = 0; s < static_cast<int>(segments.size()); ++s) {
    for (int e = 0; e < 2; ++e) ends.emplace_back(segments[s].nodes[e], 2 * s + e);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<int> partners(ends.size(), kNone);
  for (std::size_t begin = 0; begin < ends.size();) {
    std::size_t next = begin;
    while (next < ends.size() && ends[next].first == ends[begin].first) ++next;
    if (next - begin == 2) {
      partners[ends[begin].second] = ends[begin + 1].second;
      partners[ends[begin + 1].second] = ends[begin].second;
    }
    begin = next;
  }
  return partners;
}

}  // namespace

std::vector<SegmentChain> chains_of(const std::vector<SectionSegment>& segments) {
  const std::vector<int> partners = partners_of(segments);
  std::vector<bool> used(segments.size(), false);
  std::vector<SegmentChain> chains;
  const auto follow = [&](int start) {
    SegmentChain chain;
    int end = start;
    while (end != kNone && !used[end / 2]) {
      used[end / 2] = true;
      chain.steps.push_back({.segment = end / 2, .from = end % 2});
      end = partners[end ^ 1];
    }
    chain.closed = end == start;
    chains.push_back(std::move(chain));
  };
  for (int end = 0; end < static_cast<int>(partners.size()); ++end) {
    if (partners[end] == kNone && !used[end / 2]) follow(end);
  }
  for (int end = 0; end < static_cast<int>(partners.size()); end += 2) {
    if (!used[end / 2]) follow(end);
  }
  return chains;
}

}  // namespace thinwall

#include "core/trace/node_index.hpp"

#include <algorithm>
#include <bit>

namespace replan {

void NodeIndex::truncate(std::size_t block) {
  if (block / kGroup >= groups_.size()) return;
  groups_.resize(block / kGroup + 1);
  const std::uint64_t keep = (std::uint64_t{1} << block % kGroup) - 1;
  for (std::uint64_t& word : *groups_.back()) word &= keep;
}

std::optional<std::size_t> NodeIndex::last_block(NodeId node, std::size_t before) const {
  before = std::min(before, groups_.size() * kGroup);
  const Places places(node);
  for (std::size_t end = before; end > 0;) {
    const std::size_t group = (end - 1) / kGroup;
    const std::size_t above = (group + 1) * kGroup - end;  // blocks of the group that are too late
    const std::uint64_t found = blocks_of(places, group) << above >> above;
    if (found != 0) return group * kGroup + static_cast<std::size_t>(std::bit_width(found)) - 1;
    end = group * kGroup;
  }
  return std::nullopt;
}

std::optional<std::size_t> NodeIndex::next_block(NodeId node, std::size_t from) const {
  const Places places(node);
  for (std::size_t first = from; first / kGroup < groups_.size();) {
    const std::size_t group = first / kGroup;
    const std::uint64_t found = blocks_of(places, group) >> first % kGroup << first % kGroup;
    if (found != 0) return group * kGroup + static_cast<std::size_t>(std::countr_zero(found));
    first = (group + 1) * kGroup;
  }
  return std::nullopt;
}

}  // namespace replan

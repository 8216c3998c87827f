#include "core/debug/expansions.hpp"

#include <algorithm>

namespace replan {

bool ExpansionTeller::operator()(const Timeline& log, std::size_t index) {
  if (log.event(index).kind != EventKind::visit) return false;
  if (index >= wipe_begin_ && index < wipe_end_) return false;
  // An expansion's vertex was taken a few events ago.
  for (std::size_t i = index; i > 0; --i) {
    if (i == wipe_end_) {
      wipe_end_ = index + 1;
      return false;
    }
    const EventKind kind = log.event(i - 1).kind;
    if (kind == EventKind::pop) return true;
    if (kind == EventKind::plan_begin) {
      wipe_begin_ = i - 1;
      wipe_end_ = index + 1;
      return false;
    }
  }
  return false;
}

bool ExpansionCount::extend(const Timeline& log, std::size_t most) {
  while (before_block_.size() * kBlock <= log.size()) {
    if (most == 0) return false;
    most -= std::min(most, kBlock);
    const std::size_t begin = (before_block_.size() - 1) * kBlock;
    std::int64_t count = before_block_.back();
    for (std::size_t i = begin; i < begin + kBlock; ++i) count += teller_(log, i) ? 1 : 0;
    before_block_.push_back(count);
  }
  return true;
}

std::int64_t ExpansionCount::before(const Timeline& log, std::size_t position) {
  extend(log, position);
  const std::size_t block = std::min(position / kBlock, before_block_.size() - 1);
  std::int64_t count = before_block_[block];
  for (std::size_t i = block * kBlock; i < position; ++i) count += teller_(log, i) ? 1 : 0;
  return count;
}

void ExpansionCount::truncate(std::size_t size) {
  if (before_block_.size() > size / kBlock + 1) before_block_.resize(size / kBlock + 1);
  teller_ = {};
}

}  // namespace replan

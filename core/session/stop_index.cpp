#include "core/session/stop_index.hpp"

#include <algorithm>
#include <bit>

namespace replan {
namespace {

constexpr std::size_t kWord = 64;

}  // namespace

void BitRow::add(bool bit) {
  if (size_ % kWord == 0) words_.push_back(0);
  if (bit) words_.back() |= std::uint64_t{1} << size_ % kWord;
  ++size_;
}

void BitRow::truncate(std::size_t size) {
  if (size >= size_) return;
  words_.resize((size + kWord - 1) / kWord);
  if (size % kWord != 0) words_.back() &= (std::uint64_t{1} << size % kWord) - 1;
  size_ = size;
}

std::size_t BitRow::next(std::size_t from) const {
  if (from >= size_) return size_;
  std::size_t word = from / kWord;
  std::uint64_t bits = words_[word] >> from % kWord << from % kWord;
  while (bits == 0 && ++word < words_.size()) bits = words_[word];
  return bits == 0 ? size_ : word * kWord + static_cast<std::size_t>(std::countr_zero(bits));
}

std::size_t BitRow::previous(std::size_t before) const {
  before = std::min(before, size_);
  if (before == 0) return 0;
  std::size_t word = (before - 1) / kWord;
  const std::size_t beyond = kWord - 1 - (before - 1) % kWord;
  std::uint64_t bits = words_[word] << beyond >> beyond;
  while (bits == 0 && word > 0) bits = words_[--word];
  return bits == 0 ? 0 : word * kWord + kWord - 1 - static_cast<std::size_t>(std::countl_zero(bits));
}

void StopIndex::add(const Event& event, bool begins_iteration) {
  iterations_.add(begins_iteration);
  lines_.add(begins_iteration || event.line != line_);
  line_ = event.line;
}

void StopIndex::truncate(std::size_t size, std::uint8_t line) {
  iterations_.truncate(size);
  lines_.truncate(size);
  line_ = line;
}

}  // namespace replan

// A long array in pages that copies share until one of them writes: what makes key frames of a search cheap.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/shared_array.hpp"
#include "core/trace/block_pool.hpp"

namespace replan {

/// Where a family of arrays of one type keeps its pages: a tree of three levels, so that a copy of a large
/// array names few blocks, and cloning what is on the way to a page is cheap.
template <class T>
class PagePool {
 public:
  /// Values of a page. Few, since a frontier that passes over the pages leaves a clone of each of them in
  /// every key frame; and so are the pages of a group, for the same reason.
  static constexpr std::size_t kPage = 16;
  static constexpr std::size_t kGroup = 16;  ///< pages
  static constexpr std::size_t kSpan = 64;   ///< groups
  using Page = std::array<T, kPage>;
  // 0 = nothing in it was touched
  using Group = std::array<BlockHandle, kGroup>;
  using Span = std::array<BlockHandle, kSpan>;

  BlockPool<Page> pages;
  BlockPool<Group> groups;
  BlockPool<Span> spans;

  /// Bytes of all pages of the family, each counted once, whoever shares it.
  [[nodiscard]] std::size_t bytes() const { return pages.bytes() + groups.bytes() + spans.bytes(); }

  /// A group, or span, that nobody else holds: `handle` itself, a clone of it, or a new one.
  Group& own_group(BlockHandle& handle) {
    return own(
        groups, handle, [this](BlockHandle page) { pages.hold(page); },
        [this](BlockHandle group) { release_group(group); });
  }
  Span& own_span(BlockHandle& handle) {
    return own(
        spans, handle, [this](BlockHandle group) { groups.hold(group); },
        [this](BlockHandle span) { release_span(span); });
  }
  /// A page that somebody else holds too, cloned.
  [[nodiscard]] BlockHandle clone_page(BlockHandle page) {
    const BlockHandle copy = pages.make();
    pages[copy] = pages[page];
    release_page(page);
    return copy;
  }
  void release_span(BlockHandle span) {
    if (!spans.let_go(span)) return;
    for (const BlockHandle group : spans[span])
      if (group != 0) release_group(group);
    spans.give_back(span);
  }

 private:
  template <class Blocks, class Hold, class Release>
  static auto& own(Blocks& blocks, BlockHandle& handle, const Hold& hold, const Release& release) {
    if (handle == 0) {
      handle = blocks.make();
      blocks[handle].fill(0);
    } else if (blocks.shared(handle)) {
      const BlockHandle copy = blocks.make();
      blocks[copy] = blocks[handle];
      for (const BlockHandle below : blocks[copy])
        if (below != 0) hold(below);
      release(handle);
      handle = copy;
    }
    return blocks[handle];
  }
  void release_group(BlockHandle group) {
    if (!groups.let_go(group)) return;
    for (const BlockHandle page : groups[group])
      if (page != 0) release_page(page);
    groups.give_back(group);
  }
  void release_page(BlockHandle page) {
    if (pages.let_go(page)) pages.give_back(page);
  }
};

/// An array of `size` values that starts out all `initial`, or as another array. Copying it copies names of
/// spans of pages only; a page is cloned when it is written to while another copy holds it. Untouched pages
/// take no memory. Assigning a copy that shares most spans costs no more than comparing the names. An array
/// and all its copies are for one thread.
template <class T>
class PagedArray {
  using Pool = PagePool<T>;
  using Page = typename Pool::Page;

 public:
  static constexpr std::size_t kPage = Pool::kPage;
  /// What an array starts out as: its pages are read there until they are written to.
  using Base = SharedArray<T, std::size_t{1} << 16>;

  PagedArray() = default;
  explicit PagedArray(std::size_t size, T initial = T{},
                      std::shared_ptr<Pool> pool = std::make_shared<Pool>())
      : size_(size), initial_(initial), pool_(std::move(pool)), spans_((size + kSpan - 1) / kSpan) {}
  PagedArray(Base base, std::shared_ptr<Pool> pool) : PagedArray(base.size(), T{}, std::move(pool)) {
    base_ = std::make_shared<const Base>(std::move(base));
  }
  PagedArray(const PagedArray& other)
      : size_(other.size_),
        initial_(other.initial_),
        touched_pages_(other.touched_pages_),
        base_(other.base_),
        pool_(other.pool_),
        spans_(other.spans_) {
    for (const BlockHandle span : spans_)
      if (span != 0) pool_->spans.hold(span);
  }
  PagedArray(PagedArray&& other) noexcept { swap(other); }
  PagedArray& operator=(const PagedArray& other) {
    if (pool_ != other.pool_ || base_ != other.base_ || spans_.size() != other.spans_.size()) {
      PagedArray copy(other);
      swap(copy);
      return *this;
    }
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      if (spans_[i] == other.spans_[i]) continue;
      if (other.spans_[i] != 0) pool_->spans.hold(other.spans_[i]);
      if (spans_[i] != 0) pool_->release_span(spans_[i]);
      spans_[i] = other.spans_[i];
    }
    size_ = other.size_;
    initial_ = other.initial_;
    touched_pages_ = other.touched_pages_;
    return *this;
  }
  PagedArray& operator=(PagedArray&& other) noexcept {
    swap(other);
    return *this;
  }
  ~PagedArray() {
    for (const BlockHandle span : spans_)
      if (span != 0) pool_->release_span(span);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T initial() const { return initial_; }
  [[nodiscard]] T operator[](std::size_t index) const {
    const T* values = page(index);
    return values != nullptr ? values[index % kPage] : initial_;  // of one with a base every page exists
  }
  /// A reference to write through, valid until the array is copied.
  T& at(std::size_t index) { return own_page(index)[index % kPage]; }
  /// The same of the whole page that holds `index`.
  T* own_page(std::size_t index) {
    BlockHandle& group = pool_->own_span(spans_[index / kSpan])[index / kGroup % Pool::kSpan];
    BlockHandle& page = pool_->own_group(group)[index / kPage % Pool::kGroup];
    if (page == 0) {
      page = pool_->pages.make();
      begin_page(pool_->pages[page], index / kPage * kPage);
      ++touched_pages_;
    } else if (pool_->pages.shared(page)) {
      page = pool_->clone_page(page);
    }
    return pool_->pages[page].data();
  }
  /// Has the group, or then the page, of `index` brought into the cache.
  void fetch_group(std::size_t index) const {
    if (const BlockHandle group = group_handle(index); group != 0) pool_->groups.fetch(group);
  }
  void fetch_page(std::size_t index) const {
    if (const BlockHandle page = page_handle(index); page != 0) pool_->pages.fetch(page);
  }
  /// Pages that exist, shared or not: what a reader that wants to skip untouched stretches asks.
  [[nodiscard]] bool touched(std::size_t index) const { return page_handle(index) != 0; }
  /// The page that holds `index`, kPage values from a multiple of kPage on, but none behind the array's end;
  /// nullptr if all of them are the initial one still. Valid until written to.
  [[nodiscard]] const T* page(std::size_t index) const {
    if (const BlockHandle page = page_handle(index); page != 0) return pool_->pages[page].data();
    return base_ ? base_->stretch(index / kPage * kPage).data() : nullptr;
  }
  /// The first index from there on at which there may be a page: the beginning of one.
  [[nodiscard]] std::size_t skip_untouched(std::size_t index) const {
    while (!base_ && index < size_ && group_handle(index) == 0) {
      const std::size_t stretch = spans_[index / kSpan] == 0 ? kSpan : kGroup;
      index = (index / stretch + 1) * stretch;
    }
    return std::min(index, size_);
  }
  /// All values; what was never written to is shared with the base.
  [[nodiscard]] Base values() const {
    Base values = base_ ? *base_ : Base(size_, initial_);
    for (std::size_t first = 0; first < size_;) {
      if (group_handle(first) == 0) {
        first += kGroup;
        continue;
      }
      if (touched(first))
        for (std::size_t i = first; i < std::min(size_, first + kPage); ++i) values.edit(i) = (*this)[i];
      first += kPage;
    }
    return values;
  }
  /// Bytes of the pages that this copy reaches, shared or not.
  [[nodiscard]] std::size_t page_bytes() const { return touched_pages_ * BlockPool<Page>::kBlockBytes; }
  /// Bytes of its own: names of spans.
  [[nodiscard]] std::size_t table_bytes() const { return spans_.size() * sizeof(BlockHandle); }

 private:
  static constexpr std::size_t kGroup = Pool::kPage * Pool::kGroup;  // values of a group
  static constexpr std::size_t kSpan = kGroup * Pool::kSpan;         // and of a span

  [[nodiscard]] BlockHandle group_handle(std::size_t index) const {
    const BlockHandle span = spans_[index / kSpan];
    return span != 0 ? pool_->spans[span][index / kGroup % Pool::kSpan] : 0;
  }
  [[nodiscard]] BlockHandle page_handle(std::size_t index) const {
    const BlockHandle group = group_handle(index);
    return group != 0 ? pool_->groups[group][index / kPage % Pool::kGroup] : 0;
  }
  void begin_page(Page& page, std::size_t first) const {
    page.fill(initial_);
    if (base_) std::copy_n(base_->stretch(first).data(), std::min(kPage, size_ - first), page.begin());
  }
  void swap(PagedArray& other) noexcept {
    std::swap(base_, other.base_);
    std::swap(size_, other.size_);
    std::swap(initial_, other.initial_);
    std::swap(touched_pages_, other.touched_pages_);
    std::swap(pool_, other.pool_);
    std::swap(spans_, other.spans_);
  }

  std::size_t size_ = 0;
  T initial_{};
  std::size_t touched_pages_ = 0;
  std::shared_ptr<const Base> base_;  // nullptr: all are initial_
  std::shared_ptr<Pool> pool_;        // of the whole family
  std::vector<BlockHandle> spans_;    // 0 = untouched
};

}  // namespace replan

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

/// Where a family of arrays of one type keeps its pages.
template <class T>
class PagePool {
 public:
  /// Values of a page. Few, since a frontier that passes over the pages leaves a clone of each of them in
  /// every key frame; and so are the pages of a group, for the same reason.
  static constexpr std::size_t kPage = 16;
  static constexpr std::size_t kGroup = 16;
  using Page = std::array<T, kPage>;
  using Group = std::array<BlockHandle, kGroup>;  // 0 = the page is untouched

  BlockPool<Page> pages;
  BlockPool<Group> groups;

  /// Bytes of all pages of the family, each counted once, whoever shares it.
  [[nodiscard]] std::size_t bytes() const { return pages.bytes() + groups.bytes(); }

  [[nodiscard]] BlockHandle clone_page(BlockHandle page) {
    const BlockHandle copy = pages.make();
    pages[copy] = pages[page];
    release_page(page);
    return copy;
  }
  [[nodiscard]] BlockHandle clone_group(BlockHandle group) {
    const BlockHandle copy = groups.make();
    groups[copy] = groups[group];
    for (const BlockHandle page : groups[copy])
      if (page != 0) pages.hold(page);
    release_group(group);
    return copy;
  }
  void release_group(BlockHandle group) {
    if (!groups.let_go(group)) return;
    for (const BlockHandle page : groups[group])
      if (page != 0) release_page(page);
    groups.give_back(group);
  }

 private:
  void release_page(BlockHandle page) {
    if (pages.let_go(page)) pages.give_back(page);
  }
};

/// An array of `size` values that starts out all `initial`, or as another array. Copying it copies names of groups of pages only;
/// a page is cloned when it is written to while another copy holds it. Untouched pages take no memory.
/// Assigning a copy that shares most groups costs no more than comparing the names. An array and all its
/// copies are for one thread.
template <class T>
class PagedArray {
  using Pool = PagePool<T>;
  using Page = typename Pool::Page;
  using Group = typename Pool::Group;

 public:
  static constexpr std::size_t kPage = Pool::kPage;
  /// What an array starts out as: its pages are read there until they are written to.
  using Base = SharedArray<T, std::size_t{1} << 16>;

  PagedArray() = default;
  explicit PagedArray(std::size_t size, T initial = T{},
                      std::shared_ptr<Pool> pool = std::make_shared<Pool>())
      : size_(size), initial_(initial), pool_(std::move(pool)), groups_((size + kSpan - 1) / kSpan) {}
  PagedArray(Base base, std::shared_ptr<Pool> pool)
      : PagedArray(base.size(), T{}, std::move(pool)) {
    base_ = std::make_shared<const Base>(std::move(base));
  }
  PagedArray(const PagedArray& other)
      : size_(other.size_),
        initial_(other.initial_),
        touched_pages_(other.touched_pages_),
        base_(other.base_),
        pool_(other.pool_),
        groups_(other.groups_) {
    for (const BlockHandle group : groups_)
      if (group != 0) pool_->groups.hold(group);
  }
  PagedArray(PagedArray&& other) noexcept { swap(other); }
  PagedArray& operator=(const PagedArray& other) {
    if (pool_ != other.pool_ || base_ != other.base_ || groups_.size() != other.groups_.size()) {
      PagedArray copy(other);
      swap(copy);
      return *this;
    }
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i] == other.groups_[i]) continue;
      if (other.groups_[i] != 0) pool_->groups.hold(other.groups_[i]);
      if (groups_[i] != 0) pool_->release_group(groups_[i]);
      groups_[i] = other.groups_[i];
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
    for (const BlockHandle group : groups_)
      if (group != 0) pool_->release_group(group);
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
    BlockHandle& page = own_group(index)[index / kPage % Pool::kGroup];
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
    if (const BlockHandle group = groups_[index / kSpan]; group != 0) pool_->groups.fetch(group);
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
  /// All values; what was never written to is shared with the base.
  [[nodiscard]] Base values() const {
    Base values = base_ ? *base_ : Base(size_, initial_);
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      if (groups_[group] == 0) continue;
      for (std::size_t first = group * kSpan; first < std::min(size_, (group + 1) * kSpan); first += kPage)
        if (touched(first))
          for (std::size_t i = first; i < std::min(size_, first + kPage); ++i) values[i] = (*this)[i];
    }
    return values;
  }
  /// Bytes of the pages that this copy reaches, shared or not.
  [[nodiscard]] std::size_t page_bytes() const { return touched_pages_ * BlockPool<Page>::kBlockBytes; }
  /// Bytes of its own: names of groups.
  [[nodiscard]] std::size_t table_bytes() const { return groups_.size() * sizeof(BlockHandle); }

 private:
  static constexpr std::size_t kSpan = Pool::kPage * Pool::kGroup;  // values of a group

  [[nodiscard]] BlockHandle page_handle(std::size_t index) const {
    const BlockHandle group = groups_[index / kSpan];
    return group != 0 ? pool_->groups[group][index / kPage % Pool::kGroup] : 0;
  }
  /// The group of `index`, held by nobody else.
  Group& own_group(std::size_t index) {
    BlockHandle& group = groups_[index / kSpan];
    if (group == 0) {
      group = pool_->groups.make();
      pool_->groups[group].fill(0);
    } else if (pool_->groups.shared(group)) {
      group = pool_->clone_group(group);
    }
    return pool_->groups[group];
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
    std::swap(groups_, other.groups_);
  }

  std::size_t size_ = 0;
  T initial_{};
  std::size_t touched_pages_ = 0;
  std::shared_ptr<const Base> base_;  // nullptr: all are initial_
  std::shared_ptr<Pool> pool_;        // of the whole family
  std::vector<BlockHandle> groups_;  // 0 = untouched
};

}  // namespace replan

// A long array in pages that copies share until one of them writes: what makes key frames of a search cheap.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace replan {

/// Counts the bytes of all pages of a family of arrays, each page once, whoever shares it.
using PageMeter = std::shared_ptr<std::atomic<std::size_t>>;

/// An array of `size` values that starts out all `initial`. Copying it copies pointers to groups of pages
/// only; a page is cloned when it is written to while another copy holds it. Untouched pages take no memory.
/// Assigning a copy that shares most groups costs no more than comparing the pointers. Copies may go to other
/// threads, one copy to one thread.
template <class T>
class PagedArray {
 public:
  /// Values of a page. Small, since a frontier that passes over the pages leaves a clone of each of them in
  /// every key frame.
  static constexpr std::size_t kPage = 32;

  PagedArray() = default;
  explicit PagedArray(std::size_t size, T initial = T{},
                      PageMeter meter = std::make_shared<std::atomic<std::size_t>>())
      : size_(size),
        initial_(initial),
        meter_(std::move(meter)),
        groups_((size + kPage * kGroup - 1) / (kPage * kGroup)) {}
  PagedArray(const PagedArray& other)
      : size_(other.size_),
        initial_(other.initial_),
        touched_pages_(other.touched_pages_),
        meter_(other.meter_),
        groups_(other.groups_) {
    for (Group* group : groups_) hold(group);
  }
  PagedArray(PagedArray&& other) noexcept { swap(other); }
  PagedArray& operator=(const PagedArray& other) {
    if (meter_ != other.meter_ || groups_.size() != other.groups_.size()) {
      PagedArray copy(other);
      swap(copy);
      return *this;
    }
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i] == other.groups_[i]) continue;
      hold(other.groups_[i]);
      release(std::exchange(groups_[i], other.groups_[i]));
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
    for (Group* group : groups_) release(group);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T initial() const { return initial_; }
  [[nodiscard]] T operator[](std::size_t index) const {
    const T* values = page(index);
    return values != nullptr ? values[index % kPage] : initial_;
  }
  /// A reference to write through, valid until the array is copied.
  T& at(std::size_t index) {
    Group*& group = groups_[index / (kPage * kGroup)];
    if (group == nullptr)
      group = make<Group>();
    else if (group->shared())
      group = clone(group);
    Page*& page = group->pages[index / kPage % kGroup];
    if (page == nullptr) {
      page = make<Page>();
      page->values.fill(initial_);
      ++touched_pages_;
    } else if (page->shared()) {
      page = clone(page);
    }
    return page->values[index % kPage];
  }
  /// Pages that exist, shared or not: what a reader that wants to skip untouched stretches asks.
  [[nodiscard]] bool touched(std::size_t index) const { return page(index) != nullptr; }
  /// The page that holds `index`, kPage values from a multiple of kPage on; nullptr if untouched. Valid until
  /// written to.
  [[nodiscard]] const T* page(std::size_t index) const {
    const Group* group = groups_[index / (kPage * kGroup)];
    const Page* held = group != nullptr ? group->pages[index / kPage % kGroup] : nullptr;
    return held != nullptr ? held->values.data() : nullptr;
  }
  /// Bytes of the pages that this copy reaches, shared or not.
  [[nodiscard]] std::size_t page_bytes() const { return touched_pages_ * sizeof(Page); }
  /// Bytes of its own: pointers.
  [[nodiscard]] std::size_t table_bytes() const { return groups_.size() * sizeof(Group*); }

 private:
  static constexpr std::size_t kGroup = 32;

  /// Counts who holds it. Whoever finds itself the only holder may write: nobody else can come to hold it.
  struct Held {
    std::atomic<std::uint32_t> holders = 1;
    [[nodiscard]] bool shared() const { return holders.load(std::memory_order_acquire) > 1; }
    /// True if nobody is left.
    bool let_go() { return holders.fetch_sub(1, std::memory_order_acq_rel) == 1; }
  };
  struct Page : Held {
    std::array<T, kPage> values;
  };
  struct Group : Held {
    std::array<Page*, kGroup> pages{};
  };

  template <class Block>
  Block* make() {
    auto* block = new Block;
    meter_->fetch_add(sizeof(Block), std::memory_order_relaxed);
    return block;
  }
  template <class Block>
  static void hold(Block* block) {
    if (block != nullptr) block->holders.fetch_add(1, std::memory_order_relaxed);
  }
  Page* clone(Page* page) {
    Page* copy = make<Page>();
    copy->values = page->values;
    release(page);
    return copy;
  }
  Group* clone(Group* group) {
    auto* copy = make<Group>();
    copy->pages = group->pages;
    for (Page* page : copy->pages) hold(page);
    release(group);
    return copy;
  }
  void release(Page* page) {
    if (page == nullptr || !page->let_go()) return;
    delete page;
    meter_->fetch_sub(sizeof(Page), std::memory_order_relaxed);
  }
  void release(Group* group) {
    if (group == nullptr || !group->let_go()) return;
    for (Page* page : group->pages) release(page);
    delete group;
    meter_->fetch_sub(sizeof(Group), std::memory_order_relaxed);
  }
  void swap(PagedArray& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(initial_, other.initial_);
    std::swap(touched_pages_, other.touched_pages_);
    std::swap(meter_, other.meter_);
    std::swap(groups_, other.groups_);
  }

  std::size_t size_ = 0;
  T initial_{};
  std::size_t touched_pages_ = 0;
  PageMeter meter_;
  std::vector<Group*> groups_;
};

}  // namespace replan

// A long array in pages that copies share until one of them writes: what makes key frames of a search cheap.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace replan {

/// An array of `size` values that starts out all `initial`. Copying it copies page pointers only; a page is
/// cloned when it is written to while another copy holds it. Untouched pages take no memory. Not for
/// concurrent use: copies that share pages belong to one thread.
template <class T>
class PagedArray {
 public:
  static constexpr std::size_t kPage = 1024;

  PagedArray() = default;
  explicit PagedArray(std::size_t size, T initial = T{})
      : size_(size), initial_(initial), pages_((size + kPage - 1) / kPage) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T initial() const { return initial_; }
  [[nodiscard]] T operator[](std::size_t index) const {
    const auto& page = pages_[index / kPage];
    return page ? (*page)[index % kPage] : initial_;
  }
  /// A reference to write through, valid until the array is copied.
  T& at(std::size_t index) {
    auto& page = pages_[index / kPage];
    if (!page) {
      page = std::make_shared<Page>();
      page->fill(initial_);
    } else if (page.use_count() > 1) {
      page = std::make_shared<Page>(*page);
    }
    return (*page)[index % kPage];
  }
  /// Pages that exist, shared or not: what a reader that wants to skip untouched stretches asks.
  [[nodiscard]] bool touched(std::size_t index) const { return pages_[index / kPage] != nullptr; }
  /// The page that holds `index`, kPage values from a multiple of kPage on; nullptr if untouched. Valid until
  /// written to.
  [[nodiscard]] const T* page(std::size_t index) const {
    const auto& held = pages_[index / kPage];
    return held ? held->data() : nullptr;
  }
  /// Bytes held by this copy alone; pages shared with other copies are not counted.
  [[nodiscard]] std::size_t own_bytes() const {
    std::size_t bytes = pages_.size() * sizeof(pages_[0]);
    for (const auto& page : pages_)
      if (page && page.use_count() == 1) bytes += sizeof(Page);
    return bytes;
  }

 private:
  using Page = std::array<T, kPage>;

  std::size_t size_ = 0;
  T initial_{};
  std::vector<std::shared_ptr<Page>> pages_;
};

}  // namespace replan

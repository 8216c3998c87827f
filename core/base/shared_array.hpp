// An array that copies share, piece by piece, until one of them writes: what makes versions of a document
// cheap.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace replan {

/// Values in chunks of `kChunk`, a power of two. Copying copies the names of the chunks; a chunk is cloned
/// when it is written to while another copy holds it. Copies may be read, written and dropped on different
/// threads, each of them on one at a time.
template <class T, std::size_t kChunk>
class SharedArray {
  static_assert((kChunk & (kChunk - 1)) == 0);

  /// A chunk that counts who holds it. Not a std::shared_ptr, whose count cannot be asked in a way that
  /// orders what another thread has read before it let go with what is written afterwards.
  struct Chunk {
    std::vector<T> values;
    std::atomic<std::uint32_t> holders{1};
  };
  class Holder {
   public:
    explicit Holder(std::vector<T> values) : chunk_(new Chunk{std::move(values)}) {}
    Holder(const Holder& other) noexcept : chunk_(other.chunk_) {
      chunk_->holders.fetch_add(1, std::memory_order_relaxed);
    }
    Holder(Holder&& other) noexcept : chunk_(std::exchange(other.chunk_, nullptr)) {}
    Holder& operator=(Holder other) noexcept {
      std::swap(chunk_, other.chunk_);
      return *this;
    }
    ~Holder() {
      if (chunk_ != nullptr && chunk_->holders.fetch_sub(1, std::memory_order_acq_rel) == 1) delete chunk_;
    }
    [[nodiscard]] const std::vector<T>& values() const { return chunk_->values; }
    /// To write to: a clone if another copy holds the chunk too.
    [[nodiscard]] std::vector<T>& own() {
      if (chunk_->holders.load(std::memory_order_acquire) != 1) *this = Holder(chunk_->values);
      return chunk_->values;
    }
    friend bool operator==(const Holder& a, const Holder& b) { return a.chunk_ == b.chunk_; }

   private:
    Chunk* chunk_;
  };

 public:
  using value_type = T;

  class const_iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;

    const_iterator() = default;
    const_iterator(const SharedArray* array, std::size_t index) : array_(array), index_(index) {}
    reference operator*() const { return (*array_)[index_]; }
    pointer operator->() const { return &(*array_)[index_]; }
    reference operator[](difference_type by) const { return *(*this + by); }
    const_iterator& operator++() { return *this += 1; }
    const_iterator& operator--() { return *this += -1; }
    const_iterator operator++(int) { return std::exchange(*this, *this + 1); }
    const_iterator operator--(int) { return std::exchange(*this, *this - 1); }
    const_iterator& operator+=(difference_type by) {
      index_ = static_cast<std::size_t>(static_cast<difference_type>(index_) + by);
      return *this;
    }
    const_iterator& operator-=(difference_type by) { return *this += -by; }
    friend const_iterator operator+(const_iterator i, difference_type by) { return i += by; }
    friend const_iterator operator+(difference_type by, const_iterator i) { return i += by; }
    friend const_iterator operator-(const_iterator i, difference_type by) { return i -= by; }
    friend difference_type operator-(const const_iterator& a, const const_iterator& b) {
      return static_cast<difference_type>(a.index_) - static_cast<difference_type>(b.index_);
    }
    friend bool operator==(const const_iterator& a, const const_iterator& b) { return a.index_ == b.index_; }
    friend auto operator<=>(const const_iterator& a, const const_iterator& b) {
      return a.index_ <=> b.index_;
    }

   private:
    const SharedArray* array_ = nullptr;
    std::size_t index_ = 0;
  };
  using iterator = const_iterator;

  /// Stands for a value that can be assigned to.
  class Reference {
   public:
    Reference(SharedArray& array, std::size_t index) : array_(array), index_(index) {}
    Reference(const Reference&) = default;
    const Reference& operator=(const T& value) const {
      array_.edit(index_) = value;
      return *this;
    }
    const Reference& operator=(const Reference& other) const { return *this = static_cast<const T&>(other); }
    operator const T&() const { return std::as_const(array_)[index_]; }

   private:
    SharedArray& array_;
    std::size_t index_;
  };

  SharedArray() = default;
  explicit SharedArray(std::size_t count, const T& value = T{}) { assign(count, value); }
  SharedArray(std::initializer_list<T> values) : SharedArray(std::vector<T>(values)) {}
  SharedArray(const std::vector<T>& values) : size_(values.size()) {
    for (std::size_t first = 0; first < size_; first += kChunk) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
      chunks_.emplace_back(
          std::vector<T>(begin, begin + static_cast<std::ptrdiff_t>(std::min(kChunk, size_ - first))));
    }
  }

  void assign(std::size_t count, const T& value) {
    chunks_.clear();
    size_ = count;
    if (count >= kChunk) chunks_.assign(count / kChunk, Holder(std::vector<T>(kChunk, value)));
    if (count % kChunk != 0) chunks_.emplace_back(std::vector<T>(count % kChunk, value));
  }
  void clear() { assign(0, T{}); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const T& operator[](std::size_t index) const {
    return chunks_[index / kChunk].values()[index % kChunk];
  }
  [[nodiscard]] Reference operator[](std::size_t index) { return {*this, index}; }
  [[nodiscard]] const T& front() const { return (*this)[0]; }
  [[nodiscard]] const T& back() const { return (*this)[size_ - 1]; }
  [[nodiscard]] const_iterator begin() const { return {this, 0}; }
  [[nodiscard]] const_iterator end() const { return {this, size_}; }
  /// The values from `index` on that lie together.
  [[nodiscard]] std::span<const T> stretch(std::size_t index) const {
    return std::span<const T>(chunks_[index / kChunk].values()).subspan(index % kChunk);
  }
  [[nodiscard]] std::vector<T> plain() const { return {begin(), end()}; }

  /// A value to write to, valid until the array is copied.
  [[nodiscard]] T& edit(std::size_t index) { return chunks_[index / kChunk].own()[index % kChunk]; }
  T& push_back(T value) {
    if (size_ % kChunk == 0) chunks_.emplace_back(std::vector<T>());
    ++size_;
    return chunks_.back().own().emplace_back(std::move(value));
  }
  T& emplace_back() { return push_back(T{}); }
  void pop_back() { truncate(size_ - 1); }
  /// Keeps the first `size` values.
  void truncate(std::size_t size) {
    if (size >= size_) return;
    const auto chunks = static_cast<std::ptrdiff_t>((size + kChunk - 1) / kChunk);
    chunks_.erase(chunks_.begin() + chunks, chunks_.end());
    if (size % kChunk != 0) {
      std::vector<T>& last = chunks_.back().own();
      last.erase(last.begin() + static_cast<std::ptrdiff_t>(size % kChunk), last.end());
    }
    size_ = size;
  }
  void erase(std::size_t index) {
    std::vector<T> behind(begin() + static_cast<std::ptrdiff_t>(index) + 1, end());
    truncate(index);
    for (T& value : behind) push_back(std::move(value));
  }

  /// Calls `visit(first, a, b)` for all stretches that two arrays of one size do not share: values may differ
  /// there.
  template <class Visit>
  static void each_unshared(const SharedArray& a, const SharedArray& b, Visit&& visit) {
    for (std::size_t chunk = 0; chunk < a.chunks_.size(); ++chunk)
      if (!(a.chunks_[chunk] == b.chunks_[chunk]))
        visit(chunk * kChunk, std::span<const T>(a.chunks_[chunk].values()),
              std::span<const T>(b.chunks_[chunk].values()));
  }
  /// How many values two arrays begin with in common.
  [[nodiscard]] static std::size_t common(const SharedArray& a, const SharedArray& b) {
    std::size_t chunk = 0;
    const std::size_t chunks = std::min(a.chunks_.size(), b.chunks_.size());
    while (chunk < chunks && a.chunks_[chunk] == b.chunks_[chunk]) ++chunk;
    std::size_t index = std::min(chunk * kChunk, std::min(a.size_, b.size_));
    while (index < a.size_ && index < b.size_ && a[index] == b[index]) ++index;
    return index;
  }
  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t chunk = 0; chunk < a.chunks_.size(); ++chunk)
      if (!(a.chunks_[chunk] == b.chunks_[chunk]) && a.chunks_[chunk].values() != b.chunks_[chunk].values())
        return false;
    return true;
  }

 private:
  std::size_t size_ = 0;
  std::vector<Holder> chunks_;
};

/// Cells of a map, a byte each.
using SharedBytes = SharedArray<std::uint8_t, std::size_t{1} << 16>;

}  // namespace replan

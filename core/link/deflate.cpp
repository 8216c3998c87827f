#include "core/link/deflate.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <optional>

#include <zlib.h>

namespace replan {
namespace {

/// zlib counts what it is given in 32 bits.
constexpr std::size_t kMostGiven = std::numeric_limits<uInt>::max() / 2;

const Bytef* given(std::string_view bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

/// A stream that is being read.
class Inflater {
 public:
  explicit Inflater(std::string_view stream) {
    if (inflateInit(&state_) != Z_OK) throw std::bad_alloc();
    state_.next_in = const_cast<Bytef*>(given(stream));  // zlib only reads it
    state_.avail_in = static_cast<uInt>(stream.size());
  }
  ~Inflater() { inflateEnd(&state_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// The next bytes, as many as there is room for or are left; nothing if the stream is damaged or cut off.
  std::optional<std::size_t> read(char* into, std::size_t room) {
    state_.next_out = reinterpret_cast<Bytef*>(into);
    state_.avail_out = static_cast<uInt>(room);
    while (!ended_ && state_.avail_out > 0) {
      const int outcome = inflate(&state_, Z_NO_FLUSH);
      ended_ = outcome == Z_STREAM_END;
      if (!ended_ && outcome != Z_OK) return std::nullopt;
    }
    return room - state_.avail_out;
  }
  [[nodiscard]] bool ended() const { return ended_; }
  /// Bytes behind the end of the stream.
  [[nodiscard]] std::size_t left() const { return state_.avail_in; }

 private:
  z_stream state_{};
  bool ended_ = false;
};

Error damaged() {
  return {"is damaged or cut off: copy the whole of it again"};
}

/// How many bytes a stream stands for.
Result<std::size_t> inflated_size(std::string_view stream, std::size_t most) {
  Inflater inflater(stream);
  std::array<char, std::size_t{1} << 14> window{};
  std::size_t size = 0;
  while (!inflater.ended()) {
    const auto read = inflater.read(window.data(), window.size());
    if (!read) return damaged();
    size += *read;
    if (size > most)
      return Error{"holds more than " + std::to_string(most >> 20) +
                   " MiB when it is unpacked, the most that is read"};
  }
  if (inflater.left() > 0) return damaged();
  return size;
}

}  // namespace

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string stream(size, '\0');
  // With room for the worst there is nothing but memory that it can lack.
  if (compress2(reinterpret_cast<Bytef*>(stream.data()), &size, given(bytes),
                static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  stream.resize(size);
  return stream;
}

Result<std::string> inflated(std::string_view stream, std::size_t most) {
  if (stream.size() > kMostGiven || most > kMostGiven) return Error{"is longer than any that is read"};
  const Result<std::size_t> size = inflated_size(stream, most);
  if (!size) return Error{size.error()};
  std::string bytes(*size, '\0');
  Inflater inflater(stream);
  const auto read = inflater.read(bytes.data(), bytes.size());
  if (!read || *read != bytes.size()) return damaged();
  return bytes;
}

}  // namespace replan

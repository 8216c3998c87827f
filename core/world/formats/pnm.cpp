#include "core/world/formats/pnm.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/cell.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

constexpr std::int64_t kDeepest = 65535;
constexpr std::int64_t kAnySide = INT64_MAX;  // what is too large is told by number of pixels

/// Reads one PBM, PGM or PPM, keeping the place for errors.
template <class Value>
class PnmParser {
 public:
  PnmParser(std::string_view bytes, const std::string& origin, std::int64_t most)
      : bytes_(bytes), origin_(origin), most_(most) {}

  Result<PictureOf<Value>> parse() {
    const char kind = bytes_[1];
    at_ = 2;
    bits_ = kind == '1' || kind == '4';
    if (bits_) deepest_ = 1;
    std::int64_t width = 0, height = 0;
    if (Result<void> read = read_header("width", width, kAnySide); !read) return Error{read.error()};
    if (Result<void> read = read_header("height", height, kAnySide); !read) return Error{read.error()};
    if (width > most_ / height) return too_many_pixels(origin_, width, height, most_);
    if (!bits_)
      if (Result<void> read = read_header("largest value", deepest_, kDeepest); !read)
        return Error{read.error()};
    PictureOf<Value> picture{
        static_cast<int>(width), static_cast<int>(height), kind == '3' || kind == '6' ? 3 : 1, {}};
    const std::size_t count = picture.pixels() * static_cast<std::size_t>(picture.channels);
    Result<void> read = kind < '4'    ? read_plain(picture.values, count)
                        : kind == '4' ? read_bits(picture.values, picture.width, count)
                                      : read_raw(picture.values, count);
    if (!read) return Error{read.error()};
    return picture;
  }

 private:
  Error wrong(const std::string& what) const { return {origin_ + ":" + std::to_string(line_) + ": " + what}; }

  /// Passes over blanks and comments, which run from # to the end of the line.
  void skip_blanks() {
    for (bool comment = false; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      comment = c == '#' || (comment && c != '\n');
      if (!comment && !is_blank(c) && c != '\n') return;
      line_ += c == '\n' ? 1 : 0;
    }
  }

  std::string_view next_word() {
    skip_blanks();
    const std::size_t from = at_;
    while (at_ < bytes_.size() && !is_blank(bytes_[at_]) && bytes_[at_] != '\n' && bytes_[at_] != '#') ++at_;
    return bytes_.substr(from, at_ - from);
  }

  Result<void> read_header(const char* name, std::int64_t& value, std::int64_t high) {
    const std::string_view word = next_word();
    const auto number = number_from<std::int64_t>(word);
    if (!number || *number < 1 || *number > high)
      return wrong(std::string("the picture's ") + name + " must be a whole number from 1" +
                   (high < kAnySide ? " to " + std::to_string(high) : std::string()) + ", not " +
                   shown(word));
    value = *number;
    return {};
  }

  /// A bit of a plain PBM: a digit, whether blanks stand between them or not.
  std::string_view next_bit() {
    skip_blanks();
    const std::size_t from = at_;
    at_ = std::min(at_ + 1, bytes_.size());
    return bytes_.substr(from, at_ - from);
  }

  static constexpr Value kWhite = std::numeric_limits<Value>::max();

  [[nodiscard]] Value scaled(std::int64_t value) const {
    return static_cast<Value>((value * kWhite + deepest_ / 2) / deepest_);
  }

  static Value shade_of_bit(bool bit) { return bit ? Value{0} : kWhite; }

  Result<void> read_plain(std::vector<Value>& values, std::size_t count) {
    // A byte a value at least: what is not there needs no memory.
    values.reserve(std::min(count, bytes_.size() - at_));
    while (values.size() < count) {
      const std::string_view word = bits_ ? next_bit() : next_word();
      if (word.empty())
        return wrong("the file ends after " + std::to_string(values.size()) + " of " + std::to_string(count) +
                     " values");
      const auto value = number_from<std::int64_t>(word);
      if (!value || *value < 0 || *value > deepest_)
        return wrong("a value must be a whole number from 0 to " + std::to_string(deepest_) + ", not " +
                     shown(word));
      values.push_back(bits_ ? shade_of_bit(*value != 0) : scaled(*value));
    }
    return {};
  }

  /// Eight pixels a byte, the first in the highest bit; each row begins with a byte of its own.
  Result<void> read_bits(std::vector<Value>& values, int width, std::size_t count) {
    const std::string_view rest = bytes_.substr(std::min(at_ + 1, bytes_.size()));
    const auto columns = static_cast<std::size_t>(width);
    const std::size_t stride = (columns + 7) / 8, rows = count / columns;
    if (rest.size() < stride * rows)
      return Error{origin_ + ": the file ends after " + std::to_string(rest.size() / stride) + " of " +
                   std::to_string(rows) + " rows"};
    values.reserve(count);
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < columns; ++x) {
        const auto byte = static_cast<unsigned char>(rest[y * stride + x / 8]);
        values.push_back(shade_of_bit((byte >> (7 - x % 8) & 1u) != 0));
      }
    return {};
  }

  Result<void> read_raw(std::vector<Value>& values, std::size_t count) {
    const std::size_t wide = deepest_ > 255 ? 2 : 1;
    // One blank parts the header from the values; a second one would be a value.
    const std::string_view rest = bytes_.substr(std::min(at_ + 1, bytes_.size()));
    if (rest.size() < count * wide)
      return Error{origin_ + ": the file ends after " + std::to_string(rest.size() / wide) + " of " +
                   std::to_string(count) + " values"};
    values.resize(count);
    const auto* byte = reinterpret_cast<const unsigned char*>(rest.data());
    for (std::size_t i = 0; i < count; ++i) {
      const int value = wide == 1 ? byte[i] : byte[2 * i] << 8 | byte[2 * i + 1];
      if (value > deepest_)
        return Error{origin_ + ": value " + std::to_string(i + 1) + " is " + std::to_string(value) +
                     ", more than the largest value " + std::to_string(deepest_) + " of the header"};
      values[i] = scaled(value);
    }
    return {};
  }

  std::string_view bytes_;
  const std::string& origin_;
  std::int64_t most_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::int64_t deepest_ = 255;
  bool bits_ = false;  // a PBM, without a largest value
};

std::string_view without_mark_of_plain(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  return text.size() > 1 && text[1] >= '1' && text[1] <= '3' ? text : bytes;
}

template <class Value>
Result<PictureOf<Value>> decode_to(std::string_view bytes, const std::string& origin, std::int64_t most) {
  if (!is_pnm(bytes))
    return Error{origin + ":1: not a PBM, PGM or PPM picture: it must begin with P1, P2, ... or P6"};
  return PnmParser<Value>(without_mark_of_plain(bytes), origin, most).parse();
}

}  // namespace

bool is_pnm(std::string_view bytes) {
  bytes = without_mark_of_plain(bytes);
  return bytes.size() >= 3 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
         (is_blank(bytes[2]) || bytes[2] == '\n' || bytes[2] == '#');
}

Result<Picture> decode_pnm(std::string_view bytes, const std::string& origin, std::int64_t most) {
  return decode_to<std::uint8_t>(bytes, origin, most);
}

Result<DeepPicture> decode_deep_pnm(std::string_view bytes, const std::string& origin, std::int64_t most) {
  return decode_to<std::uint16_t>(bytes, origin, most);
}

std::string pgm_text(const Picture& picture) {
  std::string text =
      "P5\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
  text.append(reinterpret_cast<const char*>(picture.values.data()), picture.values.size());
  return text;
}

}  // namespace replan

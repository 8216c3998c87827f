#include "core/world/pnm.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "core/base/cell.hpp"
#include "core/world/text_lines.hpp"

namespace replan {
namespace {

constexpr std::int64_t kDeepest = 65535;

/// Reads one PGM or PPM, keeping the place for errors.
class PnmParser {
 public:
  PnmParser(std::string_view bytes, const std::string& origin) : bytes_(bytes), origin_(origin) {}

  Result<Picture> parse() {
    const char kind = bytes_[1];
    at_ = 2;
    const bool plain = kind == '2' || kind == '3';
    std::int64_t width = 0, height = 0;
    for (const auto& [name, value, high] :
         {std::tuple{"width", &width, kMaxCells}, std::tuple{"height", &height, kMaxCells},
          std::tuple{"largest value", &deepest_, kDeepest}}) {
      if (Result<void> read = read_header(name, *value, high); !read) return Error{read.error()};
      if (value == &height && width > kMaxCells / height) return too_many_pixels(origin_, width, height);
    }
    Picture picture{
        static_cast<int>(width), static_cast<int>(height), kind == '2' || kind == '5' ? 1 : 3, {}};
    const std::size_t count = picture.pixels() * static_cast<std::size_t>(picture.channels);
    if (Result<void> read = plain ? read_plain(picture.values, count) : read_raw(picture.values, count);
        !read)
      return Error{read.error()};
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
      return wrong(std::string("the picture's ") + name + " must be a whole number from 1 to " +
                   std::to_string(high) + ", not " + shown(word));
    value = *number;
    return {};
  }

  [[nodiscard]] std::uint8_t scaled(std::int64_t value) const {
    return static_cast<std::uint8_t>((value * 255 + deepest_ / 2) / deepest_);
  }

  Result<void> read_plain(std::vector<std::uint8_t>& values, std::size_t count) {
    // Two bytes a value at least: what is not there needs no memory.
    values.reserve(std::min(count, (bytes_.size() - at_) / 2));
    while (values.size() < count) {
      const std::string_view word = next_word();
      if (word.empty())
        return wrong("the file ends after " + std::to_string(values.size()) + " of " + std::to_string(count) +
                     " values");
      const auto value = number_from<std::int64_t>(word);
      if (!value || *value < 0 || *value > deepest_)
        return wrong("a value must be a whole number from 0 to " + std::to_string(deepest_) + ", not " +
                     shown(word));
      values.push_back(scaled(*value));
    }
    return {};
  }

  Result<void> read_raw(std::vector<std::uint8_t>& values, std::size_t count) {
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
  std::size_t at_ = 0;
  int line_ = 1;
  std::int64_t deepest_ = 255;
};

}  // namespace

bool is_pnm(std::string_view bytes) {
  return bytes.size() >= 3 && bytes[0] == 'P' &&
         std::string_view("2356").find(bytes[1]) != std::string_view::npos &&
         (is_blank(bytes[2]) || bytes[2] == '\n' || bytes[2] == '#');
}

Result<Picture> decode_pnm(std::string_view bytes, const std::string& origin) {
  if (!is_pnm(bytes))
    return Error{origin + ":1: not a PGM or PPM picture: it must begin with P2, P3, P5 or P6"};
  return PnmParser(bytes, origin).parse();
}

std::string pgm_text(const Picture& picture) {
  std::string text =
      "P5\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
  text.append(reinterpret_cast<const char*>(picture.values.data()), picture.values.size());
  return text;
}

}  // namespace replan

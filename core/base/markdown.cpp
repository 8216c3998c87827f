#include "core/base/markdown.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace replan {
namespace {

struct Mark {
  std::string_view sign;
  MarkdownFace face;
};
/// Longer ones first.
constexpr std::array<Mark, 3> kMarks = {
    {{"**", MarkdownFace::strong}, {"*", MarkdownFace::emphasis}, {"`", MarkdownFace::code}}};

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

/// Where the mark that begins at `at` is closed, or npos if it is none.
std::size_t closing(std::string_view text, std::size_t at, const Mark& mark) {
  const std::size_t inside = at + mark.sign.size();
  const bool within_word = at > 0 && is_word(text[at - 1]);
  if (within_word || inside >= text.size() || is_blank(text[inside])) return std::string_view::npos;
  for (std::size_t end = text.find(mark.sign, inside + 1); end != std::string_view::npos;
       end = text.find(mark.sign, end + 1)) {
    const std::size_t behind = end + mark.sign.size();
    const bool goes_on = mark.face != MarkdownFace::code && behind < text.size() && is_word(text[behind]);
    // The star of a name ("D* Lite", with a capital before it) closes nothing.
    const bool of_name =
        mark.face == MarkdownFace::emphasis && std::isupper(static_cast<unsigned char>(text[end - 1])) != 0;
    if (!is_blank(text[end - 1]) && text[end - 1] != '\\' && !goes_on && !of_name) return end;
  }
  return std::string_view::npos;
}

class Spans {
 public:
  explicit Spans(std::string_view text) : text_(text) {}

  std::vector<MarkdownSpan> read() {
    while (at_ < text_.size())
      if (!take_escape() && !take_marked()) plain_ += text_[at_++];
    flush();
    return std::move(spans_);
  }

 private:
  bool take_escape() {
    constexpr std::string_view kSigns = "*`\\";
    if (text_[at_] != '\\' || at_ + 1 >= text_.size() ||
        kSigns.find(text_[at_ + 1]) == std::string_view::npos)
      return false;
    plain_ += text_[at_ + 1];
    at_ += 2;
    return true;
  }

  bool take_marked() {
    for (const Mark& mark : kMarks) {
      if (!text_.substr(at_).starts_with(mark.sign)) continue;
      const std::size_t end = closing(text_, at_, mark);
      if (end == std::string_view::npos) continue;
      flush();
      const std::size_t inside = at_ + mark.sign.size();
      spans_.push_back({mark.face, std::string(text_.substr(inside, end - inside))});
      at_ = end + mark.sign.size();
      return true;
    }
    return false;
  }

  void flush() {
    if (!plain_.empty()) spans_.push_back({MarkdownFace::plain, std::exchange(plain_, {})});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string plain_;
  std::vector<MarkdownSpan> spans_;
};

}  // namespace

std::vector<MarkdownSpan> markdown_spans(std::string_view text) {
  return Spans(text).read();
}

std::string without_markdown(std::string_view text) {
  std::string plain;
  for (const MarkdownSpan& span : markdown_spans(text)) plain += span.text;
  return plain;
}

}  // namespace replan

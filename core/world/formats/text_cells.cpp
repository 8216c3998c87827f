#include "core/world/formats/text_cells.hpp"

#include <algorithm>

#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

constexpr std::string_view kOpening = "[{", kClosing = "]}";
constexpr std::string_view kShownFree = ".0-_";  // letters for free cells that can be seen

bool is_in(std::string_view set, char c) {
  return set.find(c) != std::string_view::npos;
}

/// The next row without its end, blanks at the end kept.
std::string_view take_row(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  std::string_view row = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  if (row.ends_with('\r')) row.remove_suffix(1);
  return row;
}

std::string_view without_end_blanks(std::string_view row) {
  return row.substr(0, row.find_last_not_of(' ') + 1);
}

/// Every second column blank in rows of the same odd length above 1.
bool every_second_is_blank(std::string_view text, bool trailing_blanks) {
  std::size_t width = 0;
  bool letters = false, shown_free = false;
  while (!text.empty()) {
    std::string_view row = take_row(text);
    if (row.empty()) continue;
    if (trailing_blanks) row = without_end_blanks(row);
    if (width == 0) width = row.size();
    if (row.size() != width || width < 3 || width % 2 == 0) return false;
    for (std::size_t x = 0; x < width; ++x) {
      if (x % 2 == 1 && row[x] != ' ') return false;
      if (x % 2 == 0 && row[x] == ' ' && trailing_blanks) return false;
      letters |= row[x] != ' ';
      shown_free |= is_in(kShownFree, row[x]);
    }
  }
  return letters && (shown_free || !trailing_blanks);
}

/// A number as programs print them: no zeros before it.
bool is_printed_number(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  if (word.size() > 1 && word[0] == '0' && word[1] >= '0' && word[1] <= '9') return false;
  return !word.empty() && word[0] >= '0' && word[0] <= '9' && number_from<double>(word).has_value();
}

/// All words are numbers (or S and G), some stand side by side, and there is a 0: so blanks are no cells.
bool words_are_numbers(std::string_view text) {
  bool zero = false, side_by_side = false;
  while (!text.empty()) {
    std::string_view row = take_row(text);
    for (int count = 0;; ++count) {
      const std::string_view word = take_word(row);
      if (word.empty()) break;
      const bool number = is_printed_number(word);
      if (!number && word != "S" && word != "G") return false;
      zero |= number && number_from<double>(word) == 0;
      side_by_side |= count > 0;
    }
  }
  return zero && side_by_side;
}

/// The cells of a text with brackets: from the first to the one that closes it, or to the end if none does.
TextLayout bracket_layout(std::string_view text) {
  TextLayout layout{.parting = Parting::brackets, .begin = text.find_first_of(kOpening), .end = text.size()};
  layout.begin = std::min(layout.begin, text.size());
  int depth = 0;
  for (std::size_t i = layout.begin; i < text.size(); ++i) {
    depth += is_in(kOpening, text[i]) ? 1 : is_in(kClosing, text[i]) ? -1 : 0;
    layout.nested |= depth > 1;
    if (text[i] == ',') layout.separator = ',';
    if (depth > 0) continue;
    layout.end = i + 1;
    break;
  }
  return layout;
}

}  // namespace

TextLayout find_layout(std::string_view text) {
  if (text.find_first_of("[]{}") != std::string_view::npos) return bracket_layout(text);
  const auto parted = [&](Parting parting, char separator) {
    return TextLayout{.parting = parting, .separator = separator, .end = text.size()};
  };
  if (is_in(text, ',')) return parted(Parting::commas, ',');
  if (is_in(text, ';')) return parted(Parting::semicolons, ';');
  if (is_in(text, '\t')) return parted(Parting::tabs, '\t');
  if (every_second_is_blank(text, false)) return parted(Parting::every_second, 0);
  if (words_are_numbers(text)) return parted(Parting::words, 0);
  TextLayout layout = parted(Parting::nothing, 0);
  layout.trailing_blanks = every_second_is_blank(text, true);
  if (layout.trailing_blanks) layout.parting = Parting::every_second;
  return layout;
}

std::string parting_sentence(const TextLayout& layout) {
  switch (layout.parting) {
    case Parting::every_second:
      return "every second column is blank, so blanks part the cells";
    case Parting::words:
      return "blanks part the cells";
    case Parting::tabs:
      return "tabs part the cells";
    case Parting::commas:
      return "commas part the cells";
    case Parting::semicolons:
      return "semicolons part the cells";
    case Parting::brackets:
      return layout.separator == ',' ? "brackets part the rows and commas the cells"
                                     : "brackets part the rows and blanks the cells";
    case Parting::nothing:
      break;
  }
  return "";
}

CellScanner::CellScanner(std::string_view text, const TextLayout& layout)
    : text_(text.substr(0, layout.end)), layout_(layout), at_(layout.begin) {
  for (std::size_t i = 0; i < at_; ++i) {
    if (text_[i] != '\n') continue;
    ++line_;
    line_begin_ = i + 1;
  }
}

CellPiece CellScanner::piece(CellPiece::Kind kind, std::size_t from, std::string_view text) const {
  return {kind, text, line_, static_cast<int>(from - line_begin_) + 1};
}

CellPiece CellScanner::next() {
  const bool letters = layout_.parting == Parting::nothing || layout_.parting == Parting::every_second;
  return letters ? next_letter() : next_word();
}

CellPiece CellScanner::next_letter() {
  if (at_ == line_begin_) {
    if (at_ >= text_.size()) return piece(CellPiece::Kind::end, at_);
    std::string_view rest = text_.substr(at_);
    std::string_view row = take_row(rest);
    if (layout_.trailing_blanks) row = without_end_blanks(row);
    row_end_ = at_ + row.size();
  }
  if (at_ >= row_end_) {
    const CellPiece end = piece(CellPiece::Kind::row_end, row_end_);
    line_begin_ = at_ = std::min(text_.find('\n', row_end_), text_.size() - 1) + 1;
    ++line_;
    return end;
  }
  const std::size_t from = at_;
  const bool ascii = static_cast<unsigned char>(text_[from]) < 0x80;
  const std::size_t size = ascii ? 1 : first_character(text_.substr(from, row_end_ - from));
  const std::size_t step = layout_.parting == Parting::every_second ? 2 : size;
  at_ = std::min(from + step, row_end_);
  return piece(CellPiece::Kind::cell, from, text_.substr(from, size));
}

CellPiece CellScanner::end_row(std::size_t at) {
  in_row_ = separated_ = false;
  return piece(CellPiece::Kind::row_end, at);
}

/// A bracket opens a level or closes one, and a row with it.
CellPiece CellScanner::take_bracket(char bracket) {
  const std::size_t from = at_++;
  if (is_in(kOpening, bracket)) {
    if (++depth_ > 2)
      return piece(CellPiece::Kind::wrong, from, "brackets three deep: a map has rows and columns alone");
    if (in_row_ && !layout_.nested)
      return piece(CellPiece::Kind::wrong, from, "a bracket within a row of cells");
    separated_ = false;
    return next_word();
  }
  if (--depth_ < 0) return piece(CellPiece::Kind::wrong, from, "a bracket that nothing opened");
  if (layout_.nested && depth_ == 0) return next_word();
  return in_row_ || layout_.nested ? end_row(from) : next_word();
}

CellPiece CellScanner::next_word() {
  const bool bracketed = layout_.parting == Parting::brackets;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    const std::size_t from = at_;
    if (c == '\n') {
      const bool row = rows_end_with_lines() && (in_row_ || !bracketed);
      const CellPiece end = row ? end_row(from) : CellPiece{};
      line_begin_ = ++at_;
      ++line_;
      if (row) return end;
    } else if (c == ';' && bracketed) {
      ++at_;
      if (in_row_) return end_row(from);
    } else if (c == layout_.separator) {
      ++at_;
      if (layout_.nested && depth_ < 2) continue;  // between two rows
      if (!in_row_ || separated_)
        return piece(CellPiece::Kind::wrong, from, "an empty cell: write 0 for a free one");
      separated_ = true;
    } else if (is_blank(c)) {
      ++at_;
    } else if (bracketed && (is_in(kOpening, c) || is_in(kClosing, c))) {
      return take_bracket(c);
    } else {
      while (at_ < text_.size() && !is_blank(text_[at_]) && !is_in("\n,;[]{}", text_[at_])) ++at_;
      if (at_ == from) ++at_;  // a mark that parts nothing here
      if (layout_.nested && depth_ < 2)
        return piece(CellPiece::Kind::wrong, from, "a cell outside the brackets of a row");
      if (layout_.separator != 0 && in_row_ && !separated_)
        return piece(CellPiece::Kind::wrong, from, "two cells with nothing but blanks between them");
      in_row_ = true;
      separated_ = false;
      return piece(CellPiece::Kind::cell, from, text_.substr(from, at_ - from));
    }
  }
  if (in_row_) return end_row(at_);
  if (depth_ > 0) return piece(CellPiece::Kind::wrong, at_, "the file ends before a bracket is closed");
  return piece(CellPiece::Kind::end, at_);
}

}  // namespace replan

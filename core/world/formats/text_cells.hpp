// Where one cell of a text map ends and the next begins: the one place that decides what parts them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace replan {

/// What parts the cells of a text map.
enum class Parting : std::uint8_t {
  nothing,       ///< one letter a cell; the blank is a letter too
  every_second,  ///< one letter a cell, and every second column is blank
  words,         ///< a word a cell; blanks part them
  tabs,
  commas,
  semicolons,
  brackets,  ///< rows in brackets within brackets, or one pair of them around rows; commas or blanks in them
};

/// How a text is to be taken apart.
struct TextLayout {
  Parting parting = Parting::nothing;
  char separator = 0;            ///< between two cells there must be exactly one of these; 0: blanks part
  bool nested = false;           ///< each row has brackets of its own, wherever lines end
  std::size_t begin = 0;         ///< where the cells begin: behind words such as "grid = np.array("
  std::size_t end = 0;           ///< and where they end
  bool trailing_blanks = false;  ///< for every_second: blanks at the ends of rows are no cells
};

/// Finds out how the cells of a text are parted:
///  - by brackets, commas, semicolons or tabs, where there are any;
///  - by blanks, where the rows have an odd length above 1 and every second column is blank throughout (with
///    blanks at the ends of rows only if a letter for free cells shows that the blank is none), or where
///    all words are numbers and a 0 among them shows the same;
///  - by nothing otherwise.
TextLayout find_layout(std::string_view text);
/// "commas part the cells", for a note; empty if nothing does.
std::string parting_sentence(const TextLayout& layout);

/// A step through the cells of a text.
struct CellPiece {
  enum class Kind : std::uint8_t { cell, row_end, end, wrong } kind = Kind::end;
  std::string_view text = {};  ///< of a cell; of `wrong`: what is wrong, in the words of an error
  int line = 1;                ///< from 1
  int column = 1;              ///< from 1, in bytes
};

/// Goes through the cells of a text in order. A row's end comes after its last cell; an empty line is a row
/// without a cell.
class CellScanner {
 public:
  CellScanner(std::string_view text, const TextLayout& layout);
  CellPiece next();

 private:
  [[nodiscard]] CellPiece piece(CellPiece::Kind kind, std::size_t from, std::string_view text = {}) const;
  CellPiece next_letter();
  CellPiece next_word();
  CellPiece take_bracket(char bracket);
  CellPiece end_row(std::size_t at);
  [[nodiscard]] bool rows_end_with_lines() const { return !layout_.nested; }

  std::string_view text_;
  TextLayout layout_;
  std::size_t at_ = 0;
  std::size_t line_begin_ = 0;
  std::size_t row_end_ = 0;  // of letters: where the cells of the line end
  int line_ = 1;
  int depth_ = 0;           // of brackets
  bool in_row_ = false;     // something of the row has been seen
  bool separated_ = false;  // the last thing in the row was a separator
};

}  // namespace replan

// The little of Markdown that our own texts use within a paragraph: *emphasis*, **strong** and `code`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace replan {

enum class MarkdownFace : std::uint8_t { plain, emphasis, strong, code };

/// A stretch of text in one face.
struct MarkdownSpan {
  MarkdownFace face = MarkdownFace::plain;
  std::string text;
  friend bool operator==(const MarkdownSpan&, const MarkdownSpan&) = default;
};

/// The stretches of a paragraph, in order. A mark that is not closed, stands between blanks, or has a backslash before
/// it is a letter like any other: the star of "D* Lite" is one.
std::vector<MarkdownSpan> markdown_spans(std::string_view text);
/// The same without marks.
std::string without_markdown(std::string_view text);

}  // namespace replan

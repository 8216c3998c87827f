// Paragraphs with emphasis (see widgets.hpp).
#include "core/base/markdown.hpp"

#include <algorithm>
#include <vector>

#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// What stands between two blanks, or a part of it in a face of its own.
struct Word {
  std::string_view text;
  const ImFont* font;
  ImU32 colour;
  bool glued;  // no blank before it
};

Word styled(const Look& look, ImU32 colour, MarkdownFace face) {
  switch (face) {
    case MarkdownFace::plain:
      break;
    case MarkdownFace::emphasis:
      return {{}, look.fonts.ui, look.theme.text, false};
    case MarkdownFace::strong:
      return {{}, look.fonts.title, look.theme.text, false};
    case MarkdownFace::code:
      return {{}, look.fonts.mono, look.theme.text, false};
  }
  return {{}, look.fonts.ui, colour, false};
}

std::vector<Word> words_of(const Look& look, ImU32 colour, std::span<const MarkdownSpan> spans) {
  std::vector<Word> words;
  bool glued = true;
  for (const MarkdownSpan& span : spans) {
    Word word = styled(look, colour, span.face);
    std::string_view rest = span.text;
    while (!rest.empty()) {
      const std::size_t begin = std::min(rest.find_first_not_of(' '), rest.size());
      if (begin > 0) glued = false;
      rest.remove_prefix(begin);
      word.text = rest.substr(0, rest.find(' '));
      word.glued = glued;
      if (word.text.empty()) break;  // a blank at the end parts it from the next stretch
      words.push_back(word);
      glued = true;
      rest.remove_prefix(word.text.size());
    }
  }
  return words;
}

float line_height(const Look& look) {
  return look.fonts.ui->FontSize + look.px(4);
}

/// How wide a paragraph is: all the room there is, or `widest`.
float room_for(float whole, float widest) {
  return widest > 0 ? std::min(whole, widest) : whole;
}

/// Breaks the words into lines and calls `place` with each and where it stands. Returns the height.
template <class Place>
float lay_out(const Look& look, std::span<const Word> words, float room, Place&& place) {
  const float blank = text_width(look.fonts.ui, " ");
  float x = 0, y = 0;
  for (std::size_t i = 0; i < words.size();) {
    // Glued words stay on one line.
    std::size_t end = i + 1;
    float width = text_width(words[i].font, words[i].text);
    for (; end < words.size() && words[end].glued; ++end)
      width += text_width(words[end].font, words[end].text);
    if (x > 0 && !words[i].glued) x += blank;
    if (x > 0 && x + width > room) {
      x = 0;
      y += line_height(look);
    }
    for (; i < end; ++i) {
      place(words[i], ImVec2(x, y));
      x += text_width(words[i].font, words[i].text);
    }
  }
  return y + line_height(look);
}

}  // namespace

void marked_paragraph(const Look& look, ImU32 colour, std::string_view markdown, float widest) {
  const std::vector<MarkdownSpan> spans = markdown_spans(markdown);
  const float room = room_for(ImGui::GetContentRegionAvail().x, widest);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = lay_out(look, words_of(look, colour, spans), room, [&](const Word& word, ImVec2 at) {
    const float lower = (look.fonts.ui->FontSize - word.font->FontSize) * 0.5f;
    draw_text(list, word.font, {origin.x + at.x, origin.y + at.y + lower}, word.colour, word.text);
  });
  ImGui::Dummy({std::max(room, 1.0f), height});
}

float marked_paragraph_height(const Look& look, std::string_view markdown, float whole, float widest) {
  const std::vector<MarkdownSpan> spans = markdown_spans(markdown);
  return lay_out(look, words_of(look, 0, spans), room_for(whole, widest), [](const Word&, ImVec2) {});
}

}  // namespace replan::ui

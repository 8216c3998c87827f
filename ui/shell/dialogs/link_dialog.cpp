// A link to the moment that shows: the address that stands before it, how long it is, and the way to the clipboard.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/link/link.hpp"
#include "ui/keys.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

constexpr int kLinkLines = 5;

/// An address as it may stand before a link: without blanks, and without what follows its own #.
std::string bare_address(const std::string& typed) {
  std::string address;
  for (const char c : typed.substr(0, typed.find('#')))
    if (static_cast<unsigned char>(c) > ' ') address += c;
  return address;
}

/// A link's beginning and end, in so many lines of so many letters.
std::vector<std::string> link_lines(const std::string& link, std::size_t letters) {
  const std::size_t room = letters * kLinkLines;
  constexpr std::size_t kEnd = 16;
  std::string shown = link;
  if (link.size() > room && room > kEnd + 3)
    shown = link.substr(0, room - kEnd - 3) + "..." + link.substr(link.size() - kEnd);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < shown.size() && letters > 0; at += letters)
    lines.push_back(shown.substr(at, letters));
  return lines;
}

void draw_link(const Look& look, const std::string& link) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, line = look.fonts.mono->FontSize + look.px(4);
  const ImVec2 size(width, line * kLinkLines + look.px(16));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, {min.x + size.x, min.y + size.y}, look.theme.background, look.px.radius);
  const auto letters =
      static_cast<std::size_t>(std::max(1.0f, (width - look.px(20)) / text_width(look.fonts.mono, "0")));
  float y = min.y + look.px(8);
  for (const std::string& each : link_lines(link, letters)) {
    draw_text(list, look.fonts.mono, {min.x + look.px(10), y}, look.theme.text, each);
    y += line;
  }
  ImGui::Dummy(size);
}

struct LinkVerdict {
  ImU32 colour;
  std::string words;
};

/// Who takes a link of that length.
LinkVerdict link_verdict(const Theme& theme, std::size_t length) {
  const std::string has = count_text(static_cast<std::int64_t>(length), "character", "characters");
  if (length <= kShortLink) return {theme.dim, has + ": short enough for any program."};
  if (length <= kChatLink)
    return {theme.dim, has + ": some chat programs cut off what is longer than " + grouped(kShortLink) + "."};
  if (length <= kLongLink)
    return {theme.dim,
            has + ": mail and web pages take it, but many chat programs cut off what is longer than " +
                grouped(kChatLink) + "."};
  return {theme.warning,
          has +
              ": browsers take it, but most other programs do not send so long a link whole. A file "
              "is safer."};
}

}  // namespace

void Dialogs::show_link(std::string address) {
  link_address_ = std::move(address);
  link_.reset();
  show(DialogKind::link);
}

void Dialogs::draw_link_address(const Look& look) {
  text(look.fonts.ui, look.theme.dim, "Address of the page that opens it");
  if (look.focus != nullptr) look.focus->offer_field("##address");
  ImGui::PushFont(look.fonts.mono);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px(10), (look.px.control - look.fonts.mono->FontSize) * 0.5f));
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##address", "https://example.org/replan.html", &link_address_);
  // Escape takes the typing back, and is not for the dialog then.
  if (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) key::take(ImGui::GetIO(), key::kEscape);
  ImGui::PopStyleVar();
  ImGui::PopFont();
  hint(look, {"Address", "",
              "Where Replan runs as a page: on a server, or replan.html beside the text that has the link. "
              "It is kept for "
              "the next link. Replan itself opens the link whatever stands here."});
}

DialogDecision Dialogs::link_dialog(const Look& look) {
  heading(look, "A link to this moment");
  paragraph(look.fonts.ui, look.theme.dim,
            "It opens this world at this event, with what you see of it. The world stands in the link "
            "itself: no server "
            "is sent anything, and whoever has the link has the world.");
  ImGui::Dummy({0, look.px.xs});
  draw_link_address(look);
  ImGui::Dummy({0, look.px.xs});
  const bool made = link_ && link_->ok();
  const std::string whole = made ? bare_address(link_address_) + link_->value() : "";
  if (!link_)
    progress(look, -1, "Making the link…");
  else if (!made)
    paragraph(look.fonts.ui, look.theme.bad, as_sentence(link_->error()) + ".");
  else
    draw_link(look, whole);
  const bool fits = made && whole.size() <= kLongestLink;
  const LinkVerdict verdict = link_verdict(look.theme, whole.size());
  if (made) paragraph(look.fonts.ui, verdict.colour, verdict.words);
  ImGui::Dummy({0, look.px.xs});
  if (button(look, "Save as a file instead…", ButtonKind::plain))
    return {.kind = DialogDecision::Kind::save_elsewhere};
  const float answers = button_width(look, "Close") + look.px.s + button_width(look, "Copy the link");
  flow(look, answers);
  align_right(answers);
  if (button(look, "Close", ButtonKind::quiet) || escape_pressed())
    return {.kind = DialogDecision::Kind::cancel};
  ImGui::SameLine(0, look.px.s);
  ImGui::BeginDisabled(!fits);
  const bool copied = button(look, "Copy the link", ButtonKind::primary) || enter_pressed();
  ImGui::EndDisabled();
  return copied && fits ? DialogDecision{.kind = DialogDecision::Kind::copy_link, .path = whole}
                        : DialogDecision{};
}

}  // namespace replan::ui

#include "ui/shell/lesson_card.hpp"

#include <algorithm>

#include <imgui_internal.h>

#include "core/base/markdown.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Longer lines are hard to read.
constexpr float kWidestText = 880;

/// The lesson after that one; nullptr if it is the last.
const Lesson* lesson_after(std::span<const Lesson> lessons, std::string_view id) {
  const auto at =
      std::find_if(lessons.begin(), lessons.end(), [id](const Lesson& each) { return each.id == id; });
  return at == lessons.end() || at + 1 == lessons.end() ? nullptr : &*(at + 1);
}

}  // namespace

const std::vector<Lesson>& lessons_of(PanelState& panels) {
  if (panels.lessons) return *panels.lessons;
  panels.lessons.emplace();
  for (const LessonFile& file : lesson_files()) {
    Result<Lesson> lesson = read_lesson(file);
    if (lesson)
      panels.lessons->push_back(std::move(lesson.value()));
    else
      panels.notices.push_back(lesson.error());
  }
  return *panels.lessons;
}

void wish_for_lesson(Wish& wish, PanelState& panels, const std::string& id) {
  wish = Wish::lesson;
  panels.wished = id;
}

void LessonCard::begin(Lesson lesson) {
  player_.emplace(std::move(lesson));
  shown_.reset();
}

void LessonCard::note(std::string_view name) {
  if (player_) player_->note(name);
}

float LessonCard::height(const Look& look) const {
  return height_ > 0 ? height_ : look.px(120);
}

void LessonCard::draw_head(Frame& frame) {
  const Look& look = frame.look;
  const std::string place =
      std::to_string(player_->number() + 1) + " of " + std::to_string(player_->lesson().steps.size());
  text(look.fonts.ui, look.theme.accent, icon::graduation);
  ImGui::SameLine(0, look.px.s);
  text(look.fonts.ui, look.theme.dim, player_->lesson().title);
  ImGui::SameLine(0, look.px.s);
  text(look.fonts.mono, look.theme.dim, place);
  ImGui::SameLine(0, look.px.m);
  const float right = ImGui::GetWindowWidth() - look.px.m - look.px(24);
  text(look.fonts.title, look.theme.text,
       elide(look.fonts.title, player_->step().title, right - look.px.m - ImGui::GetCursorPosX()));
  ImGui::SameLine(right);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - look.px.xs);
  closing_ = small_button(
      look, "close",
      {.icon = icon::times, .hint = {"Close the lesson", "", "The world stays. Help has all lessons."}});
}

/// Does the step for the learner.
void LessonCard::do_it(Frame& frame) {
  const Result<std::vector<Deed>> deeds = player_->deeds(frame.session);
  if (!deeds) {
    frame.panels.said = deeds.error();
    frame.panels.said_bad = true;
    return;
  }
  for (const Deed& deed : *deeds) {
    if (const auto* command = std::get_if<Command>(&deed)) frame.commands.push_back(*command);
    if (const auto* act = std::get_if<ActionDeed>(&deed))
      if (const Action* found = find_action(act->action)) perform(frame, found->id);
  }
}

/// What leads on: to the next step, or past the last one.
void LessonCard::draw_way_on(Frame& frame) {
  const Look& look = frame.look;
  const bool done = player_->done();
  if (!player_->at_last()) {
    if (button(look, done ? "Next" : "Skip", done ? ButtonKind::primary : ButtonKind::plain))
      player_->go_on();
    return;
  }
  if (const Lesson* next = lesson_after(lessons_of(frame.panels), player_->lesson().id)) {
    if (button(look, "Next lesson", done ? ButtonKind::primary : ButtonKind::plain))
      wish_for_lesson(frame.wish, frame.panels, next->id);
    ImGui::SameLine(0, look.px.s);
  }
  if (button(look, "Finish", ButtonKind::plain)) closing_ = true;
}

void LessonCard::draw_buttons(Frame& frame) {
  const Look& look = frame.look;
  if (player_->number() > 0) {
    if (button(look, "Back", ButtonKind::plain)) player_->go_back();
    ImGui::SameLine(0, look.px.s);
  }
  draw_way_on(frame);
  if (closing_) return;
  ImGui::SameLine(0, look.px.s);
  if (!player_->done()) {
    if (button(look, "Do it for me", ButtonKind::quiet)) do_it(frame);
    return;
  }
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + look.px(6));
  text(look.fonts.ui, look.theme.good, icon::check);
  ImGui::SameLine(0, look.px.xs);
  text(look.fonts.ui, look.theme.good, "Done.");
}

void LessonCard::draw(Frame& frame) {
  const Look& look = frame.look;
  if (shown_ != player_->number()) {
    shown_ = player_->number();
    frame.view.view.pinned = player_->step().cell;
  }
  draw_head(frame);
  for (const std::string& each : player_->step().paragraphs)
    marked_paragraph(look, look.theme.text, each, look.px(kWidestText));
  draw_buttons(frame);
  const float height = ImGui::GetCursorPosY() + look.px.xs;
  if (height != height_) frame.panels.animated = true;  // it was drawn with another one
  height_ = height;
  edge(look, Edge::bottom);
  if (closing_) close();
  closing_ = false;
}

void draw_lesson_menu(Frame& frame) {
  const std::vector<Lesson>& lessons = lessons_of(frame.panels);
  if (!ImGui::BeginMenuEx("Lessons", icon::graduation, !lessons.empty())) return;
  for (const Lesson& lesson : lessons) {
    if (ImGui::MenuItemEx(lesson.title.c_str(), "")) wish_for_lesson(frame.wish, frame.panels, lesson.id);
    hint(frame.look, {"", "", without_markdown(lesson.summary).c_str()});
  }
  ImGui::EndMenu();
}

}  // namespace replan::ui

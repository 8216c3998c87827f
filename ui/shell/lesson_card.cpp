#include "ui/shell/lesson_card.hpp"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "core/base/markdown.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Longer lines are hard to read.
constexpr float kWidestText = 880;
/// Heights of the line with the title, and of the gap below a paragraph.
constexpr float kHead = 26, kGap = 4;

/// The lesson after that one; nullptr if it is the last.
const Lesson* lesson_after(std::span<const Lesson> lessons, std::string_view id) {
  const auto at =
      std::find_if(lessons.begin(), lessons.end(), [id](const Lesson& each) { return each.id == id; });
  return at == lessons.end() || at + 1 == lessons.end() ? nullptr : &*(at + 1);
}

std::string with_own_keys(const std::string& words) {
  return kInPage ? words_in_page(words) : words;
}

float text_height(const Look& look, const LessonStep& step, float width) {
  float height = 0;
  for (const std::string& each : step.paragraphs)
    height += marked_paragraph_height(look, with_own_keys(each), width, look.px(kWidestText)) + look.px(kGap);
  return height;
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
  skipping_ = false;
  began_.assign(player_->lesson().steps.size(), {});
}

void LessonCard::note(std::string_view name) {
  if (player_) player_->note(name);
}

bool LessonCard::look(const Session& session) {
  if (!open()) return false;
  const bool done = player_->look(session);
  const bool rests =
      std::none_of(session.runs().begin(), session.runs().end(), [](const auto& run) { return run->busy(); });
  if (!skipping_ || !(player_->done() || rests)) return done;
  skipping_ = false;
  player_->go_on();
  return true;
}

float LessonCard::height(const Look& look, float width) const {
  float tallest = 0;
  for (const LessonStep& step : player_->lesson().steps)
    tallest = std::max(tallest, text_height(look, step, width - 2 * look.px.m));
  return std::ceil(2 * look.px.s + look.px(kHead + kGap) + tallest + look.px.control);
}

void LessonCard::enter_step(Frame& frame) {
  if (!open() || shown_ == player_->number()) return;
  const bool onwards = !shown_ || *shown_ < player_->number();
  shown_ = player_->number();
  if (onwards) began_[*shown_] = {frame.run().log_id(), frame.run().timeline().cursor()};
  frame.panels.animated = true;  // the canvas has been drawn without that
  frame.view.view.pinned = player_->step().cell;
  frame.panels.why_open = false;
  put_tool_away(frame.view);
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
  const float right = ImGui::GetWindowWidth() - look.px.m - look.px.small;
  text(look.fonts.title, look.theme.text,
       elide(look.fonts.title, player_->step().title, right - look.px.m - ImGui::GetCursorPosX()));
  ImGui::SameLine(right);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - look.px.xs);
  closing_ = small_button(
      look, "close",
      {.icon = icon::times, .hint = {"Close the lesson", "", "The world stays. Help has all lessons."}});
}

/// Does the step for the learner. False if it cannot be done, which is said.
bool LessonCard::do_it(Frame& frame) {
  const Result<std::vector<Deed>> deeds = player_->deeds(frame.session);
  if (!deeds) {
    frame.panels.said = deeds.error();
    frame.panels.tone = Tone::bad;
    return false;
  }
  for (const Deed& deed : *deeds) {
    if (const auto* command = std::get_if<Command>(&deed)) frame.commands.push_back(*command);
    if (const auto* act = std::get_if<ActionDeed>(&deed))
      if (const Action* found = find_action(act->action)) perform(frame, found->id);
  }
  return true;
}

/// Later steps may rest on this one, so it is done before the next one begins.
void LessonCard::skip(Frame& frame) {
  skipping_ = do_it(frame);
  if (!skipping_) player_->go_on();
}

/// What leads on: to the next step, or past the last one.
void LessonCard::draw_way_on(Frame& frame) {
  const Look& look = frame.look;
  const bool done = player_->done();
  if (!player_->at_last()) {
    if (!button(look, done ? "Next" : "Skip", done ? ButtonKind::primary : ButtonKind::plain)) return;
    if (done)
      player_->go_on();
    else
      skip(frame);
    return;
  }
  if (const Lesson* next = lesson_after(lessons_of(frame.panels), player_->lesson().id)) {
    if (button(look, "Next lesson", done ? ButtonKind::primary : ButtonKind::plain))
      wish_for_lesson(frame.wish, frame.panels, next->id);
    ImGui::SameLine(0, look.px.s);
  }
  if (button(look, "Finish", ButtonKind::plain)) closing_ = true;
}

/// To the step before, and to the moment at which it began, if that still is what it was.
void LessonCard::go_back(Frame& frame) {
  player_->go_back();
  const Run& run = frame.run();
  const Moment& began = began_[player_->number()];
  if (began.log_id != 0 && run.common_with(began.log_id) >= began.position)
    frame.commands.emplace_back(Seek{began.position});
}

void LessonCard::draw_buttons(Frame& frame) {
  const Look& look = frame.look;
  // Also where there is nothing to go back to, so that the other buttons stay where they are under the mouse.
  ImGui::BeginDisabled(player_->number() == 0);
  if (button(look, "Back", ButtonKind::plain)) go_back(frame);
  ImGui::EndDisabled();
  ImGui::SameLine(0, look.px.s);
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
  const float top = ImGui::GetCursorPosY(), left = ImGui::GetCursorPosX();
  draw_head(frame);
  float y = top + look.px(kHead);
  for (const std::string& each : player_->step().paragraphs) {
    ImGui::SetCursorPos({left, y});
    marked_paragraph(look, look.theme.text, with_own_keys(each), look.px(kWidestText));
    y += ImGui::GetItemRectSize().y + look.px(kGap);
  }
  ImGui::SetCursorPos({left, ImGui::GetWindowHeight() - look.px.s - look.px.control});
  draw_buttons(frame);
  edge(look, Edge::bottom);
  if (closing_) close();
  closing_ = false;
}

void draw_lesson_menu(Frame& frame) {
  const std::vector<Lesson>& lessons = lessons_of(frame.panels);
  if (!ImGui::BeginMenuEx("Lessons", icon::graduation, !lessons.empty())) return;
  for (const Lesson& lesson : lessons) {
    if (menu_item(frame.look, lesson.title.c_str())) wish_for_lesson(frame.wish, frame.panels, lesson.id);
    hint(frame.look, {"", "", without_markdown(lesson.summary).c_str()});
  }
  ImGui::EndMenu();
}

}  // namespace replan::ui

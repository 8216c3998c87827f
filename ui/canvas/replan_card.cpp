#include "ui/canvas/replan_card.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/base/clock.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/canvas/kept_words.hpp"
#include "ui/icons.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// How long a card is whole after a replan.
constexpr double kWholeSeconds = 5;

std::string cells(std::int64_t count) {
  return count_text(count, "cell", "cells");
}

std::string milliseconds(double ms) {
  if (ms < kFinestMs) return kUnderFinestMs;
  char text[32];
  std::snprintf(text, sizeof text, ms < 0.1 ? "%.3f" : ms < 10 ? "%.2f" : "%.0f", ms);
  return text;
}

/// Whether it tells a repair from a plan from scratch: not where it was one.
bool compares(const ReplanReport& report) {
  return report.repairs && !report.repair.cause.afresh();
}

/// A line of the card's table: what, for the repair, from scratch.
struct Row {
  std::string what, repair, scratch;
};

/// What the repair kept and lost of a tree or a population, and how much it did after that.
std::vector<Row> rows_of_kept(const ReplanReport& report) {
  const KeptCounts& kept = *report.repair.kept;
  const bool paths = report.info->values.breeds();
  std::vector<Row> rows = {{paths ? "paths kept" : "vertices kept", grouped(kept.kept), ""}};
  if (paths) rows.push_back({"joined to the robot", grouped(kept.joined), ""});
  rows.push_back({paths ? "paths lost" : "vertices cut off", grouped(kept.lost), ""});
  rows.push_back({std::string(report.info->step.many), grouped(report.repair.steps),
                  report.fresh ? grouped(report.fresh->expansions) : "…"});
  return rows;
}

std::vector<Row> rows_of(const ReplanReport& report) {
  const auto fresh = [&](const std::string& value) { return report.fresh ? value : std::string("…"); };
  std::vector<Row> rows = report.repair.kept
                              ? rows_of_kept(report)
                              : std::vector<Row>{{"cells touched", grouped(report.repair.touched),
                                                  fresh(report.fresh ? grouped(report.fresh->touched) : "")}};
  // What takes less than a tenth of a millisecond is a matter of chance.
  const double longest = std::max(report.repair.ms.value_or(0), report.fresh ? report.fresh->ms : 0);
  if (report.times && longest >= 0.1)
    rows.push_back({"milliseconds", report.repair.ms ? milliseconds(*report.repair.ms) : "…",
                    fresh(report.fresh ? milliseconds(report.fresh->ms) : "")});
  if (!compares(report))
    for (Row& row : rows) row.scratch = std::exchange(row.repair, "");
  return rows;
}

/// Of a tree or a population the forms differ by the replan's number alone.
std::string brief_of_kept(const ReplanReport& report, CardForm form) {
  const std::string kept = kept_brief(report.info->values, *report.repair.kept);
  return form == CardForm::line || form == CardForm::touched
             ? "replan " + grouped(report.repair.number) + " · " + kept
             : kept;
}

std::string brief_text(const ReplanReport& report, CardForm form) {
  if (report.repair.kept) return brief_of_kept(report, form);
  const std::string touched = grouped(report.repair.touched) + " touched",
                    named = "replan " + grouped(report.repair.number) + " · " + touched;
  if (form == CardForm::least) return touched;
  if (form == CardForm::touched || !compares(report) || !report.fresh) return named;
  return (form == CardForm::line ? named : touched) + ", " + grouped(report.fresh->touched) + " from scratch";
}

/// Lays the whole card out; without a list it only measures.
class CardPen {
 public:
  CardPen(const Look& look, const ReplanReport& report)
      : look_(look), report_(report), rows_(rows_of(report)) {
    const float what = widest([](const Row& row) -> const std::string& { return row.what; }, look.fonts.ui);
    repair_ =
        std::max(compares(report) ? text_width(look.fonts.small, "repair") : 0,
                 widest([](const Row& row) -> const std::string& { return row.repair; }, look.fonts.mono));
    scratch_ =
        std::max(text_width(look.fonts.small, "from scratch"),
                 widest([](const Row& row) -> const std::string& { return row.scratch; }, look.fonts.mono));
    const float table = what + look.px(16) + repair_ + look.px(16) + scratch_;
    size_ = {std::ceil(std::max({table, text_width(look.fonts.ui, cause()), look.px(180)})) + 2 * look.px.m,
             look.px(12) * 2 + look.px(22) + look.px(22) + look.px(18) +
                 look.px(19) * static_cast<float>(rows_.size())};
  }

  [[nodiscard]] ImVec2 size() const { return size_; }

  void draw(ImDrawList& list, ImVec2 min) const {
    const Theme& theme = look_.theme;
    const ImVec2 max(min.x + size_.x, min.y + size_.y);
    list.AddRectFilled(min, max, with_alpha(theme.panel, 0.94f), look_.px.radius_l);
    list.AddRect(min, max, theme.line, look_.px.radius_l, 0, look_.px.hair);
    const float left = min.x + look_.px.m, right = max.x - look_.px.m;
    float y = min.y + look_.px(12);
    draw_text(list, look_.fonts.title, {left, y}, theme.warning, "Replan " + grouped(report_.repair.number));
    right_aligned(list, look_.fonts.small, right - look_.px(20), y + look_.px(1), theme.dim,
                  "at step " + grouped(report_.repair.clock));
    y += look_.px(22);
    draw_text(list, look_.fonts.ui, {left, y}, theme.text, cause());
    y += look_.px(22);
    if (compares(report_))
      right_aligned(list, look_.fonts.small, right - scratch_ - look_.px(16), y, theme.dim, "repair");
    right_aligned(list, look_.fonts.small, right, y, theme.dim, "from scratch");
    y += look_.px(18);
    for (const Row& row : rows_) {
      draw_text(list, look_.fonts.ui, {left, y}, theme.dim, row.what);
      right_aligned(list, look_.fonts.mono, right - scratch_ - look_.px(16), y, theme.text, row.repair);
      right_aligned(list, look_.fonts.mono, right, y, theme.text, row.scratch);
      y += look_.px(19);
    }
  }

 private:
  [[nodiscard]] std::string cause() const { return cause_sentence(report_.repair.cause); }
  template <class Part>
  [[nodiscard]] float widest(const Part& part, const ImFont* font) const {
    float width = 0;
    for (const Row& row : rows_) width = std::max(width, text_width(font, part(row)));
    return width;
  }
  static void right_aligned(ImDrawList& list, const ImFont* font, float right, float y, ImU32 colour,
                            const std::string& text) {
    draw_text(list, font, {right - text_width(font, text), y}, colour, text);
  }

  const Look& look_;
  const ReplanReport& report_;
  std::vector<Row> rows_;
  float repair_ = 0, scratch_ = 0;  // widths of the columns
  ImVec2 size_;
};

void draw_brief(const Look& look, ImVec2 min, const ReplanReport& report, CardForm form) {
  const std::string text = brief_text(report, form);
  const std::array<TextRun, 1> runs = {{{text, look.theme.warning, look.fonts.ui}}};
  chip(look, *ImGui::GetWindowDrawList(), min, runs);
}

}  // namespace

std::string cause_sentence(const ReplanCause& cause) {
  if (cause.new_goal) return "The goal has moved: planned from scratch.";
  if (cause.to_goal_again) return "The goal can be reached again: planned from scratch.";
  if (cause.to_nearest) return "The goal cannot be reached: now to the nearest cell that can.";
  if (cause.put_down) return "The robot was put down here.";
  if (cause.forgotten > 0)
    return "The robot no longer reckons with " + cells(cause.forgotten) + " out of sight.";
  if (cause.blocked > 0 && cause.freed > 0)
    return cells(cause.blocked) + " blocked, " + grouped(cause.freed) + " free again.";
  if (cause.freed > 0) return cells(cause.freed) + " free again.";
  if (cause.blocked == 0) return "The robot had left its plan: planned again from where it is.";
  return cells(cause.blocked) + " blocked.";
}

ImVec2 replan_card_size(const Look& look, const ReplanReport& report, CardForm form) {
  if (form == CardForm::whole) return CardPen(look, report).size();
  return {text_width(look.fonts.ui, brief_text(report, form)) + look.px(20), look.px(29)};
}

void CardFold::see(std::int64_t replan, double now) {
  if (replan == replan_) return;
  replan_ = replan;
  until_ = now + kWholeSeconds;
}

CardAnswer draw_replan_card(const Look& look, ImVec2 pos, const ReplanReport& report, CardForm form) {
  const ImVec2 size = replan_card_size(look, report, form);
  const bool brief = form != CardForm::whole;
  const std::string id = "card##" + std::to_string(ImGui::GetID("card"));
  ImGui::SetNextWindowPos({std::floor(pos.x), std::floor(pos.y)});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin(id.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  const ImVec2 min = ImGui::GetWindowPos();
  CardAnswer answer = CardAnswer::none;
  if (brief)
    draw_brief(look, min, report, form);
  else
    CardPen(look, report).draw(*ImGui::GetWindowDrawList(), min);
  if (!brief) {
    ImGui::SetCursorScreenPos({min.x + size.x - look.px(28), min.y + look.px(6)});
    if (small_button(look, "close",
                     {.icon = icon::times, .hint = {"Close", "", "It stays one line until you click it."}}))
      answer = CardAnswer::close;
  }
  ImGui::SetCursorScreenPos(min);
  if (ImGui::InvisibleButton("whole", size) && answer == CardAnswer::none)
    answer = brief ? CardAnswer::open : CardAnswer::repair;
  tab_stop(look);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  hint(look, {"Last repair", "",
              brief ? "Click for what made the robot plan again, and what the repair cost."
                    : "Click for all that it touched."});
  ImGui::End();
  return answer;
}

}  // namespace replan::ui

// The transport under the canvas: buttons, unit, speed, counter, and the timeline below them.
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

constexpr double kSlowest = 1;

void transport_action(Frame& frame, ActionId id, const char* icon, bool primary = false) {
  const Action& each = action(id);
  const ActionContext context = context_of(frame);
  const std::string words = each.words(context), lesson = each.lesson(context);
  if (transport_button(
          frame.look, each.name,
          {.icon = icon, .hint = {words.c_str(), each.keys.c_str(), lesson.c_str()}, .selected = primary}))
    perform(frame, id);
  ImGui::SameLine(0, frame.look.px(frame.look.px.fingers ? 4 : 6));
}

ActionId step_action(StepUnit unit, bool forwards) {
  switch (unit) {
    case StepUnit::line:
      return forwards ? ActionId::line_forward : ActionId::line_back;
    case StepUnit::expansion:
      return forwards ? ActionId::step_forward : ActionId::step_back;
    case StepUnit::move:
      return forwards ? ActionId::move_forward : ActionId::move_back;
    case StepUnit::replan:
      return forwards ? ActionId::replan_forward : ActionId::replan_back;
    case StepUnit::mission:
      return forwards ? ActionId::mission_forward : ActionId::mission_back;
  }
  return ActionId::step_forward;
}

/// To the previous and next breakpoint; they show once there are some.
void breakpoint_buttons(Frame& frame) {
  if (frame.session.breakpoints().list().empty()) return;
  ImGui::SameLine(0, frame.look.px.m);
  transport_action(frame, ActionId::breakpoint_back, icon::stop_back);
  transport_action(frame, ActionId::breakpoint_forward, icon::stop_forward);
}

void buttons(Frame& frame) {
  const int direction = frame.session.playback().direction;
  transport_action(frame, ActionId::to_start, icon::fast_backward);
  transport_action(frame, ActionId::play_back, icon::backward);
  transport_action(frame, step_action(frame.panels.unit, false), icon::step_backward);
  transport_action(frame, ActionId::play, direction != 0 ? icon::pause : icon::play, true);
  transport_action(frame, step_action(frame.panels.unit, true), icon::step_forward);
  transport_action(frame, ActionId::to_end, icon::fast_forward);
  breakpoint_buttons(frame);
}

void step_unit(Frame& frame, bool roomy) {
  const Look& look = frame.look;
  const StepWords& step = frame.run().info().step;
  const std::string one(step.one);
  const std::array<const char*, 5> units = {"line", one.c_str(), "robot move", "replan", "to the goal"};
  ImGui::SameLine(0, look.px(roomy ? 20 : 8));
  if (roomy) {
    ImGui::AlignTextToFramePadding();
    text(look.fonts.ui, look.theme.dim, "Step");
    ImGui::SameLine(0, look.px(6));
  }
  int unit = static_cast<int>(frame.panels.unit);
  if (combo(look, "##unit", units, unit, look.px(frame.panels.stacked ? 100 : 106)))
    frame.panels.unit = static_cast<StepUnit>(unit);
  hint(look, {"Step over", "",
              "What one press of the step buttons goes over: a line of pseudo-code, a step of the search (an "
              "expansion, a sample or a child), a move of the robot, all up to the next plan, or the whole "
              "mission up to the goal."});
}

/// What the panes keep step by, while there are several.
void lockstep(Frame& frame) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 3> kModes = {"by expansions", "by moves", "as a race"};
  static constexpr std::array kActions = {ActionId::lockstep_expansions, ActionId::lockstep_moves,
                                          ActionId::lockstep_race};
  ImGui::SameLine(0, look.px.s);
  int mode = static_cast<int>(frame.session.lockstep());
  if (combo(look, "##lockstep", kModes, mode, look.px(frame.panels.stacked ? 124 : 132)))
    perform(frame, kActions[static_cast<std::size_t>(mode)]);
  const Action& now = action(kActions[static_cast<std::size_t>(mode)]);
  hint(look, {"Lockstep of the panes", "", now.teach.c_str()});
}

std::string speed_text(double speed) {
  if (speed >= Session::kFullSpeed) return "as fast as possible";
  if (speed >= 1000) return grouped(static_cast<std::int64_t>(std::llround(speed / 100) * 100)) + " /s";
  return fixed(speed, speed < 10 ? 1 : 0) + " /s";
}

/// A log scale whose right end means "as fast as possible".
void speed(Frame& frame, bool roomy) {
  const Look& look = frame.look;
  ImGui::SameLine(0, look.px(roomy ? 20 : 10));
  if (roomy) {
    ImGui::AlignTextToFramePadding();
    text(look.fonts.ui, look.theme.dim, "Playing speed");
    ImGui::SameLine(0, look.px.s);
  }
  const float width = look.px(roomy                  ? 110
                              : frame.panels.stacked ? 56
                                                     : 70),
              height = look.px.control, knob = look.px(6);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("speed", {width, height});
  tab_stop(look);
  const double range = std::log(Session::kFullSpeed / kSlowest);
  double now = frame.session.playback().expansions_per_second;
  if (const int steps = arrow_steps(look); steps != 0) {
    now = std::clamp(now * std::exp(range * steps / 20), kSlowest, Session::kFullSpeed);
    frame.commands.push_back(SetSpeed{now});
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(0)) {
    const double at =
        std::clamp((ImGui::GetIO().MousePos.x - origin.x - knob) / (width - 2 * knob), 0.0f, 1.0f);
    now = at > 0.97 ? Session::kFullSpeed : kSlowest * std::exp(range * at);
    frame.commands.push_back(SetSpeed{now});
  }
  const std::string counts(frame.run().info().step.speed);
  hint(look, {"Playing speed", "",
              (counts +
               ", on a log scale; at the right end as fast as possible. The robot drives at most 15 cells a "
               "second.")
                  .c_str()});
  const auto part = static_cast<float>(std::clamp(std::log(now / kSlowest) / range, 0.0, 1.0));
  const float x = origin.x + knob + part * (width - 2 * knob), y = origin.y + height * 0.5f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({origin.x, y - look.px(2)}, {origin.x + width, y + look.px(2)}, look.theme.line,
                     look.px(2));
  list.AddRectFilled({origin.x, y - look.px(2)}, {x, y + look.px(2)}, look.theme.accent, look.px(2));
  list.AddCircleFilled({x, y}, knob, look.theme.accent);
  ImGui::SameLine(0, look.px.s);
  ImGui::AlignTextToFramePadding();
  const std::string words = roomy || now < Session::kFullSpeed ? speed_text(now) : "max";
  // Half a number would be a wrong one.
  if (!frame.panels.stacked || text_width(look.fonts.mono, words) <= ImGui::GetContentRegionAvail().x)
    text(look.fonts.mono, look.theme.text, words);
}

/// "9 214 / 11 870 events", or what the background is doing, at the right edge.
void counter(Frame& frame, float left, float right, float top) {
  const Look& look = frame.look;
  const Timeline& log = frame.session.run().timeline();
  const std::string now = grouped(log.cursor());
  const std::string all = " / " + grouped(log.size());
  std::string tail = " events";
  const ImFont* mono = look.fonts.mono;
  if (text_width(mono, now + all + tail) > right - left) tail.clear();
  const float width = text_width(mono, now + all + tail);
  if (width > right - left) return;
  const float y = top + (look.px.control - mono->FontSize) * 0.5f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, look.fonts.mono_bold, {right - width, y}, look.theme.text, now);
  draw_text(list, mono, {right - width + text_width(mono, now), y}, look.theme.faint, all + tail);
  ImGui::SetCursorScreenPos({right - width, top});
  ImGui::InvisibleButton("counter", {width, look.px.control});
  hint(look, {"Events", "",
              "Where the playhead stands in the log of everything that the planner and the robot did."});
}

/// In two rows: what plays and steps in the first, how in the second.
void draw_stacked_transport(Frame& frame) {
  const Look& look = frame.look;
  edge(look, Edge::top);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  buttons(frame);
  counter(frame, ImGui::GetItemRectMax().x + look.px.m, origin.x + width, origin.y);
  const float second = origin.y + look.px.control + look.px.s;
  ImGui::SetCursorScreenPos({origin.x - look.px.s, second});
  ImGui::Dummy({0, 0});
  step_unit(frame, false);
  const bool several = frame.session.runs().size() > 1;
  if (several) lockstep(frame);
  speed(frame, false);
  const float third = second + look.px.control + look.px.s;
  const float foot = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - look.px(4);
  draw_timeline(frame, {origin.x, third}, {origin.x + width, foot});
}

}  // namespace

float stacked_transport_height(const Look& look) {
  return look.px(14) + 2 * (look.px.control + look.px.s) + look.px(34 + 4);
}

void draw_transport(Frame& frame) {
  if (frame.panels.stacked) return draw_stacked_transport(frame);
  const Look& look = frame.look;
  edge(look, Edge::top);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool several = frame.session.runs().size() > 1;
  const float extra = (frame.session.breakpoints().list().empty() ? 0.0f : 90.0f) + (several ? 130.0f : 0.0f);
  const bool roomy = width > look.px(840 + extra);
  buttons(frame);
  step_unit(frame, roomy);
  if (several) lockstep(frame);
  speed(frame, roomy);
  counter(frame, ImGui::GetItemRectMax().x + look.px.m, origin.x + width, origin.y);
  const float foot = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - look.px(11);
  draw_timeline(frame, {origin.x, origin.y + look.px.control + look.px(10)}, {origin.x + width, foot});
}

}  // namespace replan::ui

// What a tool lets one choose, under the side panel: when a surprise happens, how a moving obstacle moves.
#include <algorithm>
#include <array>

#include "core/scene/script.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// How far the robot has come: a surprise can only be scheduled for later.
std::int64_t clock_of(const Session& session) {
  const Run& run = session.run();
  const replan::Mark* mark = run.mark_at(run.timeline().cursor());
  return mark == nullptr ? 0 : mark->clock;
}

void surprise_options(Frame& frame) {
  const Look& look = frame.look;
  Editing& editing = frame.view.editing;
  static constexpr std::array<const char*, 3> kTimes = {"Now", "At a step", "When near"};
  int time = static_cast<int>(editing.surprise_time);
  section_title(look, "It happens");
  if (segments(look, "time", kTimes, time)) editing.surprise_time = static_cast<SurpriseTime>(time);
  hint(look,
       {"When", "",
        "Now; once the robot has taken so many steps; or when it comes so near to the middle of what you "
        "draw."});
  if (editing.surprise_time == SurpriseTime::step) {
    const std::int64_t now = clock_of(frame.session);
    editing.surprise_step = std::max(editing.surprise_step, now);
    double step = static_cast<double>(editing.surprise_step);
    if (slider(look,
               {.label = "Step",
                .min = static_cast<double>(now),
                .max = static_cast<double>(now + 200),
                .initial = static_cast<double>(now + 10),
                .decimals = 0},
               step, {"Step", "", "Once the robot has taken so many steps; waiting counts as well."}))
      editing.surprise_step = static_cast<std::int64_t>(step);
  } else if (editing.surprise_time == SurpriseTime::near) {
    slider(look, {.label = "Within", .min = 0, .max = 64, .initial = 4, .unit = "cells", .decimals = 1},
           editing.surprise_within,
           {"Within", "",
            "How near the robot has to come, from its cell's centre to the middle of what you draw."});
  }
}

void remove_button(Frame& frame) {
  const bool pressed = button(frame.look, "Remove", ButtonKind::danger, icon::trash);
  hint(frame.look, action(ActionId::delete_selected).hint());
  if (pressed) perform(frame, ActionId::delete_selected);
}

void selected_surprise(Frame& frame) {
  const Look& look = frame.look;
  const Surprise& surprise = frame.session.scenario().surprises[*frame.view.editing.surprise];
  section_title(look, "Surprise that is to come");
  const std::string when =
      surprise.at.move ? "at step " + std::to_string(*surprise.at.move) : "when the robot comes near";
  paragraph(look.fonts.ui, look.theme.text, std::to_string(surprise.cells.size()) + " cells, " + when);
  remove_button(frame);
}

/// Speed and what happens at the end; returns whether one was changed for good.
bool movement(Frame& frame, double& speed, WayEnd& at_end) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 3> kEnds = {"Back", "Round", "Stays"};
  const auto draft = frame.panels.drafts.find("mover speed");
  double shown = draft == frame.panels.drafts.end() ? speed : draft->second;
  if (slider(
          look,
          {.label = "Speed",
           .min = 0.1,
           .max = 50,
           .initial = 2,
           .unit = "cells/s",
           .decimals = 1,
           .logarithmic = true},
          shown,
          {"Speed", "",
           "A diagonal step takes as long as a straight one. The robot's own speed is in the Planner tab."}))
    frame.panels.drafts["mover speed"] = shown;
  bool changed = false;
  // Handed on when the slider is let go: each change begins the run afresh.
  if (!ImGui::IsMouseDown(0) && !ImGui::IsItemActive() && frame.panels.drafts.erase("mover speed") > 0) {
    speed = shown;
    changed = true;
  }
  text(look.fonts.ui, look.theme.dim, "At the end of its way");
  int end = static_cast<int>(at_end);
  if (segments(look, "end", kEnds, end)) {
    at_end = static_cast<WayEnd>(end);
    changed = true;
  }
  hint(look, {"At the end of its way", "",
              "Back: it returns the way it came, and so on. Round: straight to the way's beginning, and so "
              "on. Stays: it "
              "stops for good."});
  return changed;
}

void selected_mover(Frame& frame) {
  const Look& look = frame.look;
  const std::size_t index = *frame.view.editing.mover;
  MovingObstacle mover = frame.session.scenario().movers[index];
  section_title(look, "Moving obstacle " + std::to_string(index + 1));
  bool changed = movement(frame, mover.speed, mover.at_end);
  const auto side = [&](const char* label, int& value) {
    const std::string key = std::string("mover ") + label;
    const auto draft = frame.panels.drafts.find(key);
    double shown = draft == frame.panels.drafts.end() ? value : draft->second;
    if (slider(look,
               {.label = label,
                .min = 1,
                .max = kMaxMoverSide,
                .initial = 1,
                .unit = "cells",
                .decimals = 0,
                .logarithmic = true},
               shown,
               {label, "", "Of the box of cells that moves; what lies outside the world is not there."}))
      frame.panels.drafts[key] = shown;
    if (ImGui::IsMouseDown(0) || frame.panels.drafts.erase(key) == 0) return;
    value = static_cast<int>(shown);
    changed = true;
  };
  side("Width", mover.width);
  side("Height", mover.height);
  if (changed) frame.commands.push_back(ChangeMover{index, mover, 0});
  remove_button(frame);
}

void mover_options(Frame& frame) {
  const Look& look = frame.look;
  Editing& editing = frame.view.editing;
  section_title(look, "The next one");
  movement(frame, editing.mover_speed, editing.mover_end);
  const std::string side = std::to_string(frame.view.brush);
  paragraph(look.fonts.ui, look.theme.dim,
            editing.way.empty() ? "Click the corners of its way. It will be " + side + " x " + side +
                                      " cells large, as the brush is."
                                : "Click on. A double click, Enter or the right button ends the way.");
}

void region_options(Frame& frame) {
  const Look& look = frame.look;
  const CellRect& region = *frame.view.editing.region;
  section_title(look, std::to_string(region.high.x - region.low.x + 1) + " x " +
                          std::to_string(region.high.y - region.low.y + 1) + " cells");
  const auto entry = [&](ActionId id, bool last) {
    const Action& each = action(id);
    if (small_button(look, each.name, {.icon = each.icon, .hint = each.hint()})) perform(frame, id);
    if (!last) ImGui::SameLine(0, look.px.xs);
  };
  entry(ActionId::copy, false);
  entry(ActionId::cut, false);
  entry(ActionId::paste, false);
  entry(ActionId::delete_selected, true);
}

/// What is drawn, if the state of things asks for something.
void (*options(const Frame& frame))(Frame&) {
  const Editing& editing = frame.view.editing;
  const Scenario& scenario = frame.session.scenario();
  if (editing.mover && *editing.mover < scenario.movers.size()) return selected_mover;
  if (editing.surprise && *editing.surprise < scenario.surprises.size()) return selected_surprise;
  if (editing.region) return region_options;
  if (frame.view.tool == Tool::surprise) return surprise_options;
  if (frame.view.tool == Tool::mover) return mover_options;
  return nullptr;
}

/// Undo, or time, may have taken away what was selected. What is about to be added is not there yet.
void forget_what_is_gone(Frame& frame) {
  Editing& editing = frame.view.editing;
  const Scenario& scenario = frame.session.scenario();
  if (!frame.commands.empty()) return;
  if (editing.mover && *editing.mover >= scenario.movers.size()) editing.mover.reset();
  const bool is_gone = editing.surprise && (*editing.surprise >= scenario.surprises.size() ||
                                            !is_to_come(frame.session.run(), *editing.surprise));
  if (is_gone) editing.surprise.reset();
}

}  // namespace

bool has_tool_options(const Frame& frame) {
  return options(frame) != nullptr;
}

void draw_tool_options(Frame& frame) {
  forget_what_is_gone(frame);
  const auto draw = options(frame);
  if (draw == nullptr) return;
  edge(frame.look, Edge::left);
  edge(frame.look, Edge::top);
  draw(frame);
  const float height = ImGui::GetCursorPosY() + frame.look.px.xs;
  if (height != frame.panels.tool_height)
    frame.panels.animated = true;  // it takes its place in the next frame
  frame.panels.tool_height = height;
}

}  // namespace replan::ui

// The Planner tab: which planner, its settings as declared, and what the robot knows and senses.
#include <algorithm>
#include <array>

#include "core/lattice/box_words.hpp"
#include "core/plan/stage.hpp"
#include "core/scene/spline_marks.hpp"
#include "core/world/choices.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

std::vector<const char*> pointers(const std::vector<std::string>& texts) {
  std::vector<const char*> result;
  for (const std::string& each : texts) result.push_back(each.c_str());
  return result;
}

/// A label at the left and a control of the panel's half width at the right, on one line.
template <class Control>
bool labelled_control(const Look& look, const char* label, const Hint& what, bool changed_from_default,
                      Control control) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float right = std::min(look.px(190), width * 0.6f);
  ImGui::SetCursorScreenPos({origin.x, origin.y + (look.px.control - look.fonts.ui->FontSize) * 0.5f});
  text_line(look, look.fonts.ui, changed_from_default ? look.theme.text : look.theme.dim, label,
            width - right - look.px.s);
  hint(look, what);
  ImGui::SetCursorScreenPos({origin.x + width - right, origin.y});
  ImGui::PushID(label);
  const bool changed = control(right);
  ImGui::PopID();
  return changed;
}

void choose_planner(Frame& frame) {
  const Look& look = frame.look;
  std::vector<std::string> names;
  int current = 0;
  for (const PlannerInfo& info : choices()) {
    if (info.id == frame.run().choice().id) current = static_cast<int>(names.size());
    names.emplace_back(info.name);
  }
  const int before = current;
  if (combo(look, "##planner", pointers(names), current, ImGui::GetContentRegionAvail().x) &&
      current != before)
    frame.commands.push_back(
        ChoosePlanner{frame.session.lead(), std::string(choices()[static_cast<std::size_t>(current)].id)});
  hint(look,
       {"Planner", "", "The planner of the leading pane. Another one plans the same world from scratch."});
  const PlannerInfo& info = frame.run().info();
  paragraph(look.fonts.ui, look.theme.dim, info.summary);
  const bool page = button(look, "Code of this planner", ButtonKind::quiet, icon::book);
  hint(look, action(ActionId::show_code).hint());
  if (page) perform(frame, ActionId::show_code);
}

bool choice_setting(Frame& frame, const Parameter& parameter, const Hint& what, double& value) {
  const Look& look = frame.look;
  const bool in_space = frame.run().lattice().solid() && !parameter.choices_in_space.empty();
  const auto& choices = in_space ? parameter.choices_in_space : parameter.choices;
  std::vector<std::string> names(choices.begin(), choices.end());
  int current = static_cast<int>(value);
  const bool changed =
      labelled_control(look, std::string(parameter.label).c_str(), what, value != parameter.initial,
                       [&](float width) { return combo(look, "##choice", pointers(names), current, width); });
  value = current;
  return changed;
}

/// A number is handed on when the slider is let go: each value on the way would be a replan and a step of
/// undo.
bool number_setting(Frame& frame, const Parameter& parameter, const Hint& what, double& value) {
  const std::string label(parameter.label), unit(parameter.unit), key(parameter.key);
  const auto draft = frame.panels.drafts.find(key);
  double shown = draft == frame.panels.drafts.end() ? value : draft->second;
  const int decimals = parameter.type == ParameterType::whole ? 0
                       : parameter.high - parameter.low < 20  ? 2
                                                              : 1;
  const bool moved = slider(frame.look,
                            {.label = label.c_str(),
                             .min = parameter.low,
                             .max = parameter.high,
                             .initial = parameter.initial,
                             .unit = unit.c_str(),
                             .decimals = decimals},
                            shown, what);
  if (moved) frame.panels.drafts[key] = shown;
  const bool held = ImGui::IsItemActive();
  if (held || !frame.panels.drafts.contains(key)) return false;
  value = shown;
  frame.panels.drafts.erase(key);
  return true;
}

/// One declared setting; true if it was changed, which `value` then holds.
bool setting(Frame& frame, const Parameter& parameter, double& value) {
  const Look& look = frame.look;
  const std::string label(parameter.label), help(parameter.help);
  const Hint what{label.c_str(), "", help.c_str()};
  bool changed = false;
  switch (parameter.type) {
    case ParameterType::choice:
      changed = choice_setting(frame, parameter, what, value);
      break;
    case ParameterType::toggle: {
      bool on = value != 0;
      changed = toggle(look, label.c_str(), on);
      hint(look, what);
      value = on ? 1 : 0;
      break;
    }
    case ParameterType::whole:
    case ParameterType::real:
      changed = number_setting(frame, parameter, what, value);
      break;
  }
  return changed;
}

/// Declared settings below each other; true if one was changed in `settings`.
bool declared_settings(Frame& frame, std::span<const Parameter> parameters, Settings& settings) {
  bool changed = false;
  for (const Parameter& parameter : parameters) {
    double value = settings.get(parameter);
    if (!setting(frame, parameter, value)) continue;
    settings.set(parameter.key, value);
    if (value == parameter.initial) settings.reset(parameter.key);
    changed = true;
  }
  return changed;
}

void planner_settings(Frame& frame) {
  for (const Parameter& parameter : find_choice(frame.run().choice().id)->parameters) {
    double value = frame.run().settings().get(parameter);
    if (setting(frame, parameter, value))
      frame.commands.push_back(SetParameter{frame.session.lead(), std::string(parameter.key), value});
  }
}

/// Of a path that is a curve: whether it had to be pulled in, and where first; a click goes there.
void spline_words(Frame& frame) {
  const Look& look = frame.look;
  const Spline* spline = spline_at_cursor(frame.run());
  if (spline == nullptr) return;
  if (spline->pulled_in.empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              "The curve that stands is free as it is: nothing had to be pulled in.");
    return;
  }
  const PullIn& first = spline->pulled_in.front();
  const auto count = static_cast<std::int64_t>(spline->pulled_in.size());
  paragraph(look.fonts.ui, look.theme.warning,
            count == 1
                ? "One piece of the curve was pulled in, since an obstacle was in the way:"
                : grouped(count) +
                      " pieces of the curve were pulled in, since obstacles were in the way. The first:");
  if (link(look, "pulled in", cell_text(first.cell, frame.run().lattice()), look.fonts.mono))
    show_cell(frame, first.cell);
}

/// What the paths of the leading pane go through: each stage that there is, on or off, and below one that is on
/// its settings. Stages are applied in the order of the list.
void path_stages(Frame& frame) {
  const Look& look = frame.look;
  const std::vector<StageChoice>& before = frame.run().choice().stages;
  std::vector<StageChoice> after;
  for (const StageInfo& info : stages()) {
    const auto chosen = std::find_if(before.begin(), before.end(),
                                     [&](const StageChoice& each) { return each.id == info.id; });
    const std::string name(info.name), summary(info.summary);
    bool on = chosen != before.end();
    toggle(look, name.c_str(), on);
    hint(look, {name.c_str(), "", summary.c_str()});
    if (!on) continue;
    after.push_back(chosen != before.end() ? *chosen : StageChoice{std::string(info.id), {}});
    declared_settings(frame, info.parameters, after.back().settings);
  }
  if (after != before) frame.commands.push_back(SetStages{frame.session.lead(), std::move(after)});
  spline_words(frame);
}

/// Which kind of robot it is, where there are several, and what that kind has to set; true if something was
/// changed.
bool kind_settings(Frame& frame, RobotSetup& robot) {
  const Look& look = frame.look;
  std::vector<std::string> names;
  int kind = 0;
  for (const RobotInfo& info : robots()) {
    if (info.id == robot.kind) kind = static_cast<int>(names.size());
    names.emplace_back(info.name);
  }
  bool changed = false;
  const RobotInfo& before = robots()[static_cast<std::size_t>(kind)];
  if (names.size() > 1) {
    const std::string summary(before.summary);
    changed = labelled_control(look, "Robot", {"Robot", "", summary.c_str()}, kind != 0, [&](float width) {
      return combo(look, "##kind", pointers(names), kind, width);
    });
  }
  const RobotInfo& info = robots()[static_cast<std::size_t>(kind)];
  if (changed) {
    robot.kind = info.id;
    robot.settings = {};
  }
  return declared_settings(frame, info.parameters, robot.settings) || changed;
}

/// How long its steps take, where its kind leaves that open.
bool motion_setting(const Look& look, RobotSetup& robot) {
  if (find_robot(robot.kind)->own_pace) return false;
  static constexpr std::array<const char*, 2> kMotions = {"step by step", "at a steady speed"};
  int motion = static_cast<int>(robot.motion);
  const bool changed = labelled_control(
      look, "It drives",
      {"How it drives", "",
       "Step by step: every step takes equally long, straight or diagonal. At a steady speed: "
       "it goes along its plan smoothly, and a step takes as long as its way."},
      robot.motion != RobotSetup{}.motion,
      [&](float width) { return combo(look, "##drives", kMotions, motion, width); });
  robot.motion = static_cast<Motion>(motion);
  return changed;
}

/// How the robot drives; true if something was changed.
bool drive_settings(Frame& frame, RobotSetup& robot) {
  const Look& look = frame.look;
  bool changed = motion_setting(look, robot);
  const Parameter speed{.key = "robot speed",
                        .label = "Driving speed",
                        .type = ParameterType::real,
                        .initial = RobotSetup{}.speed,
                        .low = 0.5,
                        .high = std::max(20.0, robot.speed),
                        .unit = "cells/s"};
  changed |=
      number_setting(frame, speed,
                     {"Driving speed", "",
                      "How fast the robot drives; beside the speed of moving obstacles it decides who comes "
                      "to a cell first."},
                     robot.speed);
  if (frame.session.scenario().movers.empty()) return changed;
  const Parameter patience{.key = "patience",
                           .label = "Patience",
                           .type = ParameterType::real,
                           .initial = RobotSetup{}.patience,
                           .low = 0,
                           .high = std::max(300.0, robot.patience),
                           .unit = "s"};
  return number_setting(
             frame, patience,
             {"Patience", "",
              "How long the robot waits for moving obstacles to clear its way before it gives up."},
             robot.patience) ||
         changed;
}

/// How large it is; true if that was changed.
bool size_setting(Frame& frame, RobotSetup& robot) {
  const Parameter radius{.key = "robot radius",
                         .label = "Robot radius",
                         .type = ParameterType::real,
                         .initial = RobotSetup{}.radius,
                         .low = 0,
                         .high = std::max(8.0, robot.radius),
                         .unit = "cells"};
  return number_setting(
      frame, radius,
      {"Robot radius", "",
       "Of its body. Its centre keeps so far away from the squares of all obstacles, and it "
       "cuts no corners. 0: a point, which may go wherever a cell is free."},
      robot.radius);
}

/// What it does where it cannot go on; true if something was changed.
bool trouble_settings(const Look& look, RobotSetup& robot) {
  static constexpr std::array<const char*, 2> kUnreachable = {"wait for a way", "go as near as it can"};
  int unreachable = static_cast<int>(robot.unreachable_goal);
  bool changed = labelled_control(
      look, "If there is no path",
      {"Where the goal cannot be reached", "",
       "Wait: until a way opens. As near as it can: to the reachable cell nearest to the goal, and on to the "
       "goal once a way opens."},
      robot.unreachable_goal != RobotSetup{}.unreachable_goal,
      [&](float width) { return combo(look, "##unreachable", kUnreachable, unreachable, width); });
  robot.unreachable_goal = static_cast<UnreachableGoal>(unreachable);
  changed |= toggle(look, "An obstacle on its own cell holds it", robot.robot_cell_blocks);
  hint(look, {"An obstacle on its own cell", "",
              "Off: an obstacle that comes onto the robot's own cell does not hold it; it drives out. On: it "
              "is held there. A robot that starts in a wall, or is put into one, is held in any case."});
  return changed;
}

/// How far it sees, to which side and through what.
bool sensor_settings(Frame& frame, RobotSetup& robot) {
  const Look& look = frame.look;
  const Parameter radius{.key = "sensor radius",
                         .label = "Sensor radius",
                         .type = ParameterType::real,
                         .initial = RobotSetup{}.sensor_radius,
                         .low = 0,
                         .high = std::max(64.0, robot.sensor_radius),
                         .unit = "cells"};
  bool changed =
      number_setting(frame, radius,
                     {"Sensor radius", "",
                      "How far the robot sees, from its cell's centre to a cell's centre. The eight "
                      "cells around it, and what its body could touch in them, are always felt."},
                     robot.sensor_radius);
  const Parameter angle{.key = "sensor angle",
                        .label = "Sensor angle",
                        .type = ParameterType::real,
                        .initial = RobotSetup{}.sensor_angle,
                        .low = 1,
                        .high = 360,
                        .unit = "°"};
  changed |= number_setting(frame, angle,
                            {"Sensor angle", "",
                             "How wide the sensor looks ahead, the whole opening angle: a sector, in space a "
                             "cone, about the robot's course, which is the direction of its last move. 360: "
                             "all round."},
                            robot.sensor_angle);
  changed |= toggle(look, "Obstacles block its view", robot.sensor_blocked);
  hint(look,
       {"Blocked view", "", "On: what stands behind an obstacle is hidden. Off: the sensor sees through."});
  return changed;
}

void robot_settings(Frame& frame) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 3> kKnowledge = {"everything, at once", "the map, not surprises",
                                                            "nothing yet"};
  RobotSetup robot = frame.session.scenario().robot;
  int knowledge = static_cast<int>(robot.knowledge);
  bool changed = kind_settings(frame, robot);
  changed |= size_setting(frame, robot);
  changed |= labelled_control(look, "The robot knows",
                              {"What the robot knows", "",
                               "Everything: each change as it happens. The map: as it is at the start; "
                               "surprises only when sensed. Nothing: every obstacle only when sensed."},
                              robot.knowledge != RobotSetup{}.knowledge, [&](float width) {
                                return combo(look, "##knows", kKnowledge, knowledge, width);
                              });
  robot.knowledge = static_cast<Knowledge>(knowledge);
  changed |= sensor_settings(frame, robot);
  changed |= drive_settings(frame, robot);
  changed |= trouble_settings(look, robot);
  if (changed) frame.commands.push_back(SetRobot{robot});
}

class PlannerTab final : public SideTab {
  void draw(Frame& frame) override;
};

void PlannerTab::draw(Frame& frame) {
  const Look& look = frame.look;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px(10)));
  section_title(look, "Planner");
  choose_planner(frame);
  section_rule(look);
  section_title(look, "Settings");
  const Action& reset = action(ActionId::reset_settings);
  if (reset.available(context_of(frame))) {
    const BesideTitle place(look, 1);
    if (small_button(look, reset.name, {.icon = reset.icon, .hint = reset.hint()})) perform(frame, reset.id);
  }
  planner_settings(frame);
  section_rule(look);
  section_title(look, "Robot");
  if (find_pilot(frame.run().choice().id) != nullptr)
    paragraph(look.fonts.ui, look.theme.dim,
              "This pane drives by the settings above. Of the robot below it has the size, the sensor and "
              "what it knows; how "
              "that one drives is for the other panes.");
  robot_settings(frame);
  section_rule(look);
  section_title(look, "After planning");
  path_stages(frame);
  ImGui::PopStyleVar();
}

}  // namespace

TabKind planner_tab() {
  return {.name = "Planner",
          .label = "Planner",
          .icon = icon::sliders,
          .chord = fn(2),
          .teach = "Which planner runs in which pane, and its settings.",
          .make = make_part<SideTab, PlannerTab>};
}

}  // namespace replan::ui

#include "ui/shell/shell.hpp"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "core/scene/scene.hpp"
#include "core/session/command_name.hpp"
#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

constexpr float kNarrowestSide = 340, kWidestSide = 640, kNarrowestCanvas = 320, kNarrowestTransport = 560;
constexpr float kLow = 560, kLowWithLesson = 680, kLowTransport = 100;  // low windows, and their transport
constexpr float kNarrowestLesson = 560, kLessonSide = 0.31f;            // the latter of the window's width
constexpr float kNarrowest = 700, kLowest = 440;                        // below, parts stand otherwise
constexpr float kCaption = 32;                                          // height of the line over the canvas

/// Whether a key presses or changes the control that has the keyboard.
bool is_for_control(const Look& look, const Chord& chord) {
  if (look.focus == nullptr || !look.focus->shown() || chord.ctrl || chord.alt) return false;
  const bool arrow = chord.key == key::kLeft || chord.key == key::kRight;
  return chord.key == key::kSpace || (arrow && look.focus->has_arrows());
}

/// A menu's label without the dots that announce a dialog.
std::string without_dots(const std::string& label) {
  constexpr std::string_view kDots = "…";
  return label.ends_with(kDots) ? label.substr(0, label.size() - kDots.size()) : label;
}

/// Seeks, steps and play are no edits: nobody needs to be told twice that there is nothing to undo.
bool is_quiet(const Command& command) {
  return std::holds_alternative<Undo>(command) || std::holds_alternative<Redo>(command);
}

}  // namespace

Shell::Shell(ImGuiRenderer& renderer)
    : panes_(renderer),
      documents_({view_, panels_, dialogs_, message_, [this](const Scenario& world) { show(world); },
                  [this](const Session& session, const std::string& path) { show_batch(session, path); },
                  [this](Session& session, const LinkView& view) { follow_link(session, view); }}),
      dialogs_(renderer) {}

ActionContext context_of(Frame& frame) {
  return {frame.session, frame.view, frame.panels, frame.commands, frame.wish};
}

void perform(Frame& frame, ActionId id) {
  ActionContext context = context_of(frame);
  if (!action(id).available(context)) return;
  action(id).effect(context);
  frame.panels.performed.push_back(action(id).name);
}

void Shell::draw(const Look& look, Session& session, double) {
  std::vector<Command> commands;
  Wish wish = Wish::none;
  panels_.animated = false;
  panels_.performed.clear();
  view_.view.scale = static_cast<double>(look.px.scale);
  Frame frame{look, session, view_, panels_, commands, wish};
  take_keys(frame);
  share_.see(held_);
  for (const ActionId id : std::exchange(next_actions_, {})) perform(frame, id);
  pin_difference(frame);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  panels_.stacked = size.x < look.px(kNarrowest) && size.x < size.y;
  panels_.short_of_room = panels_.stacked || size.y < look.px(kLowest);
  panels_.stacked ? draw_stacked(frame) : draw_parts(frame);
  palette_.draw(frame, documents_.library());
  if (!view_.panels) view_.view.pointed_motion.reset();  // nobody is there to point at it
  if (const std::string failure = session.failure(); !failure.empty() && message_.empty())
    tell(failure, true);
  if (const Session::Notice notice = session.take_notice(); !notice.words.empty())
    tell(notice.words, notice.bad);
  drawn_ = session.revision();
  documents_.take_loaded(session);
  const bool batch_behind = dialogs_.open();  // the keys of this frame are the dialog's
  const DialogDecision decision = dialogs_.draw(look);
  if (!batch_behind) draw_batch(look);
  if (!dialogs_.link_address().empty()) panels_.link_address = dialogs_.link_address();
  world_dialogs_.draw(look, session, commands);
  context_of(frame).go_on_copying();
  context_of(frame).go_on_pasting();
  if (!panels_.said.empty()) message_.tell(std::exchange(panels_.said, {}), panels_.tone);
  take_commands(session, commands);
  follow_lesson(session);
  take_wish(session, wish);
  take_decision(session, decision);
  if (const auto outcome = export_.go_on(session)) tell(outcome->words, outcome->bad);
  panels_.exporting = export_.busy() ? export_.share() : -1;
  go_on_with_batch(session);
  go_on_to_moment(session);
  go_on_with_link(session);
  pause_behind_dialogs(session);
  documents_.keep(session);
}

bool Shell::wants_frames(const Session& session) const {
  const bool busy =
      std::any_of(session.runs().begin(), session.runs().end(), [](const auto& run) { return run->busy(); });
  const bool debugging = session.checks().busy() || session.breakpoints().hunt();
  return busy || session.has_steps() || debugging || session.playback().direction != 0 ||
         session.revision() != drawn_ || held_ || panels_.animated || dialogs_.animated() || export_.busy() ||
         batch_.behind() || panels_.clipboard.busy() || arrival_.busy() || link_copy_ || panes_.animating();
}

namespace {

/// A key whose action can do nothing now says why. Escape does not: it is pressed to be sure that nothing is on.
void say_why_not(Frame& frame, ActionId id) {
  const Action& each = action(id);
  const std::string_view why_not = each.rules.why_not;
  if (why_not.empty() || each.chord.key == key::kEscape || each.available(context_of(frame))) return;
  frame.panels.said = without_dots(each.label) + ": " + std::string(why_not) + ".";
  frame.panels.tone = Tone::hint;
}

}  // namespace

void Shell::take_keys(Frame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool elsewhere = covered() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  held_ = !elsewhere && key_is_held(io);
  if (elsewhere) {
    let_go_.reset();
    // ImGui closes popups by Escape only together with its own keyboard navigation, which takes our keys.
    if (!covered() && ImGui::IsKeyPressed(key::kEscape, false)) ImGui::ClosePopupToLevel(0, true);
    return;
  }
  for (const ActionId id : pressed_actions(io)) {
    if (is_for_control(frame.look, action(id).chord)) continue;
    say_why_not(frame, id);
    if (!action(id).rules.on_release) {
      perform(frame, id);
      continue;
    }
    let_go_ = id;
    view_.panned = false;
  }
  if (!let_go_ || io.KeysDown[action(*let_go_).chord.key]) return;
  if (!view_.panned) perform(frame, *let_go_);
  let_go_.reset();
}

/// Nothing goes on behind a dialog that is not seen; once it is closed, the same run plays on.
void Shell::pause_behind_dialogs(Session& session) {
  const int direction = session.playback().direction;
  if (covered() && direction != 0) {
    paused_ = Paused{direction, session.run().log_id()};
    static_cast<void>(session.apply(Play{0}));
  }
  if (covered() || !paused_) return;
  const Paused before = *std::exchange(paused_, std::nullopt);
  if (before.log == session.run().log_id()) static_cast<void>(session.apply(Play{before.direction}));
}

/// What a comparison of two panes has just come to is told, whatever tab is open, and the vertex at which
/// they part is pinned, so that the Cell tab explains it.
void Shell::pin_difference(Frame& frame) {
  const Checks& checks = frame.session.checks();
  if (std::exchange(pinned_difference_, checks.comparison()) == checks.comparison()) return;
  if (checks.comparison().empty()) return;
  tell(as_sentence(checks.comparison()), false);
  const auto& found = checks.difference();
  if (!found) return;
  const NodeId node = found->nodes[frame.session.lead() == found->panes[0] ? 0 : 1];
  if (node != kNoNode) show_cell(frame, frame.run().lattice().position(node));
}

void Shell::draw_parts(Frame& frame) {
  const Look& look = frame.look;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const bool panels = view_.panels;
  const std::string& session_caption = frame.session.scenario().caption;
  // In a low window the hills of the timeline are, and so they are where a lesson needs the room.
  const float transport =
      size.y < look.px(lesson_.open() ? kLowWithLesson : kLow) ? look.px(kLowTransport) : look.px.transport;
  const float bottom = size.y - look.px.status, under = bottom - transport;
  const float left = panels ? tool_strip_width(look, under - look.px.menu - look.px(16)) : 0;
  // In a small window the world keeps the larger half, and the transport goes under both.
  const float widest =
      std::max(size.x - left - look.px(kNarrowestCanvas), std::min(look.px(kNarrowestSide), size.x * 0.45f));
  // Over a narrow canvas a lesson would be tall, and its cells too small for numbers: it takes the whole row, and the
  // side gives way.
  float side = panels ? std::min(look.px(panels_.side_width), widest) : 0;
  const bool whole_row = lesson_.open() && size.x - left - side < look.px(kNarrowestLesson);
  if (whole_row) side = std::min(side, size.x * kLessonSide);
  const float split = size.x - side;
  const bool small = split < look.px(kNarrowestTransport);
  const float transport_end = small ? size.x : split, side_end = small ? under : bottom;
  draw_menu(frame, {0, 0}, size.x);
  if (panels)
    area("tools", {0, look.px.menu}, {left, under - look.px.menu}, look.theme.panel, {look.px(7), look.px(8)},
         [&] { draw_tool_strip(frame); });
  const bool told = panels_.caption && !session_caption.empty() && !lesson_.open();
  const float row = (whole_row ? size.x : split) - left;
  const float strip = lesson_.open() ? lesson_.height(look, row) : told ? look.px(kCaption) : 0;
  const float top = look.px.menu + strip, side_top = whole_row ? top : look.px.menu;
  if (told) draw_caption(frame, {left, look.px.menu}, {row, strip});
  if (lesson_.open())
    area("lesson", {left, look.px.menu}, {row, strip}, look.theme.panel, {look.px.m, look.px.s},
         [&] { lesson_.draw(frame); });
  draw_canvas(frame, {left, top}, {split, under});
  lesson_.enter_step(frame);
  area("transport", {0, under}, {transport_end, transport}, look.theme.panel, {look.px.l, look.px(14)},
       [&] { draw_transport(frame); });
  if (panels) {
    const float tool = has_tool_options(frame) ? panels_.tool_height : 0;
    area("side", {split, side_top}, {side, side_end - tool - side_top}, look.theme.panel, {0, 0},
         [&] { draw_side(frame); });
    if (has_tool_options(frame))
      area("tool options", {split, side_end - tool}, {side, tool}, look.theme.panel, {look.px.l, look.px.m},
           [&] { draw_tool_options(frame); });
  }
  draw_status(frame, {0, bottom}, size.x);
  if (panels) draw_splitter(frame, split, side_top, side_end);
  draw_stop(frame, {split - look.px.m, under - look.px(52)});
  message_.draw(look, {left, look.px.menu}, {split, under});
}

void Shell::draw_menu(Frame& frame, ImVec2 corner, float width) {
  const Look& look = frame.look;
  // The bar takes its height from the padding that holds when its window begins.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(look.px(10), (look.px.menu - look.fonts.ui->FontSize) * 0.5f));
  area(
      "menu", corner, {width, look.px.menu}, look.theme.panel, {0, 0}, [&] { draw_menu_bar(frame); },
      ImGuiWindowFlags_MenuBar);
  ImGui::PopStyleVar();
}

void Shell::draw_status(Frame& frame, ImVec2 corner, float width) {
  const Look& look = frame.look;
  const ImVec2 padding(look.px(14), std::floor((look.px.status - look.px(16)) * 0.5f));
  area("status", corner, {width, look.px.status}, look.theme.raised, padding, [&] {
    draw_status_bar(frame);
    draw_cell_menu(frame);
  });
}

void Shell::fit() {
  view_.fit_cameras();
  panes_.fit();
}

void Shell::draw_canvas(Frame& frame, ImVec2 min, ImVec2 max) {
  const Look& look = frame.look;
  panels_.canvas = {min, max};
  area(kCanvasArea, min, {max.x - min.x, max.y - min.y}, look.theme.background, {0, 0}, [&] {
    const bool interactive = !covered() && !palette_.open();
    panes_.draw(look, frame.session, panels_.panes, view_, min, max, interactive, frame.commands);
    panels_.zoom = panes_.scene().camera.zoom;
    draw_why_chip(frame, panes_.scene(), panes_.area().min, panes_.area().max);
  });
  if (std::exchange(view_.repair_asked, false)) perform(frame, ActionId::show_touched);
}

void Shell::draw_caption(Frame& frame, ImVec2 min, ImVec2 size) {
  const Look& look = frame.look;
  const Scenario& scenario = frame.session.scenario();
  area("caption", min, size, look.theme.panel, {look.px.m, look.px.xs}, [&] {
    const float right = ImGui::GetContentRegionAvail().x;
    const bool library = documents_.library() != nullptr;
    const float buttons = library ? look.px.small * 2 + look.px.xs : look.px.small;
    const float y = min.y + (size.y - look.fonts.ui->FontSize) * 0.5f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string name = elide(look.fonts.title, scenario.name, right * 0.4f);
    const float words = name.empty() ? 0 : text_width(look.fonts.title, name) + look.px.m;
    draw_text(list, look.fonts.title, {min.x + look.px.m, y}, look.theme.text, name);
    const float room = std::max(right - words - buttons - look.px.m, look.px(20));
    draw_text(list, look.fonts.ui, {min.x + look.px.m + words, y}, look.theme.dim,
              elide(look.fonts.ui, scenario.caption, room));
    ImGui::InvisibleButton("words", {right - buttons - look.px.s, look.px.small});
    hint(look, {scenario.name.c_str(), "", scenario.caption.c_str()});
    ImGui::SameLine(0, look.px.s);
    const Action& worlds = action(ActionId::worlds);
    if (library && small_button(look, "worlds", {.icon = icon::map, .hint = worlds.hint()}))
      perform(frame, ActionId::worlds);
    if (library) ImGui::SameLine(0, look.px.xs);
    if (small_button(
            look, "close",
            {.icon = icon::times, .hint = {"Hide the caption", "", "View > Caption shows it again."}}))
      panels_.caption = false;
    edge(look, Edge::bottom);
  });
}

void Shell::draw_splitter(Frame& frame, float x, float top, float bottom) {
  const Look& look = frame.look;
  const float half = look.px(3);
  area("splitter", {x - half, top}, {half * 2, bottom - top}, 0, {0, 0}, [&] {
    ImGui::InvisibleButton("drag", {half * 2, bottom - top});
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled({x - look.px.hair, top}, {x + look.px.hair, bottom},
                                              look.theme.accent);
    if (!ImGui::IsItemActive()) return;
    const float wanted = (ImGui::GetIO().DisplaySize.x - ImGui::GetIO().MousePos.x) / look.px.scale;
    panels_.side_width = std::clamp(wanted, kNarrowestSide, kWidestSide);
  });
}

void Shell::take_commands(Session& session, std::vector<Command>& commands) {
  for (const Command& command : commands)
    if (const Result<void> done = session.apply(command); done)
      lesson_.note(command_name(command));
    else if (!is_quiet(command))
      tell(done.error(), true);
}

/// The document is another one: a lesson that was open is not about it.
void Shell::show(const Scenario& world) {
  const ViewSetup& view = world.view;
  lesson_.close();
  if (const Result<OverlaySet> set = parse_overlays(view.overlays); set && !view.overlays.empty())
    view_.view.overlays = *set;
  // In a window the theme is the user's own.
  if (view.theme && !view_.live) view_.dark = *view.theme == "dark";
  view_.view.pinned.reset();
  view_.view.motion.reset();
  view_.view.hovered.reset();
  view_.pointed.reset();
  panels_.drafts.clear();
  panes_.take_over(world.map.box(), view_);
  view_.slices.forget();
  if (view.camera) view_.view.camera = {view.camera->x, view.camera->y, view.camera->zoom};
}

}  // namespace replan::ui

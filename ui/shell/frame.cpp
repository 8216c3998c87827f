#include "ui/shell/frame.hpp"

#include <algorithm>
#include <cmath>

#include "core/trace/search_state.hpp"
#include "core/world/choices.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Of one frame, for reading on in what a replan touched.
constexpr double kTouchedMs = 3;

}  // namespace

std::optional<Cell> Frame::cell() const {
  std::optional<Cell> chosen = view.view.pinned ? view.view.pinned : view.view.hovered;
  if (!chosen && view.pointed) chosen = view.pointed->cell;
  return chosen && session.scenario().map.contains(*chosen) ? chosen : std::nullopt;
}

std::size_t Frame::cell_pane() const {
  const bool other = !view.view.pinned && view.pointed && view.pointed->pane < session.runs().size();
  return other ? view.pointed->pane : session.lead();
}

void area(const char* id, ImVec2 pos, ImVec2 size, ImU32 ground, ImVec2 padding,
          const std::function<void()>& draw, ImGuiWindowFlags flags) {
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::SetNextWindowPos(pos);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ground);
  ImGui::Begin(id, nullptr, kFixed | flags);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  draw();
  ImGui::End();
}

std::string page_name(const Run& run) {
  const std::string planner = planner_of(run.choice()).id;
  const bool has_own_page = planner == run.choice().id || find_planner(planner)->blind;
  return has_own_page ? run.choice().id : run.choice().id + "+" + planner;
}

const Result<PlannerPage>& page_of(PanelState& panels, const Run& run) {
  const std::string name = page_name(run);
  if (const auto found = panels.pages.find(name); found != panels.pages.end()) return found->second;
  const std::size_t plus = name.find('+');
  auto page =
      plus == std::string::npos ? read_page(name) : read_page(name.substr(0, plus), name.substr(plus + 1));
  return panels.pages.emplace(name, std::move(page)).first->second;
}

PixelArea whole_window() {
  return {{0, 0}, ImGui::GetIO().DisplaySize};
}

std::optional<ReplanSpan> last_replan(const Run& run) {
  const std::size_t cursor = run.timeline().cursor();
  const auto milestones = run.milestones();
  const auto after = std::partition_point(milestones.begin(), milestones.end(),
                                          [cursor](const Milestone& m) { return m.event < cursor; });
  std::size_t end = cursor;
  bool over = false;
  for (auto at = after; at != milestones.begin();) {
    --at;
    if (at->kind == EventKind::plan_end) {
      end = at->event + 1;
      over = true;
    }
    if (at->kind != EventKind::plan_begin) continue;
    const std::uint64_t number = at->payload;
    if (number == 0) return std::nullopt;
    return ReplanSpan{number, at->event, end, over};
  }
  return std::nullopt;
}

const TouchedList* touched_by_last_replan(Frame& frame, const Run& run) {
  const std::optional<ReplanSpan> span = last_replan(run);
  if (!span) return nullptr;
  TouchedList& touched = frame.panels.touched;
  touched.follow(run.log_view(), run.log_id(), span->begin, span->end,
                 frame.view.live ? Deadline(kTouchedMs) : Deadline::never());
  if (touched.behind()) frame.panels.animated = true;
  return &touched;
}

void show_cell(Frame& frame, Cell cell) {
  ViewState& view = frame.view;
  view.view.pinned = cell;
  const std::size_t lead = frame.session.lead();
  view.slices.follows_robot = false;
  view.slices.show(lead, cell);
  const Sheet sheet = sheet_of(frame.run().lattice(), view.slices.of(lead));
  Camera& camera = view.camera(sheet.box.along());
  if (camera.zoom <= 0) return;  // the whole world is in sight
  const PixelArea& area = frame.panels.canvas;
  const double panes = static_cast<double>(std::max<std::size_t>(frame.session.runs().size(), 1));
  const double half_width = (area.max.x - area.min.x) / panes / 2 / camera.zoom;
  const double half_height = (area.max.y - area.min.y) / 2 / camera.zoom;
  const Point at = centre_of(sheet.box.seen(cell));
  if (std::abs(at.x - camera.x) > half_width * 0.9) camera.x = at.x;
  if (std::abs(at.y - camera.y) > half_height * 0.9) camera.y = at.y;
}

void point_at(Frame& frame, Cell cell) {
  if (!ImGui::IsItemHovered()) return;
  frame.panels.animated = frame.view.view.hovered != cell;  // it was drawn without it
  frame.view.view.hovered = frame.panels.pointed = cell;
}

namespace {

/// The name of the function that a line of pseudo-code is in; empty if there is none.
std::string function_of(const PlannerPage& page, int number) {
  const PseudoBlock* block = page.block_of(number);
  if (block == nullptr) return "";
  constexpr std::string_view kKeyword = "function ";
  std::string name;
  for (const PseudoLine& line : block->lines) {
    if (line.text.starts_with(kKeyword)) {
      const std::string_view rest = std::string_view(line.text).substr(kKeyword.size());
      name = rest.substr(0, rest.find('('));
    }
    if (line.number == number) break;
  }
  return name;
}

/// The vertex whose expansion an event belongs to, if it does.
std::optional<NodeId> taken_before(const Timeline& log, std::size_t event) {
  constexpr std::size_t kFarthest = 4096;  // an expansion writes far less
  for (std::size_t i = event + 1; i > 0 && event + 1 - i < kFarthest; --i) {
    const Event& each = log.event(i - 1);
    if (each.kind == EventKind::pop) return each.node;
    if (each.kind == EventKind::plan_begin || each.kind == EventKind::plan_end ||
        each.kind == EventKind::known || each.kind == EventKind::move)
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::string origin_text(Frame& frame, std::size_t event) {
  const Run& run = frame.run();
  const int number = run.timeline().event(event).line;
  std::string words;
  if (const Result<PlannerPage>& page = page_of(frame.panels, run); page && number != 0) {
    const PseudoLine* line = page->line(number);
    const std::string function = function_of(*page, number);
    if (line != nullptr) words = "line " + std::to_string(line->number);
    if (line != nullptr && !function.empty()) words += " of " + function;
  }
  const auto milestones = run.milestones();
  const auto behind = std::partition_point(milestones.begin(), milestones.end(),
                                           [event](const Milestone& m) { return m.event <= event; });
  const auto plan = std::find_if(std::make_reverse_iterator(behind), milestones.rend(),
                                 [](const Milestone& m) { return m.kind == EventKind::plan_begin; });
  if (plan == milestones.rend()) return words;
  const std::uint64_t replan = plan->payload;
  const std::string in = replan == 0 ? "in the first plan" : "in replan " + std::to_string(replan);
  if (!words.empty()) words += ", ";
  if (const auto taken = taken_before(run.timeline(), event))
    words += "when " + node_text(run, *taken) + " was taken from U, ";
  return words + in;
}

int current_line(const Run& run) {
  const std::size_t cursor = run.timeline().cursor();
  return cursor == 0 ? 0 : run.timeline().event(cursor - 1).line;
}

}  // namespace replan::ui

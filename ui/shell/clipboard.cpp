#include "ui/shell/clipboard.hpp"

#include <algorithm>

#include "core/base/words.hpp"
#include "core/lattice/box_words.hpp"
#include "core/link/link.hpp"
#include "ui/documents/files.hpp"
#include "ui/shell/actions.hpp"
#include "ui/tools/select.hpp"

namespace replan::ui {
namespace {

/// What copying may take of a frame.
constexpr double kSliceMs = 8;
/// Bytes of text that are read at once.
constexpr std::size_t kLongText = std::size_t{1} << 18;

CellBox whole_of(const GridMap& map) {
  return {{0, 0, 0}, {map.width - 1, map.height - 1, map.depth - 1}};
}

/// Where a map's cells come to lie, with its first one at a place: what of it lies in the world.
CellBox pasted_part(const GridMap& cells, const PastePlace& place) {
  const Cell at = place.at;
  return {at,
          {std::min(at.x + cells.width, place.world.width()) - 1,
           std::min(at.y + cells.height, place.world.height()) - 1,
           std::min(at.z + cells.depth, place.world.depth()) - 1}};
}

/// Every cell of a map as changes, with its upper left cell at a place; what falls outside the world or would block a
/// cell that is to be kept free is left out.
std::vector<CellChange> placed(const GridMap& cells, const PastePlace& place) {
  std::vector<CellChange> changes;
  const std::vector<Cell>& keep_free = place.keep_free;
  const CellBox part = pasted_part(cells, place);
  for (int z = part.low.z; z <= part.high.z; ++z)
    for (int y = part.low.y; y <= part.high.y; ++y)
      for (int x = part.low.x; x <= part.high.x; ++x) {
        const Cell to{x, y, z};
        const bool blocked = cells.at({x - place.at.x, y - place.at.y, z - place.at.z});
        if (blocked && std::find(keep_free.begin(), keep_free.end(), to) != keep_free.end()) continue;
        changes.push_back({to, blocked});
      }
  return changes;
}

/// A map with both ends is a world of its own.
bool is_world(const MapFile& read) {
  return read.start && read.goal;
}

/// Where start and goal stand now.
std::vector<Cell> standing(const Session& session) {
  std::vector<Cell> cells = {session.scenario().start, session.scenario().goal};
  const Run& run = session.run();
  if (const NodeId node = run.timeline().state().wanted_goal(); node != kNoNode)
    cells.push_back(run.lattice().position(node));
  return cells;
}

void say(PanelState& panels, std::string sentence, bool bad = false) {
  panels.said = std::move(sentence);
  panels.tone = bad ? Tone::bad : Tone::done;
}

}  // namespace

StateCopy::StateCopy(const Session& session, const CaseFocus& focus)
    : draft_(draft_case(session.run().scenario(), session.run().log_view(), focus)),
      hash_(session.run().timeline().state()),
      scenario_(session.work().only_if(session.run().lattice().node_count() > kLargeWorld)) {
  scenario_.start([held = session.snapshot()](const StopToken&) { return case_scenario(*held); });
}

std::optional<std::string> StateCopy::go_on(const Deadline& deadline) {
  if (auto text = scenario_.take()) scenario_text_ = std::move(text);
  if (!hash_.advance(deadline) || !scenario_text_) return std::nullopt;
  return complete(draft_, hash_.value(), *scenario_text_);
}

CellsCopy::CellsCopy(const WorkPlace& place, MapFile world, const CellBox& region, std::string said)
    : text_(place.only_if(world.map.blocked.size() > kLargeWorld)), said_(std::move(said)) {
  text_.start([world = std::move(world), region](const StopToken&) { return ascii_text(world, region); });
}

PastedText read_pasted(const std::string& text, const PastePlace& place) {
  if (is_link(text)) return {.link = text, .moment = {}, .place = place};
  if (is_case_text(text))
    return {.link = {}, .moment = parse_case_text(text, "the clipboard"), .place = place};
  PastedText pasted{
      .link = {}, .moment = {}, .cells = parse_ascii_map(text, "the clipboard"), .place = place};
  if (pasted.cells && !is_world(*pasted.cells)) pasted.changes = placed(pasted.cells->map, place);
  return pasted;
}

void ActionContext::copy_world() {
  const Scenario& scenario = session.scenario();
  const CellBox all = whole_of(scenario.map);
  copy_cells({session.world(), scenario.start, scenario.goal}, all,
             "Copied the world as text: " + part_text(all));
}

void ActionContext::copy_cells(MapFile world, const CellBox& region, std::string said) {
  panels.clipboard.cells =
      std::make_unique<CellsCopy>(session.work(), std::move(world), region, std::move(said));
  go_on_copying();
}

void ActionContext::copy_state() {
  CaseFocus focus{session.lead(), view.view.pinned, std::nullopt};
  focus.region = view.editing.region;
  panels.clipboard.copy = std::make_unique<StateCopy>(session, focus);
  go_on_copying();
}

void ActionContext::go_on_copying() {
  if (panels.clipboard.copy) go_on_copying_state();
  std::unique_ptr<CellsCopy>& cells = panels.clipboard.cells;
  if (!cells) return;
  const std::optional<std::string> text = cells->take();
  if (!text) return;
  ImGui::SetClipboardText(text->c_str());
  say(panels, cells->said());
  cells.reset();
}

void ActionContext::go_on_copying_state() {
  std::unique_ptr<StateCopy>& copy = panels.clipboard.copy;
  const std::optional<std::string> text = copy->go_on(Deadline(kSliceMs));
  if (!text) return;
  ImGui::SetClipboardText(text->c_str());
  say(panels,
      "Copied the state at event " + std::to_string(copy->event()) + " as text; pasting it comes back here");
  copy.reset();
}

void ActionContext::copy_region() {
  const CellBox region = *view.editing.region;
  copy_cells({session.world()}, region, "Copied " + part_text(region) + " as text");
}

void ActionContext::cut_region() {
  copy_region();
  clear_region();
}

void ActionContext::paste() {
  const char* text = ImGui::GetClipboardText();
  if (text == nullptr || *text == '\0') return say(panels, "The clipboard holds no text", true);
  std::string held = text;
  const GridMap& map = session.scenario().map;
  PastePlace place{view.editing.region ? view.editing.region->low
                                       : view.view.pinned.value_or(view.view.hovered.value_or(Cell{0, 0})),
                   map.box(), standing(session)};
  panels.clipboard.paste =
      std::make_unique<Background<PastedText>>(session.work().only_if(held.size() > kLongText));
  panels.clipboard.paste->start([held = std::move(held), place = std::move(place)](const StopToken&) {
    return read_pasted(held, place);
  });
  go_on_pasting();
}

void ActionContext::go_on_pasting() {
  if (!panels.clipboard.paste) return;
  auto read = panels.clipboard.paste->take();
  if (!read) return;
  panels.clipboard.paste.reset();
  if (!read->link.empty())
    put_in_link(std::move(read->link));
  else if (read->moment)
    put_in_moment(std::move(*read->moment));
  else
    put_in_cells(std::move(*read));
}

void ActionContext::put_in_link(std::string link) {
  panels.wished = std::move(link);
  wish = Wish::open_link;
}

void ActionContext::put_in_moment(Result<CaseMoment> moment) {
  if (!moment) return say(panels, moment.error(), true);
  panels.pasted = std::make_shared<const CaseMoment>(std::move(moment.value()));
  wish = Wish::go_to_pasted;
}

void ActionContext::put_in_cells(PastedText pasted) {
  const Result<MapFile>& read = pasted.cells;
  if (!read) return say(panels, read.error(), true);
  const Scenario& scenario = session.scenario();
  const GridMap& cells = read->map;
  for (const std::string& note : read->found.notes) panels.notices.push_back(note);
  const std::string noted = read->found.notes.empty() ? "" : "; " + read->found.notes.front();
  if (is_world(*read)) {
    const bool same_frame =
        cells.box() == scenario.map.box() && read->start == scenario.start && read->goal == scenario.goal;
    // Cell by cell if it can be, so that the plan is repaired.
    if (same_frame && cells.blocked.size() <= kLargeWorld)
      push(PaintCells{placed(cells, {{0, 0, 0}, cells.box(), standing(session)}), 0});
    else
      push(ReplaceMap{cells, read->start, read->goal});
    return say(panels, "Pasted a world of " + part_text(whole_of(cells)) + noted);
  }
  const CellBox part = pasted_part(cells, pasted.place);
  push(PaintCells{std::move(pasted.changes), 0});
  select_with_tool(view, part);
  const bool whole = cell_count(part) == cells.blocked.size();
  say(panels, "Pasted " + part_text(whole_of(cells)) +
                  (whole ? "" : "; what did not fit into the world was left out") + noted);
}

}  // namespace replan::ui

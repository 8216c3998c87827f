#include "ui/shell/frame.hpp"

#include "core/trace/search_state.hpp"

namespace replan::ui {

std::optional<Cell> Frame::cell() const {
  const std::optional<Cell> chosen = view.view.pinned ? view.view.pinned : view.view.hovered;
  return chosen && session.scenario().map.contains(*chosen) ? chosen : std::nullopt;
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

const Result<PlannerPage>& page_of(PanelState& panels, std::string_view planner) {
  const auto found = panels.pages.find(planner);
  if (found != panels.pages.end()) return found->second;
  return panels.pages.emplace(std::string(planner), read_page(planner)).first->second;
}

int current_line(const Run& run) {
  const std::size_t cursor = run.timeline().cursor();
  return cursor == 0 ? 0 : run.timeline().event(cursor - 1).line;
}

}  // namespace replan::ui

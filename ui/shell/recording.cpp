#include "ui/shell/recording.hpp"

#include <cstdio>
#include <ctime>

#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {

std::string capture_name(const char* extension) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char name[64];
  name[std::strftime(name, sizeof name, "replan-%Y%m%d-%H%M%S", &local)] = '\0';
  return std::string(name) + extension;
}

std::string film_time(double seconds) {
  const long whole = static_cast<long>(seconds);
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

void draw_recording(Frame& frame) {
  const RecordingState& recording = frame.panels.recording;
  if (!recording.busy() || recording.made >= 0) return;  // the status bar tells of one that is being made
  const Look& look = frame.look;
  const std::string words = recording.on ? film_time(recording.seconds) : "finishing the film…";
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float dot = look.fonts.icons->FontSize;
  const ImVec2 size{dot + look.px.s + text_width(look.fonts.mono, words), look.px.menu};
  if (ImGui::InvisibleButton("recording", size) && recording.on)
    perform(frame, recording.window ? ActionId::record_window : ActionId::record_canvas);
  hint(look, {"Recording", "", "Click to stop. A message says when the film is complete."});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = ImGui::GetWindowPos().y + look.px.menu * 0.5f;
  list.AddCircleFilled({origin.x + dot * 0.5f, middle}, look.px(5),
                       recording.on ? look.theme.bad : look.theme.faint);
  draw_text(list, look.fonts.mono, {origin.x + dot + look.px.s, middle - look.fonts.mono->FontSize * 0.5f},
            recording.on ? look.theme.text : look.theme.dim, words);
}

}  // namespace replan::ui

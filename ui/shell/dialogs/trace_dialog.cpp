// What to call a trace of the run, and whether its map goes with it.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/export/posthoc.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/trace_export.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// What will be written, as the name stands now.
std::string prospect(const TraceFacts& facts, TraceFormat format) {
  if (format == TraceFormat::json_lines)
    return count_text(static_cast<std::int64_t>(facts.events), "event", "events") + ", a line each.";
  const std::string size = "About " + count_text(static_cast<std::int64_t>(facts.steps), "step", "steps") +
                           ", " + bytes_text(facts.bytes) + ".";
  return facts.steps <= kManyPosthocSteps
             ? size
             : size +
                   " Posthoc takes long to load so many: a smaller world, or an earlier moment, is better.";
}

}  // namespace

DialogDecision Dialogs::trace_dialog(const Look& look) {
  heading(look, "Export the trace");
  paragraph(look.fonts.ui, look.theme.dim,
            "Every event of the leading pane's run so far. The ending of the name decides the format: "
            ".trace.yaml or "
            ".trace.json for "
            "the Posthoc visualiser, .jsonl for programs: JSON Lines.");
  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##path", "folder/name.trace.yaml", &capture_path_,
                           ImGuiInputTextFlags_AutoSelectAll);
  hint(look, {"File", "", "A file of that name is replaced once the new one is complete."});
  const Result<TraceFormat> format = trace_format(capture_path_);
  const bool posthoc = format.ok() && *format != TraceFormat::json_lines;
  if (posthoc) {
    toggle(look, "With its map", trace_map_);
    hint(look, {"With its map", "",
                "Writes what the robot knows at the beginning to a .map file of the same name: open it in "
                "Posthoc as "
                "the layer under the trace."});
  }
  paragraph(look.fonts.ui, format ? look.theme.dim : look.theme.warning,
            format ? prospect(trace_facts_, *format) : as_sentence(format.error()) + ".");
  const Answer answer = confirm(look, "Export");
  if (answer == Answer::no) return {.kind = DialogDecision::Kind::cancel};
  if (answer == Answer::none || !format) return {};
  DialogDecision decision{.kind = DialogDecision::Kind::export_trace, .path = capture_path_};
  decision.map = posthoc && trace_map_;
  return decision;
}

}  // namespace replan::ui

// Where a trace of the run goes, and whether its map goes with it.
#include "core/export/posthoc.hpp"
#include "ui/shell/dialogs.hpp"
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

void Dialogs::ask_trace(const TraceFacts& facts, FileDialogSpec spec, const WorkPlace& place) {
  trace_facts_ = facts;
  spec.title = "Export the trace of the leading pane";
  spec.action = "Export";
  spec.filters = {{"For the Posthoc visualiser (.trace.yaml)", {".trace.yaml"}},
                  {"For the Posthoc visualiser (.trace.json)", {".trace.json"}},
                  {"JSON Lines, for programs (.jsonl)", {".jsonl"}}};
  spec.options_height = 52;
  spec.options = [this](const Look& look, const std::string& name) { trace_options(look, name); };
  choose_file(std::move(spec), place, DialogDecision::Kind::export_trace);
}

void Dialogs::trace_options(const Look& look, const std::string& name) {
  const Result<TraceFormat> format = trace_format(name);
  if (!format) return paragraph(look.fonts.ui, look.theme.warning, as_sentence(format.error()) + ".");
  paragraph(look.fonts.ui, look.theme.dim, prospect(trace_facts_, *format));
  if (*format == TraceFormat::json_lines) return;
  toggle(look, "With its map", trace_map_);
  hint(look,
       {"With its map", "",
        "Writes what the robot knows at the beginning to a .map file of the same name: open it in Posthoc as "
        "the layer under the trace."});
}

}  // namespace replan::ui

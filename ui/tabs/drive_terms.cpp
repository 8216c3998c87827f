// Part of the Drive tab: the terms of a sample's score.
#include <array>
#include <string>
#include <vector>

#include "core/debug/arc_words.hpp"
#include "ui/shell/format.hpp"
#include "ui/tabs/drive_picture.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Distances end at the reach: what is farther away is as good as nothing.
std::string raw_text(const DriveWhy& why, ScoreTerm term, double raw) {
  const bool is_distance = term == ScoreTerm::known || term == ScoreTerm::unknown;
  const bool far = is_distance && raw >= why.settings.reach;
  return (far ? "≥ " : "") + fixed(raw, 2) + " " + std::string(score_term_unit(term));
}

std::string lead_text(double lead) {
  const std::string digits = fixed(lead < 0 ? -lead : lead, 3);
  return digits == "0.000" ? "0" : (lead < 0 ? "−" : "+") + digits;
}

struct TermRow {
  std::string name, raw, weighing, share, lead;
  bool strong = false;
};

TermRow term_row(const DriveWhy& why, const DriveSample& sample, const DriveSample* other, std::size_t i) {
  const auto term = static_cast<ScoreTerm>(i);
  TermRow row{std::string(score_term_name(term)), raw_text(why, term, sample.raw[i]),
              "× " + fixed(why.settings.weights[i], 2), "—", "—"};
  if (!sample.admissible()) return row;
  row.weighing = fixed(sample.normalised[i], 2) + " " + row.weighing;
  row.share = fixed(sample.weighted[i], 3);
  if (other != nullptr && other->admissible()) row.lead = lead_text(sample.weighted[i] - other->weighted[i]);
  return row;
}

TermRow sum_row(const DriveSample& sample, const DriveSample* other) {
  TermRow row{"sum", "", "", "—", "—", true};
  if (!sample.admissible()) return row;
  row.share = fixed(sample.score, 3);
  if (other != nullptr && other->admissible()) row.lead = lead_text(sample.score - other->score);
  return row;
}

}  // namespace

void term_table(Frame& frame, const DriveWhy& why, const DriveSample& sample, const DriveSample* other) {
  const Look& look = frame.look;
  // Each as wide as what stands in it; where there is no room for all, the shares say enough.
  const bool wide = ImGui::GetContentRegionAvail().x >= look.px(320);
  std::vector<Column> columns = {{"term", 63, Align::left}, {"value", 70.5f}};
  if (wide) columns.push_back({"× weight", 91.5f});
  columns.push_back({"share", 48.7f});
  if (other != nullptr) columns.push_back({"lead", 55.7f});
  table_header(look, columns);
  hint(look,
       {"", "",
        "Each value is brought to the scale of 0 to 1, which is norm., and multiplied by its weight: the "
        "shares add up to the score. The lead is over the sample below."});
  std::vector<TermRow> rows;
  for (std::size_t i = 0; i < kScoreTerms; ++i) rows.push_back(term_row(why, sample, other, i));
  rows.push_back(sum_row(sample, other));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TermRow& row = rows[i];
    std::vector<TableCell> cells = {{row.name, look.theme.dim}, {row.raw}};
    if (wide) cells.push_back({row.weighing, look.theme.dim});
    cells.push_back({row.share, 0, row.strong});
    if (other != nullptr) cells.push_back({row.lead, 0, row.strong});
    table_row(look, static_cast<int>(i), columns, cells);
  }
}

}  // namespace replan::ui

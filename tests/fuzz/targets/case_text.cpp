#include "core/export/case_text.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(case_text) {
  is_case_text(input);
  const auto moment = parse_case_text(input, "the clipboard");
  require_good_error(moment, "the clipboard");
  if (!moment) return;
  require(moment->pane < moment->scenario.planners.size(), "the pane is one of the scenario's");
  require(moment->scenario.map_file.empty(), "the map comes with the text");
  const std::string text = scenario_text(moment->scenario);
  const auto again = parse_scenario(text, "again.json", "/nowhere");
  require(again.ok() && *again == moment->scenario, "the scenario is whole");
}

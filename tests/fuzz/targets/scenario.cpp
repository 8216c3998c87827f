#include "core/world/scenario.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(scenario) {
  const auto scenario = parse_scenario(std::string(input), "f.json", "/nowhere");
  require_good_error(scenario, "f.json:");
  if (!scenario) return;
  const std::string text = scenario_text(*scenario);
  const auto again = parse_scenario(text, "again.json", "/nowhere");
  require(again.ok(), "what was written is read back: " + (again.ok() ? "" : again.error()));
  require(*again == *scenario, "what was written is read back equal");
}

#include "core/world/formats/movingai.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(movingai_scen) {
  const auto scen = parse_scen(input, "f.scen");
  require_good_error(scen, "f.scen:");
  if (!scen) return;
  for (const ScenProblem& problem : scen->problems)
    require(scen->agrees(problem.length, problem), "a printed length agrees with itself");
  const auto again = parse_scen(scen_text(*scen), "again.scen");
  require(again.ok(), "what was written is read back");
  require(scen_text(*again) == scen_text(*scen), "and is written the same again");
}

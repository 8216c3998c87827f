#include "core/experiment/experiment.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(experiment) {
  const auto experiment = parse_experiment(std::string(input), "f.json", "/nowhere");
  require_good_error(experiment, "f.json:");
  if (!experiment) return;
  const std::string text = experiment_text(*experiment);
  const auto again = parse_experiment(text, "again.json", "/nowhere");
  require(again.ok(), "what was written is read back: " + (again.ok() ? "" : again.error()));
  require(experiment_text(*again) == text, "what was written is read back equal");
}

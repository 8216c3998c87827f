#include "core/experiment/run_result.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(result_line) {
  const auto result = parse_result_line(std::string(input), "f.jsonl");
  require_good_error(result, "f.jsonl:");
  if (!result) return;
  const auto again = parse_result_line(result_line(*result), "again.jsonl");
  require(again.ok(), "what was written is read back: " + (again.ok() ? "" : again.error()));
  require(result_line(*again) == result_line(*result), "what was written is read back equal");
}

#include "core/world/formats/ros_map.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(ros_yaml) {
  const auto info = parse_ros_yaml(input, "f.yaml");
  require_good_error(info, "f.yaml:");
  if (!info) return;
  const auto again = parse_ros_yaml(ros_yaml_text(*info), "again.yaml");
  require(again.ok(), "what was written is read back: " + (again.ok() ? "" : again.error()));
  require(*again == *info, "what was written is read back equal");
}

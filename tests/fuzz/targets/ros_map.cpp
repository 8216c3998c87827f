// A `.yaml` and behind a line "%%" the picture that it is for.
#include "core/world/formats/ros_map.hpp"

#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(ros_map) {
  constexpr std::string_view kParting = "%%\n";
  const std::size_t parting = input.find(kParting);
  if (parting == std::string_view::npos) return;
  const auto info = parse_ros_yaml(input.substr(0, parting), "f.yaml");
  const auto picture = decode_picture(input.substr(parting + kParting.size()), "f.pgm", 1 << 16);
  if (!info || !picture) return;
  const RosCounts counts = count_ros_cells(*picture, *info);
  const GridMap map = ros_cells(*picture, *info, UnknownCells::unmapped);
  std::int64_t found[3] = {};
  for (const std::uint8_t cell : map.blocked) ++found[cell];
  require(RosCounts{found[kFree], found[kObstacle], found[kUnmapped]} == counts,
          "every cell is counted once");
  const GridMap free = ros_cells(*picture, *info, UnknownCells::free);
  const GridMap blocked = ros_cells(*picture, *info, UnknownCells::blocked);
  for (std::size_t i = 0; i < map.blocked.size(); ++i)
    require(map.blocked[i] == kUnmapped
                ? free.blocked[i] == kFree && blocked.blocked[i] == kObstacle
                : free.blocked[i] == map.blocked[i] && blocked.blocked[i] == map.blocked[i],
            "the choice is about unknown cells alone");
}

// Plans across a hall, meets a wall on the way that the plan knew nothing of, and plans round it.
#include <cstdio>
#include <vector>

#include "core/plan/replanner.hpp"

int main() {
  const replan::Box hall(40, 30);                      // with a third number it has floors
  std::vector<std::uint8_t> cells(hall.node_count());  // row by row; all of it free
  auto made = replan::Replanner::make(hall, cells, "dstar-lite", {{"heuristic", "euclidean"}});
  if (!made) {
    std::printf("%s\n", made.error().c_str());
    return 1;
  }
  replan::Replanner& planner = *made;
  const auto planned = planner.plan({2, 15}, {37, 15});
  if (!planned || *planned != replan::PlanStatus::found) return 1;
  const double before = planner.cost();

  const replan::Cell robot = planner.path()[10];
  std::vector<replan::Replanner::Change> wall;
  for (int y = 5; y < 30; ++y) wall.push_back({{20, y}, true});
  const auto replanned = planner.change(wall, robot);
  if (!replanned || *replanned != replan::PlanStatus::found) return 1;

  std::printf("%.3f cells to go, and after 10 of them %.3f round the wall, %zu steps\n", before,
              planner.cost(), planner.path().size() - 1);
  return before == 35 && planner.cost() > before - 10 ? 0 : 1;
}

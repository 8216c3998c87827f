// The robot of the D* Lite papers: it goes from each cell to the next one on its plan.
#pragma once

#include "core/sim/mission.hpp"

namespace replan {

class CellRobot final : public Mission {
 public:
  static RobotInfo describe() {
    return {.name = "Cell by cell", .summary = "Goes along its plan, from each cell to the next."};
  }
  using Mission::Mission;

 private:
  void move() override { step_along(1); }
};

}  // namespace replan

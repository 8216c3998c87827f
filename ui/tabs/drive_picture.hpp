// Parts of the Drive tab: the motions that the robot could choose from, as pictures, and the terms of two of them.
#pragma once

#include "core/scene/arcs.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

/// The samples, speed upwards and turn rate across, each coloured as its arc; beside them where their window lies among
/// all speeds and turn rates. A click chooses View::motion.
void draw_windows(Frame& frame, const DriveWhy& why);

/// Every term of a sample; `other` is the one that it is compared with, or nullptr.
void term_table(Frame& frame, const DriveWhy& why, const DriveSample& sample, const DriveSample* other);

}  // namespace replan::ui

// The studies there are, each in a file of its own: for the list of them alone.
#pragma once

#include "core/study/study.hpp"

namespace replan {

StudyInfo dld_table_study();
StudyInfo dld_surprise_study();
StudyInfo dld_random_study();
StudyInfo dld_maze_study();
StudyInfo astar_table_study();
StudyInfo fusion_study();
StudyInfo auv_study();
StudyInfo informed_rrt_study();

}  // namespace replan

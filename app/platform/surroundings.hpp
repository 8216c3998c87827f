// What the system has around the window: where things are kept, and how work is done.
#pragma once

#include "ui/documents/documents.hpp"

namespace replan::app {

ui::Surroundings surroundings(WorkPlace work);

}  // namespace replan::app

// Where a film or a picture of the window goes.
#include "ui/shell/dialogs.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

void Dialogs::ask_capture(bool film, bool window, FileDialogSpec spec, const WorkPlace& place) {
  spec.title = film ? "Record a film" : "Save a picture";
  spec.action = film ? "Record" : "Save";
  if (film) {
    spec.filters = {{"Film (.gif)", {".gif"}},
                    {"Film (.webp)", {".webp"}},
                    {"Film (.mp4)", {".mp4"}},
                    {"Numbered pictures in a folder", {"/"}}};
    spec.options_height = 52;
    spec.options = [this](const Look& look, const std::string&) {
      slider(
          look,
          {.label = "Frames per second", .min = 10, .max = 50, .initial = 30, .unit = "", .decimals = 0},
          fps_,
          {"Frames per second", "",
           "More are smoother and make a larger file. While it records, time goes by frame by frame: none is "
           "dropped."});
    };
  } else {
    spec.filters = {{"Picture as on the screen (.png)", {".png"}}};
    if (!window) spec.filters.push_back({"Drawing of the canvas (.svg)", {".svg"}});
  }
  choose_file(std::move(spec), place, DialogDecision::Kind::capture);
}

}  // namespace replan::ui

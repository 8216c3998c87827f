// Where a film or a picture of the window goes.
#include "ui/shell/dialogs.hpp"

namespace replan::ui {

void Dialogs::ask_film(const Session& session, bool window, const PixelArea& area, FileDialogSpec spec,
                       const WorkPlace& place) {
  film_.begin(session, window, area);
  spec.title = window ? "Record a film of the window" : "Record a film of the canvas";
  spec.action = "Record";
  spec.filters = system_.films;
  spec.options_height = FilmForm::kHeight;
  spec.options = [this](const Look& look, const std::string&) { film_.draw(look); };
  spec.aside = [this](const Look& look, const std::string& name) { film_.draw_facts(look, name); };
  choose_file(std::move(spec), place, DialogDecision::Kind::capture);
}

void Dialogs::ask_picture(bool window, FileDialogSpec spec, const WorkPlace& place) {
  spec.title = window ? "Save a picture of the window" : "Save a picture of the canvas";
  spec.action = "Save";
  spec.filters = {{"Picture as on the screen (.png)", {".png"}}};
  if (!window) spec.filters.push_back({"Drawing of the canvas (.svg)", {".svg"}});
  choose_file(std::move(spec), place, DialogDecision::Kind::capture);
}

}  // namespace replan::ui

// A window, or a canvas alone, drawn in memory.
#pragma once

#include <memory>

#include "app/platform/offscreen.hpp"
#include "core/session/session.hpp"
#include "ui/canvas/panes.hpp"
#include "ui/shell/shell.hpp"

namespace replan::app {

struct StudioSettings {
  int width = 1440;  ///< pixels
  int height = 900;
  double scale = 1;           ///< device pixels per design pixel
  bool window = false;        ///< the whole window rather than the canvas alone
  std::size_t panes = 1;      ///< of the canvas; for a window 0: as many as there is room for
  double seconds = 1.0 / 30;  ///< from picture to picture
  std::vector<ui::ActionId> actions =
      {};                   ///< of the window, done one after the other before the first picture
  std::string dialog = {};  ///< of the window: shown after them (ui/shell/gallery.hpp)
};

class Studio {
 public:
  static Result<std::unique_ptr<Studio>> open(const StudioSettings& settings, const Session& session,
                                              ui::ViewState state);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// A picture of the session as it stands.
  ui::Image shoot(Session& session);

 private:
  Studio(const StudioSettings& settings, ui::ViewState state)
      : settings_(settings), state_(std::move(state)) {}
  void draw(Session& session);
  void do_actions(Session& session);
  void draw_window(Session& session);
  void draw_canvas(const Session& session);

  StudioSettings settings_;
  ui::ViewState state_;
  std::unique_ptr<Offscreen> offscreen_;
  std::unique_ptr<ui::Panes> panes_;  // of the canvas alone
  std::unique_ptr<ui::Shell> shell_;
  bool settled_ = false;
};

}  // namespace replan::app

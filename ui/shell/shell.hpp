// The whole window: lays out the panels, hands keys to actions, and applies what they queued once all is
// drawn.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/canvas.hpp"
#include "ui/gl/imgui_renderer.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/world_dialogs.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

class Shell {
 public:
  /// The renderer's context must be current in draw() and in the destructor.
  explicit Shell(ImGuiRenderer& renderer) : renderer_(renderer) {}

  /// Draws one frame over the whole display, then applies what was asked for. The owner calls
  /// session.update().
  void draw(const Look& look, Session& session, double seconds);
  /// Whether the next frame is due at once, without any input: something plays, searches or fades.
  [[nodiscard]] bool wants_frames(const Session& session) const;

  [[nodiscard]] ViewState& view() { return view_; }
  [[nodiscard]] const ViewState& view() const { return view_; }
  [[nodiscard]] PanelState& panels() { return panels_; }
  [[nodiscard]] const PanelState& panels() const { return panels_; }

  /// Takes over what a scenario says of its view: overlays, theme, camera. The whole world is shown if it
  /// names none.
  void show(const ViewSetup& view);
  /// What the window is about: "maze.json", with a mark if there are unsaved edits.
  [[nodiscard]] static std::string title(const Session& session);
  /// The session's own words if they need characters that the fonts do not hold at first: for
  /// Stage::set_language().
  [[nodiscard]] static std::string words(const Session& session);
  /// Opens a file; asks first if there are unsaved edits.
  void open(Session& session, const std::string& path);
  /// The user wants to close the window. True if it may close now; else the user is asked.
  bool may_close(const Session& session);
  /// The user has decided to quit.
  [[nodiscard]] bool quitting() const { return quitting_; }
  /// What the user wants filmed or pictured, once; its path is as typed_path() makes it.
  std::optional<CaptureRequest> take_capture() { return std::exchange(capture_, std::nullopt); }
  /// A sentence over the canvas for a while.
  void tell(std::string sentence, bool bad);

 private:
  /// What happens once unsaved edits are dealt with.
  struct Pending {
    enum class Kind : std::uint8_t { none, open_dialog, open_file, new_world, quit } kind = Kind::none;
    std::string path;
  };
  struct Message {
    std::string text;
    bool bad = false;
    std::chrono::steady_clock::time_point until;
  };

  void draw_parts(Frame& frame);
  Canvas& canvas(std::size_t pane);
  void fit();
  void draw_canvas(Frame& frame, ImVec2 min, ImVec2 max);
  void draw_message(const Look& look, ImVec2 min, ImVec2 max);
  void draw_splitter(Frame& frame, float x, float top, float bottom);
  void take_keys(Frame& frame);
  void take_commands(Session& session, std::vector<Command>& commands);
  void take_wish(Session& session, Wish wish);
  void ask_for_capture(bool film, bool window);
  void take_decision(Session& session, const Decision& decision);
  void begin(Session& session, Pending pending);
  void go_on(Session& session);
  bool load(Session& session, const std::string& path);
  bool save(Session& session, const std::string& path);
  void complain(const std::string& sentence);
  void replace(Session& session, Scenario scenario, const std::string& file);

  ImGuiRenderer& renderer_;
  std::vector<std::unique_ptr<Canvas>> canvases_;  // by pane
  ViewState view_;
  PanelState panels_;
  Dialogs dialogs_;
  WorldDialogs world_dialogs_;
  Pending pending_;
  Message message_;
  CaptureRequest asked_;  // while its dialog is open
  std::optional<CaptureRequest> capture_;
  bool quitting_ = false;
  bool held_ = false;        // a key that repeats is down
  std::uint64_t drawn_ = 0;  // the session's revision that the last frame showed
};

}  // namespace replan::ui

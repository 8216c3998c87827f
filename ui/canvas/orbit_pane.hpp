// A pane that shows a world in space from outside: it turns, and what is clicked there is pinned as a cell is.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/session/session.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/gl/solid_renderer.hpp"

namespace replan::ui {

/// Where on the screen a pane's picture lies.
struct PaneArea {
  ImVec2 min;
  Viewport view;
};

class OrbitPane {
 public:
  explicit OrbitPane(ImGuiRenderer& renderer) : solids_(renderer.gl()) {}

  /// What the mouse does over the item that was drawn last: a drag turns the world, or with the middle or the right
  /// button moves it, the wheel comes nearer, a click pins the cell under the cursor,
  /// the right button asks for its menu.
  void take_hands(const Look& look, const Run& run, const PaneArea& area, ViewState& state, bool hovered,
                  std::size_t pane);
  /// Draws world and marks; what is under the cursor with them.
  void draw(const Look& look, const Session& session, const Run& run, const Slice& slice,
            const PaneArea& area, const ViewState& state, SceneMemory& memory);
  /// What a legend tells of it.
  [[nodiscard]] const Scene& legend() const { return legend_; }

 private:
  /// What a picture was drawn of: equal keys, equal pictures.
  struct Key {
    std::uint64_t revision = 0, log_id = 0;
    Orbit orbit;
    SolidOptions options;
    Slice slice;
    OverlaySet overlays;
    std::optional<Cell> pinned;
    Viewport view;
    double scale = 1;
    ImU32 free = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };

  void take_wishes(const Run& run, const PaneArea& area, ViewState& state) const;
  void drag(const Look& look, const Run& run, const PaneArea& area, ViewState& state, bool hovered);
  void turn_wheel(const Run& run, const PaneArea& area, ViewState& state, std::size_t pane) const;
  void point(const Run& run, const PaneArea& area, ViewState& state, bool hovered, std::size_t pane);
  void come_nearer(const Run& run, const PaneArea& area, ViewState& state, double steps) const;
  void move(const Run& run, const PaneArea& area, ViewState& state, double right, double down) const;
  void draw_marks(const Look& look, const Run& run, const OrbitLens& lens, const PaneArea& area) const;
  void draw_compass(const Look& look, const OrbitLens& lens, const PaneArea& area) const;
  void tell_legend(const Run& run, const ViewState& state, const OrbitLens& lens, const Viewport& view);

  SolidRenderer solids_;
  SolidMesh mesh_;
  SolidScene scene_;
  Scene legend_;
  std::optional<Key> key_;
  ImTextureID texture_ = nullptr;
  std::string refused_;      // why there is no picture
  std::optional<int> held_;  // the button that went down on it
  bool dragged_ = false;     // and the mouse has moved since
  std::optional<Cell> pointed_;
};

}  // namespace replan::ui

// A pane that shows a world in space from outside: it turns, and what is clicked there is pinned as a cell is.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/session/session.hpp"
#include "ui/canvas/orbit_marks.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/gl/solid_renderer.hpp"

namespace replan::ui {

class OrbitPane {
 public:
  explicit OrbitPane(ImGuiRenderer& renderer) : solids_(renderer.gl()) {}

  /// What the mouse does over the item that was drawn last: a drag turns the world, or with the middle or the right
  /// button moves it, the wheel comes nearer, a click pins the cell under the cursor,
  /// the right button asks for its menu.
  void take_hands(const Look& look, const Run& run, const PaneArea& area, ViewState& state, bool hovered,
                  std::size_t pane);
  /// Draws world and marks; what is under the cursor with them. In a window what takes long is left to the next frames.
  void draw(const Look& look, const Session& session, const Run& run, const Slice& slice,
            const PaneArea& area, const ViewState& state, SceneMemory& memory);
  /// Whether some of the world waits to be drawn in frames to come.
  [[nodiscard]] bool behind() const { return mesh_.waiting() > 0 || scene_.behind; }
  /// What a legend tells of it.
  [[nodiscard]] const Scene& legend() const { return legend_; }
  [[nodiscard]] const SolidBuffers::Uploads& uploads() const { return solids_.uploads(); }

 private:
  /// What a scene was built of: equal keys, equal scenes. A turn builds none.
  struct SceneKey {
    std::uint64_t revision = 0, log_id = 0;
    SolidOptions options;
    bool cut_keeps_lower = false;
    Slice slice;
    OverlaySet overlays;
    FieldSpan range = FieldSpan::whole_run;
    std::optional<Cell> pinned;
    double scale = 1;
    ImU32 free = 0;
    FieldColours colours = FieldColours::viridis;
    friend bool operator==(const SceneKey&, const SceneKey&) = default;
  };
  /// What a picture was drawn of.
  struct PictureKey {
    std::uint64_t scene = 0, mesh = 0;
    Orbit orbit;
    Box world;
    Viewport view;
    friend bool operator==(const PictureKey&, const PictureKey&) = default;
  };

  void take_wishes(const Run& run, const PaneArea& area, ViewState& state) const;
  bool take_compass(const Look& look, const Run& run, const PaneArea& area, ViewState& state) const;
  void drag(const Look& look, const Run& run, const PaneArea& area, ViewState& state, bool hovered);
  void turn_wheel(const Run& run, const PaneArea& area, ViewState& state, std::size_t pane) const;
  void point(const Run& run, const PaneArea& area, ViewState& state, bool hovered, std::size_t pane);
  void pinch(const Pinch& pinch, const Run& run, const PaneArea& area, ViewState& state) const;
  void come_nearer(const Run& run, const PaneArea& area, ViewState& state, double steps) const;
  void move(const Run& run, const PaneArea& area, ViewState& state, double right, double down) const;
  void build(const Look& look, const Session& session, const Run& run, const Slice& slice,
             const OrbitLens& lens, const ViewState& state, SceneMemory& memory);
  void draw_picture(const Look& look, const Run& run, const OrbitLens& lens, const PaneArea& area,
                    const ViewState& state);
  void tell_state(const Look& look, const Run& run, const PaneArea& area) const;
  void tell_legend(const Run& run, const ViewState& state, const OrbitLens& lens, const Viewport& view);

  SolidRenderer solids_;
  SolidMesh mesh_;
  SolidScene scene_;
  std::uint64_t scene_number_ = 0;  // another one for each that is built
  Scene legend_;
  std::optional<SceneKey> scene_key_;
  std::optional<PictureKey> picture_key_;
  ImTextureID texture_ = nullptr;
  std::string refused_;      // why there is no picture
  std::optional<int> held_;  // the button that went down on it
  bool dragged_ = false;     // and the mouse has moved since
  std::optional<Cell> pointed_;
};

}  // namespace replan::ui

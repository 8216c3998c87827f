// The dialogs that change the world as a whole: another size, or a map out of a seed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "core/session/session.hpp"
#include "core/world/generators/list.hpp"
#include "ui/look.hpp"
#include "ui/shell/dialogs/map_sketch.hpp"

namespace replan::ui {

class WorldDialogs {
 public:
  /// Each begins at the next draw; previews are made at `place`.
  void show_resize(const Session& session, const WorkPlace& place);
  void show_generate(const Session& session, const WorkPlace& place);
  [[nodiscard]] bool open() const { return kind_ != Kind::none; }

  /// Draws what is open and appends the command that comes of it.
  void draw(const Look& look, const Session& session, std::vector<Command>& commands);

 private:
  enum class Kind : std::uint8_t { none, resize, generate };
  /// What the wishes lead to, or why they cannot be met.
  struct Preview {
    MapSketch sketch, front;
    std::string error;
    Box size;
  };
  /// A world before and after, seen from one side.
  struct ResizeView {
    int width, height, new_width, new_height;
    int across, down;  // how far the old world's first corner moves
    Cell start, goal;  // of the old one
  };

  void resize(const Look& look, const Session& session, std::vector<Command>& commands);
  void anchors(const Look& look);
  void resize_view(const Look& look, const MapSketch& sketch, const ResizeView& view, ImVec2 size) const;
  void resize_preview(const Look& look, const Session& session, ImVec2 size) const;
  void generate(const Look& look, std::vector<Command>& commands);
  bool generator_settings(const Look& look);
  void make_preview();
  void take_preview();
  void seed_field(const Look& look);
  void generate_view(const Look& look, const MapSketch& sketch, int rows, ImVec2 size) const;
  void generate_preview(const Look& look, ImVec2 size) const;
  [[nodiscard]] const GeneratorInfo& generator_info() const;

  Kind kind_ = Kind::none;
  Box drawn_;                 // size of the generated world that the sketch is of
  MapSketch sketch_, front_;  // of the world before a change of size, or of the generated one
  int sketched_depth_ = 1;    // of the former
  NewSize size_;
  GenerateWorld wanted_{.generator = "maze", .settings = {}, .width = 61, .height = 41, .seed = 1};
  bool stale_ = true;  // the preview shows other wishes
  std::unique_ptr<Background<Preview>> preview_;
  std::string error_;
};

}  // namespace replan::ui

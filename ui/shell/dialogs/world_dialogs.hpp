// The dialogs that change the world as a whole: another size, or a map out of a seed.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/background.hpp"
#include "core/session/session.hpp"
#include "ui/look.hpp"
#include "ui/shell/dialogs/map_sketch.hpp"

namespace replan::ui {

class WorldDialogs {
 public:
  /// Each begins at the next draw; previews are made at `place`.
  void show_resize(const Session& session);
  void show_generate(const Session& session, const WorkPlace& place);
  [[nodiscard]] bool open() const { return kind_ != Kind::none; }

  /// Draws what is open and appends the command that comes of it.
  void draw(const Look& look, const Session& session, std::vector<Command>& commands);

 private:
  enum class Kind : std::uint8_t { none, resize, generate };
  /// What the wishes lead to, or why they cannot be met.
  struct Preview {
    MapSketch sketch;
    std::string error;
    int width, height;
  };

  void resize(const Look& look, const Session& session, std::vector<Command>& commands);
  void anchors(const Look& look);
  void resize_preview(const Look& look, const Session& session, ImVec2 size) const;
  void generate(const Look& look, std::vector<Command>& commands);
  bool generator_settings(const Look& look);
  void make_preview();
  void generate_preview(const Look& look, ImVec2 size) const;

  Kind kind_ = Kind::none;
  bool fresh_ = false;
  int drawn_width_ = 0, drawn_height_ = 0;  // of the generated world that the sketch is of
  MapSketch sketch_;                        // of the world before a change of size, or of the generated one
  NewSize size_;
  GenerateWorld wanted_{.generator = "maze", .settings = {}, .width = 61, .height = 41, .seed = 1};
  bool stale_ = true;  // the preview shows other wishes
  std::unique_ptr<Background<Preview>> preview_;
  std::string error_;
};

}  // namespace replan::ui

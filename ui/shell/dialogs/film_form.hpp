// What there is to choose of a film, beside where it goes: what it shows, how large, how fast; and what comes of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/session/session.hpp"
#include "ui/look.hpp"
#include "ui/shell/recording.hpp"

namespace replan::ui {

class FilmForm {
 public:
  /// Of that session; what was chosen last is proposed.
  void begin(const Session& session, bool window, const PixelArea& area);
  void choose(FilmPart part) { part_ = part; }
  /// The controls, kHeight high in the design.
  void draw(const Look& look);
  /// Size, frames and length of the film as it stands.
  void draw_facts(const Look& look, const std::string& name);
  [[nodiscard]] FilmChoice choice() const;

  static constexpr float kHeight = 112;

 private:
  struct Count {
    FilmChoice of;
    std::size_t events = 0;                  ///< of the log that was counted
    std::optional<std::size_t> frames = {};  ///< nothing: the run has yet to come that far
  };
  const Count& count();
  void draw_size(const Look& look, float width);
  void draw_own_size(const Look& look);

  const Session* session_ = nullptr;
  bool window_ = false;
  int width_ = 0, height_ = 0;  // of what is filmed
  FilmPart part_ = FilmPart::live;
  int size_ = 0, rate_ = 0, speed_ = 0;  // numbers of their lists
  std::int64_t own_width_ = 800, own_height_ = 600;
  std::optional<Count> count_;
};

}  // namespace replan::ui

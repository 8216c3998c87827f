// The words of the field, each with its explanation; they stay open beside the canvas.
#pragma once

#include <string>
#include <string_view>

#include "ui/tabs/tab.hpp"

namespace replan::ui {

struct PanelState;
struct ViewState;

class WordsTab final : public SideTab {
 public:
  void draw(Frame& frame) override;
  /// Scrolls to a word of the glossary and lights it.
  void show_word(std::string_view id);
  /// The word that was asked for last, by its id; empty if none was.
  [[nodiscard]] std::string_view lit() const { return lit_; }

 private:
  std::string typed_;
  std::string_view lit_;  // the id of the word that was asked for
  bool reveal_ = false;   // it is to be scrolled to
};

/// Opens the glossary at a word, by its id.
void show_word(ViewState& view, PanelState& panels, std::string_view id);
/// Opens it as it stands.
void show_glossary(ViewState& view, PanelState& panels);

}  // namespace replan::ui

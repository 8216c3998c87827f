// A sentence over the canvas for a while: what was done, or what went wrong.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/look.hpp"

namespace replan::ui {

enum class Tone : std::uint8_t {
  done,  ///< something was done
  hint,  ///< what to do instead
  bad    ///< something went wrong
};

class Message {
 public:
  void tell(std::string sentence, Tone tone);
  void tell(std::string sentence, bool bad) { tell(std::move(sentence), bad ? Tone::bad : Tone::done); }
  void clear() { text_.clear(); }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& sentence() const { return text_; }
  /// Above the middle of the lower edge of this area.
  void draw(const Look& look, ImVec2 min, ImVec2 max);

 private:
  std::string text_;
  Tone tone_ = Tone::done;
  std::chrono::steady_clock::time_point until_;
};

}  // namespace replan::ui

// A sentence over the canvas for a while: what was done, or what went wrong.
#pragma once

#include <chrono>
#include <string>

#include <imgui.h>

#include "ui/look.hpp"

namespace replan::ui {

class Message {
 public:
  void tell(std::string sentence, bool bad);
  void clear() { text_.clear(); }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  [[nodiscard]] const std::string& sentence() const { return text_; }
  /// Above the middle of the lower edge of this area.
  void draw(const Look& look, ImVec2 min, ImVec2 max);

 private:
  std::string text_;
  bool bad_ = false;
  std::chrono::steady_clock::time_point until_;
};

}  // namespace replan::ui

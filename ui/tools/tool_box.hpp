// The tools of a window, with what each remembers from one press to the next.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "ui/parts.hpp"
#include "ui/tools/tool.hpp"

namespace replan::ui {

class ToolBox {
 public:
  ToolBox();

  [[nodiscard]] Tool& chosen() const { return *tools_[chosen_]; }
  [[nodiscard]] const ToolKind& kind() const { return tool_kinds()[chosen_]; }
  [[nodiscard]] std::string_view chosen_id() const { return kind().id; }
  template <class T>
  [[nodiscard]] T& get() const {
    return part_of<T>(tools_);
  }

 private:
  friend void choose_tool(ViewState& view, std::string_view id);

  std::vector<std::unique_ptr<Tool>> tools_;  // by their numbers in tool_kinds()
  std::size_t chosen_ = 0;
};

/// Takes the tool in hand and puts the other one away; nothing if there is none of that name.
void choose_tool(ViewState& view, std::string_view id);
/// Puts away the tool in hand: in its place comes that of the beginning, which changes nothing.
void put_tool_away(ViewState& view);
/// Lets go of what is selected or half drawn, the latest first. False if there was nothing.
bool let_go(ViewState& view);
[[nodiscard]] bool holds_something(const ViewState& view);

}  // namespace replan::ui

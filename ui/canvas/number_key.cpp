#include "ui/canvas/number_key.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/scene/cover.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// The enlarged cell and the names in it.
class KeyCell {
 public:
  KeyCell(const Look& look, ImDrawList& list, const PlannerInfo& planner, const Scene& scene, ImVec2 min)
      : look_(look),
        list_(list),
        planner_(planner),
        written_(scene.written),
        min_(min),
        side_(side(look, scene.numbers)) {}

  /// No larger than its names need, so that it fits beside a world.
  static float side(const Look& look, NumbersShown numbers) {
    return look.px(numbers == NumbersShown::four ? 76 : 44);
  }

  void draw(NumbersShown numbers) const {
    list_.AddRectFilled(min_, {min_.x + side_, min_.y + side_}, look_.theme.free);
    list_.AddRect(min_, {min_.x + side_, min_.y + side_}, look_.theme.faint, 0, 0, look_.px.hair);
    const float middle = (side_ - line()) / 2;
    switch (numbers) {
      case NumbersShown::none:
        break;
      case NumbersShown::one:
        centred(cost_name(), middle, look_.theme.text);
        break;
      case NumbersShown::two:
        centred("g", middle - line() * 0.6f, look_.theme.text);
        centred("rhs", middle + line() * 0.6f, look_.theme.rhs);
        break;
      case NumbersShown::four:
        corners();
        break;
    }
  }

 private:
  [[nodiscard]] std::string_view cost_name() const { return planner_.values.field(EventKind::g).label; }
  [[nodiscard]] bool has(NumberMask what) const { return (written_ & what) != 0; }
  [[nodiscard]] float line() const { return look_.fonts.mono->FontSize; }
  [[nodiscard]] float width(std::string_view name) const { return text_width(look_.fonts.mono, name); }
  void write(std::string_view name, float x, float y, ImU32 colour) const {
    draw_text(list_, look_.fonts.mono, {std::round(min_.x + x), std::round(min_.y + y)}, colour, name);
  }
  void centred(std::string_view name, float y, ImU32 colour) const {
    write(name, (side_ - width(name)) / 2, y, colour);
  }
  void corners() const {
    const SearchValues& values = planner_.values;
    const float inset = look_.px.xs, low = side_ - line() - inset;
    const auto right = [&](std::string_view name) { return side_ - width(name) - inset; };
    const Field* first = values.find(EventKind::queue);
    if (has(kNumberG)) write(cost_name(), inset, inset, look_.theme.text);
    if (has(kNumberRhs)) write("rhs", right("rhs"), inset, look_.theme.rhs);
    if (has(kNumberKey) && first != nullptr) write(first->label, inset, low, look_.theme.dim);
    if (has(kNumberKey)) write(values.order.second, right(values.order.second), low, look_.theme.dim);
    if (has(kNumberDist)) centred("dist", (side_ - line()) / 2, look_.theme.dim);
  }

  const Look& look_;
  ImDrawList& list_;
  const PlannerInfo& planner_;
  NumberMask written_;
  ImVec2 min_;
  float side_;
};

/// What the names stand for.
std::string meaning(const PlannerInfo& planner, NumberMask written) {
  const auto has = [written](NumberMask what) { return (written & what) != 0; };
  std::string text = planner.values.lookahead()
                         ? planner.from_goal ? "g is the cost to the goal, as it was settled last."
                                             : "g is the cost from the start, as it was settled last."
                     : planner.values.waves ? "h is the cost of the way to the goal, as far as is known."
                     : planner.from_goal    ? "g is the least cost to the goal that was found so far."
                                            : "g is the least cost from the start that was found so far.";
  if (has(kNumberRhs)) text += " rhs is what the neighbours say now: where the two differ, the cell waits.";
  if (has(kNumberKey) && planner.values.order.second.empty())
    text += " Below stands the key of a cell in the open list: the smallest is taken next.";
  else if (has(kNumberKey))
    text +=
        " Below stands the key of a cell in the open list: the smallest is taken next, and of equal ones "
        "that with the smaller second number.";
  if (has(kNumberDist)) text += " dist is the penalty for lying near an obstacle.";
  return text;
}

/// The corner of the room in which a square hides least of the world: the lower left one, unless another hides less.
PixelBox best_corner(const Scene& scene, double side, const PixelBox& room) {
  const PixelBox world = Cover::world(scene), square{0, 0, side, side};
  const double left = room.left, top = room.top, right = room.right - side, bottom = room.bottom - side;
  const std::array corners = {square.moved_to(left, bottom), square.moved_to(right, bottom),
                              square.moved_to(left, top), square.moved_to(right, top)};
  return *std::min_element(corners.begin(), corners.end(), [&](const PixelBox& a, const PixelBox& b) {
    return a.common(world) < b.common(world);
  });
}

}  // namespace

void draw_number_key(const Look& look, ImDrawList& list, const PlannerInfo& planner, const Scene& scene,
                     ImVec2 origin, const PixelBox& room) {
  if (scene.numbers == NumbersShown::none) return;
  const float margin = look.px.s, side = KeyCell::side(look, scene.numbers) + 2 * margin;
  const PixelBox box = best_corner(scene, static_cast<double>(side), room);
  const ImVec2 min(origin.x + static_cast<float>(box.left), origin.y + static_cast<float>(box.top)),
      max(min.x + side, min.y + side);
  list.AddRectFilled(min, max, with_alpha(look.theme.panel, kChipOpacity), look.px.radius_l);
  list.AddRect(min, max, look.theme.line, look.px.radius_l, 0, look.px.hair);
  KeyCell(look, list, planner, scene, {min.x + margin, min.y + margin}).draw(scene.numbers);
  if (!ImGui::IsMouseHoveringRect(min, max, false)) return;
  const std::string words = meaning(planner, scene.written);
  hint(look, {"The numbers in the cells", "", words.c_str()});
}

}  // namespace replan::ui

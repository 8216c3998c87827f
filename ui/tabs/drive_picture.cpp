#include "ui/tabs/drive_picture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/debug/arc_words.hpp"
#include "core/drive/sample_grid.hpp"
#include "ui/canvas/draw.hpp"
#include "ui/shell/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Motions as places of a rectangle: turn rates across, those to the right on the right, and speeds upwards.
struct MotionPlot {
  ImVec2 min, max;
  SpeedWindow range;

  [[nodiscard]] ImVec2 at(const Twist& motion) const {
    return {min.x + part(motion.w, range.w_low, range.w_high) * (max.x - min.x),
            max.y - part(motion.v, range.v_low, range.v_high) * (max.y - min.y)};
  }
  [[nodiscard]] Twist motion(ImVec2 place) const {
    const auto across = static_cast<double>((place.x - min.x) / (max.x - min.x)),
               up = static_cast<double>((max.y - place.y) / (max.y - min.y));
    return {range.v_low + up * (range.v_high - range.v_low),
            range.w_low + across * (range.w_high - range.w_low)};
  }

 private:
  static float part(double value, double low, double high) {
    return high > low ? static_cast<float>((value - low) / (high - low)) : 0.5f;
  }
};

/// The picture of the samples, a cell for each.
class SamplePicture {
 public:
  SamplePicture(Frame& frame, const DriveWhy& why, ImVec2 min, ImVec2 max)
      : frame_(frame),
        look_(frame.look),
        why_(why),
        grid_(why.explanation, why.settings),
        list_(*ImGui::GetWindowDrawList()),
        min_(min),
        max_(max) {}

  void draw() const;
  /// The sample at a place.
  [[nodiscard]] std::size_t at(ImVec2 place) const {
    const auto number = [](float part, int count) {
      return std::clamp(static_cast<int>(part * static_cast<float>(count)), 0, count - 1);
    };
    return grid_.sample(number((max_.y - place.y) / (max_.y - min_.y), grid_.rows),
                        number((place.x - min_.x) / (max_.x - min_.x), grid_.columns));
  }

 private:
  [[nodiscard]] ScreenArea cell(std::size_t sample) const {
    const auto column = static_cast<float>(grid_.column(sample)), row = static_cast<float>(grid_.row(sample));
    const float wide = (max_.x - min_.x) / static_cast<float>(grid_.columns),
                high = (max_.y - min_.y) / static_cast<float>(grid_.rows);
    return {{std::round(min_.x + column * wide), std::round(max_.y - (row + 1) * high)},
            {std::round(min_.x + (column + 1) * wide), std::round(max_.y - row * high)}};
  }
  void draw_cell(std::size_t sample, ImU32 colour) const;
  void draw_frame(std::size_t sample, ImU32 colour, float width) const;
  void draw_dot(std::size_t sample) const;

  Frame& frame_;
  const Look& look_;
  const DriveWhy& why_;
  SampleGrid grid_;
  ImDrawList& list_;
  ImVec2 min_, max_;
};

/// What is rejected is hatched.
void SamplePicture::draw_cell(std::size_t sample, ImU32 colour) const {
  const auto [low, high] = cell(sample);
  const ImVec2 inner(high.x - look_.px.hair, high.y - look_.px.hair);
  if (why_.explanation.samples[sample].admissible()) return list_.AddRectFilled(low, inner, colour);
  list_.PushClipRect(low, inner, true);
  const float tall = inner.y - low.y;
  for (float x = low.x - tall; x < inner.x; x += look_.px(5))
    list_.AddLine({x, inner.y}, {x + tall, low.y}, colour, look_.px(1));
  list_.PopClipRect();
}

void SamplePicture::draw_frame(std::size_t sample, ImU32 colour, float width) const {
  const auto [low, high] = cell(sample);
  const float out = look_.px(1);
  const ImVec2 min(low.x - out, low.y - out), max(high.x + out, high.y + out);
  list_.AddRect(min, max, look_.theme.outline, look_.px(2), 0, width + look_.px(2));
  list_.AddRect(min, max, colour, look_.px(2), 0, width);
}

void SamplePicture::draw_dot(std::size_t sample) const {
  const auto [low, high] = cell(sample);
  const ImVec2 middle((low.x + high.x) * 0.5f, (low.y + high.y) * 0.5f);
  list_.AddCircleFilled(middle, look_.px(4), look_.theme.outline);
  list_.AddCircleFilled(middle, look_.px(3), look_.theme.accent);
}

void SamplePicture::draw() const {
  const Explanation& why = why_.explanation;
  const ArcColours colours(why);
  const Palette palette = scene_palette(look_.theme, frame_.view.colours);
  list_.AddRectFilled(min_, max_, look_.theme.free);
  for (std::size_t i = 0; i < grid_.sample(grid_.rows, 0); ++i)
    draw_cell(i, colours.of(why.samples[i], palette));
  list_.AddRect(min_, max_, look_.theme.accent, 0, 0, look_.px.hair);
  if (why.decision.winner && why.runner_up) draw_dot(*why.runner_up);
  if (why.decision.winner) draw_frame(*why.decision.winner, look_.theme.accent, look_.px(2));
  const View& view = frame_.view.view;
  if (view.motion)
    if (const auto looked_at = grid_.nearest(why, *view.motion))
      draw_frame(*looked_at, look_.theme.text, look_.px(2));
  if (view.pointed_motion)
    if (const auto pointed = grid_.nearest(why, *view.pointed_motion))
      draw_frame(*pointed, look_.theme.text, look_.px(1));
}

/// What a motion is and came to, while the mouse rests on it; the canvas shows its arc at once.
void point_at_motion(Frame& frame, const DriveWhy& why, const Twist& motion) {
  std::optional<Twist>& pointed = frame.view.view.pointed_motion;
  const DriveSample sample = sample_of(why, motion);
  pointed = sample.motion;
  frame.panels.animated = true;  // it may have been drawn without it
  const std::string title = speed_text(sample.motion.v) + ", " + turn_text(sample.motion.w);
  hint(frame.look, {title.c_str(), "", verdict_sentence(sample, why.explanation, why.settings).c_str()});
}

/// Chooses the motion to look at, or lets go of it if it is that one.
void choose_motion(Frame& frame, const DriveWhy& why, const Twist& motion) {
  std::optional<Twist>& looked_at = frame.view.view.motion;
  const Twist chosen = sample_of(why, motion).motion;
  const bool again = looked_at && sample_of(why, *looked_at).motion == chosen;
  looked_at = again ? std::nullopt : std::optional(chosen);
}

/// Left and Right go from sample to sample.
void step_motion(Frame& frame, const DriveWhy& why, int steps) {
  const Explanation& all = why.explanation;
  const SampleGrid grid(all, why.settings);
  std::optional<Twist>& looked_at = frame.view.view.motion;
  const auto from = looked_at ? grid.nearest(all, *looked_at) : all.decision.winner;
  const int last = static_cast<int>(grid.sample(grid.rows, 0)) - 1;
  const int to = std::clamp(static_cast<int>(from.value_or(0)) + steps, 0, last);
  looked_at = all.samples[static_cast<std::size_t>(to)].motion;
}

/// Words at both ends of a line, and in its middle what there is room for.
void ends(const Look& look, float left, float right, float y, const std::string& at_left,
          const std::string& at_right, const std::string& between = "") {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImFont* small = look.fonts.mono_small;
  const float begin = left + text_width(small, at_left) + look.px.xs,
              end = right - text_width(small, at_right), wide = text_width(small, between);
  draw_text(list, small, {left, y}, look.theme.faint, at_left);
  if (end >= begin) draw_text(list, small, {end, y}, look.theme.faint, at_right);
  if (end - begin >= wide + look.px.xs)
    draw_text(list, small, {std::round((begin + end - wide) * 0.5f), y}, look.theme.faint, between);
}

/// "0.21 left", in rad/s.
std::string side_text(double turn) {
  return fixed(std::abs(turn), 2) + (turn > 0 ? " right" : " left");
}

void draw_samples(Frame& frame, const DriveWhy& why, ImVec2 min, ImVec2 max) {
  const Look& look = frame.look;
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("samples", {max.x - min.x, max.y - min.y});
  tab_stop(look);
  if (const int steps = arrow_steps(look); steps != 0) step_motion(frame, why, steps);
  const SamplePicture picture(frame, why, min, max);
  if (ImGui::IsItemHovered()) {
    const Twist& motion = why.explanation.samples[picture.at(ImGui::GetIO().MousePos)].motion;
    point_at_motion(frame, why, motion);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) choose_motion(frame, why, motion);
  }
  picture.draw();
}

/// All that its motors allow, and in it what is within reach.
void draw_limits(Frame& frame, const DriveWhy& why, ImVec2 min, ImVec2 max) {
  const Look& look = frame.look;
  const DriveLimits& limits = why.limits;
  const MotionPlot plot{min, max, {0, limits.v_max, -limits.w_max, limits.w_max}};
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("limits", {max.x - min.x, max.y - min.y});
  if (ImGui::IsItemHovered()) {
    const Twist motion = plot.motion(ImGui::GetIO().MousePos);
    point_at_motion(frame, why, motion);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) choose_motion(frame, why, motion);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, look.theme.raised);
  const float middle = plot.at({0, 0}).x;
  list.AddLine({middle, min.y}, {middle, max.y}, look.theme.line, look.px.hair);
  const SpeedWindow& window = why.explanation.window;
  const ImVec2 low = plot.at({window.v_high, window.w_low}), high = plot.at({window.v_low, window.w_high});
  list.AddRectFilled(low, {high.x, std::max(high.y, low.y + look.px(2))},
                     with_alpha(look.theme.accent, 0.35f));
  list.AddRect(low, {high.x, std::max(high.y, low.y + look.px(2))}, look.theme.accent, 0, 0, look.px.hair);
  list.AddRect(min, max, look.theme.line, 0, 0, look.px.hair);
  const auto dot = [&](const Twist& motion, ImU32 colour) {
    list.AddCircleFilled(plot.at(motion), look.px(3), look.theme.outline);
    list.AddCircleFilled(plot.at(motion), look.px(2), colour);
  };
  dot(why.state.motion, look.theme.robot);
  if (frame.view.view.motion) dot(sample_of(why, *frame.view.view.motion).motion, look.theme.text);
}

}  // namespace

void draw_windows(Frame& frame, const DriveWhy& why) {
  const Look& look = frame.look;
  const SpeedWindow& window = why.explanation.window;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, small = look.fonts.mono_small->FontSize;
  const float height = look.px(132), gap = look.px.m;
  const float top = origin.y + small + look.px.xs, right = origin.x + std::round((width - gap) * 0.68f);
  const float left = right + gap, far = origin.x + width;
  ends(look, origin.x, right, origin.y, speed_text(window.v_high), "within reach");
  ends(look, left, far, origin.y, speed_text(why.limits.v_max), "limits");
  draw_samples(frame, why, {origin.x, top}, {right, top + height});
  draw_limits(frame, why, {left, top}, {far, top + height});
  const float foot = top + height + look.px.xs;
  ends(look, left, far, foot, "left", "right");
  ends(look, origin.x, right, foot, speed_text(window.v_low), "");
  ends(look, origin.x, right, foot + small, side_text(window.w_low), side_text(window.w_high), "rad/s");
  ImGui::SetCursorScreenPos({origin.x, foot + 2 * small + look.px.xs});
  ImGui::Dummy({0, 0});
  paragraph(
      look.fonts.small, look.theme.faint,
      "The winner has a ring, the runner-up a dot; what is hatched is not admissible. Click a sample to "
      "compare it.");
}

}  // namespace replan::ui

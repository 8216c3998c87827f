#include "ui/shell/frame_share.hpp"

#include <algorithm>

#include <imgui.h>

namespace replan::ui {
namespace {

constexpr double kDisplayFrameMs = 1000.0 / 60;
/// Who has touched nothing for so long waits.
constexpr double kUntouchedSeconds = 0.3;

/// What part of a frame planning has, and how many milliseconds at most.
struct Part {
  double of_frame, most_ms;
};
constexpr Part kInHand{0.3, 10}, kUsual{0.6, 25}, kWaited{0.85, 50};

}  // namespace

double share_of_frame(const FrameUse& use) {
  const Part& part = use.in_hand ? kInHand : use.waited ? kWaited : kUsual;
  const double beside_drawing = use.drawing_ms * part.of_frame / (1 - part.of_frame);
  return std::min(std::max(part.of_frame * kDisplayFrameMs, beside_drawing), part.most_ms);
}

void FrameShare::see(bool key_held) {
  const ImGuiIO& io = ImGui::GetIO();
  now_ = ImGui::GetTime();
  in_hand_ = key_held || ImGui::IsAnyMouseDown();
  const bool moved =
      io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || io.MouseWheelH != 0;
  if (in_hand_ || moved) touched_ = now_;
}

double FrameShare::of(const Session& session, double drawing_ms) const {
  const bool at_work = session.has_steps() || std::any_of(session.runs().begin(), session.runs().end(),
                                                          [](const auto& run) { return run->busy(); });
  const bool waited = at_work && session.playback().direction == 0 && now_ - touched_ >= kUntouchedSeconds;
  return share_of_frame({drawing_ms, in_hand_, waited});
}

}  // namespace replan::ui

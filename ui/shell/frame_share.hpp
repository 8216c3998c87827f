// How much of a frame goes to planning where that is done in step.
#pragma once

#include "core/session/session.hpp"

namespace replan::ui {

/// What a frame is like.
struct FrameUse {
  double drawing_ms = 0;  ///< what its drawing takes, lately
  bool in_hand = false;   ///< somebody draws, drags or holds a key: the hand must not lag
  bool waited = false;    ///< somebody waits for a plan and touches nothing
};

/// In milliseconds: three fifths of a frame, most of it where somebody waits, and less where the hand is at work. Where
/// drawing takes longer than a frame of the display should, planning has as large a part of the longer frame, up to where
/// a window seems to stand still.
double share_of_frame(const FrameUse& use);

/// Watches what the user touches, and so how much the next frame can spare.
class FrameShare {
 public:
  /// Once a frame, while ImGui's input is there. `key_held`: a key that repeats is down.
  void see(bool key_held);
  [[nodiscard]] double of(const Session& session, double drawing_ms) const;

 private:
  double now_ = 0, touched_ = 0;  // ImGui's seconds
  bool in_hand_ = false;
};

}  // namespace replan::ui

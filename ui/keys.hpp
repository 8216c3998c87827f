// Keys by number, as they index ImGuiIO::KeysDown. Printable keys are their upper-case ASCII character; the
// others take the numbers that GLFW gives them, so that the window can pass them on unchanged (asserted
// there).
#pragma once

#include <imgui.h>

namespace replan::ui::key {

inline constexpr int kSpace = ' ';
inline constexpr int kEscape = 256;
inline constexpr int kEnter = 257;
inline constexpr int kTab = 258;
inline constexpr int kBackspace = 259;
inline constexpr int kInsert = 260;
inline constexpr int kDelete = 261;
inline constexpr int kRight = 262;
inline constexpr int kLeft = 263;
inline constexpr int kDown = 264;
inline constexpr int kUp = 265;
inline constexpr int kPageUp = 266;
inline constexpr int kPageDown = 267;
inline constexpr int kHome = 268;
inline constexpr int kEnd = 269;
inline constexpr int kF1 = 290;  ///< kF1 + n - 1 is Fn
inline constexpr int kKeypadSubtract = 333;
inline constexpr int kKeypadAdd = 334;
inline constexpr int kKeypadEnter = 335;
inline constexpr int kLeftShift = 340;
inline constexpr int kLeftControl = 341;
inline constexpr int kLeftAlt = 342;
inline constexpr int kLeftSuper = 343;
inline constexpr int kRightShift = 344;
inline constexpr int kRightControl = 345;
inline constexpr int kRightAlt = 346;
inline constexpr int kRightSuper = 347;
inline constexpr int kMenu = 348;
inline constexpr int kCount = 349;

/// Hides a press, and its repeats, from whoever looks for it later in this frame.
void take(ImGuiIO& io, int key);

/// Tells ImGui which numbers its own navigation and text fields listen to.
void install(ImGuiIO& io);

}  // namespace replan::ui::key

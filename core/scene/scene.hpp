// What a view shows, as a list of shapes in world units: drawn by the window, written as SVG, counted by
// tests.
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/point.hpp"
#include "core/debug/kept.hpp"
#include "core/scene/digest.hpp"
#include "core/scene/palette.hpp"
#include "core/scene/view.hpp"
#include "core/session/run.hpp"

namespace replan {

/// Coloured texels over a rectangle of the world: one per cell, or one per pixel where cells are smaller than
/// pixels.
struct Raster {
  double x = 0, y = 0, width = 0, height = 0;  ///< world units
  int columns = 0, rows = 0;
  std::vector<Colour> texels;
};

// Lengths below are in device pixels where they say so, else in world units.

struct Line {
  Point from, to;
  Colour colour;
  float width;  ///< pixels
};
struct Arrow {
  Point from, to;
  Colour colour;
  float width;  ///< pixels
  float head;   ///< length of the head's strokes along the arrow, pixels; 0: a line alone
};
enum class OutlineShape : std::uint8_t { square, corners, diamond, up, down, filled };
/// A mark of one cell, or of a block of cells.
struct Outline {
  double x, y, width, height;
  OutlineShape shape;
  Colour colour;
  float stroke;  ///< pixels
  float inset;   ///< pixels
};
struct Polyline {
  std::vector<Point> points;
  Colour colour;
  float width;     ///< pixels
  Colour casing;   ///< a rim, so that the line stands off any field; 0 alpha: none
  float dash = 0;  ///< pixels, the gaps alike; 0: a line without gaps
};
struct Ring {
  Point centre;
  double radius;
  Colour colour;
  float width;     ///< pixels
  float dash = 0;  ///< pixels, the gaps alike; 0: a ring without gaps
};
enum class Glyph : std::uint8_t { none, dot, target, heading };
struct Disc {
  Point centre;
  float radius;  ///< pixels
  Colour fill;
  Colour rim;
  float rim_width;  ///< pixels
  Glyph glyph = Glyph::none;
  double angle = 0;  ///< of Glyph::heading, radians, x to the right and y down
};
enum class Anchor : std::uint8_t { upper_left, upper_right, lower_left, lower_right, middle };
struct Label {
  Point at;  ///< of the anchor
  Anchor anchor;
  Colour colour;
  std::string text;    ///< UTF-8
  Colour ground = 0;   ///< laid under the words; 0 alpha: none
  bool large = false;  ///< in the size of the window's own numbers
  /// Of the words, against those of a small one.
  [[nodiscard]] double size() const { return large ? 1.2 : 1; }
};
/// Design pixels of a character of a label, and of the part of a line that digits fill.
inline constexpr double kDigitWidth = 6.1, kDigitHeight = 10;
/// How many of them the words of a label are wide.
double label_width(std::string_view words);
using Shape = std::variant<Line, Arrow, Outline, Polyline, Ring, Disc, Label>;

/// Range of a field's values: what the ends of its colour map stand for.
struct FieldRange {
  double low = 0, high = 0;
  friend bool operator==(const FieldRange&, const FieldRange&) = default;
};

/// What can stand in a legend (signs.def).
enum class Sign : std::uint8_t {
#define REPLAN_SIGN(ID, MARK, COLOUR, LABEL, HELP) ID,
#include "core/scene/signs.def"
#undef REPLAN_SIGN
  count
};
/// Some of them.
using SignSet = std::bitset<static_cast<std::size_t>(Sign::count)>;

/// How numbers stand in the cells.
enum class NumbersShown : std::uint8_t {
  none,
  one,   ///< g alone
  two,   ///< g above rhs
  four,  ///< g, rhs and the key in the corners
};
/// Which values they are, as a set.
using NumberMask = std::uint8_t;
inline constexpr NumberMask kNumberG = 1, kNumberRhs = 2, kNumberKey = 4, kNumberDist = 8;

struct Scene {
  Camera camera;              ///< resolved: its zoom is never 0
  int width = 0, height = 0;  ///< pixels of the view
  int columns = 0, rows = 0;  ///< cells of the world
  double scale = 1;           ///< device pixels per design pixel
  Colour background = 0;
  Raster raster;
  std::vector<Shape> shapes;  ///< in the order of drawing
  std::optional<Overlay> field;
  std::optional<FieldRange> range;  ///< nothing if no cell has a value
  std::string field_words;          ///< what the field's values are, of this planner
  std::optional<double> pointed;    ///< the field's value at the cell under the mouse
  NumbersShown numbers = NumbersShown::none;
  NumberMask written = 0;  ///< the values that stand in some cell
  int every_edge = 1;      ///< of the edges of a tree in sight every so manieth is drawn
  SignSet signs;

  [[nodiscard]] bool shows(Sign sign) const { return signs[static_cast<std::size_t>(sign)]; }
  void show(Sign sign) { signs.set(static_cast<std::size_t>(sign)); }
};

/// The view's size in device pixels, and how much of it at the top and at the bottom something else lies on: a world is
/// fitted between them.
struct Viewport {
  int width = 0, height = 0;
  int above = 0, below = 0;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// The camera that a view has: a zoom of 0 becomes one that shows the whole world with a rim of one cell, and
/// the world is moved by less than a pixel onto whole ones.
Camera resolve(const Camera& camera, int columns, int rows, Viewport viewport);

/// What the last replan up to a position of the log came to.
struct RepairFigures {
  std::int64_t number = 0;   ///< 0: there was none
  std::int64_t touched = 0;  ///< vertices whose g or rhs changed or that were expanded
  ReplanCause cause;
  std::int64_t clock = 0;          ///< the robot's step at which it happened
  std::optional<double> ms;        ///< taking in the change and the search; nothing while it goes on
  std::optional<KeptCounts> kept;  ///< of a tree or a population, where the planner keeps one
  std::int64_t steps = 0;          ///< of the planner's main loop, since it began
};

/// What was read out of a run's log before and can be used again. A scene does not depend on it, only its
/// cost does.
class SceneMemory {
 public:
  SceneMemory();
  ~SceneMemory();
  SceneMemory(SceneMemory&&) noexcept;
  SceneMemory& operator=(SceneMemory&&) noexcept;

  /// Expansions of all plans up to a position of the run's log.
  std::int64_t expansions(const Run& run, std::size_t position);
  /// Where a plan is under way at the position: nothing if one stands, else the event at which it began.
  std::optional<std::size_t> searching_since(const Run& run, std::size_t position);
  RepairFigures repair(const Run& run, std::size_t position);

  struct Parts;
  Parts& of(const Run& run);

 private:
  std::unique_ptr<Parts> parts_;
};

/// What `view` shows of the run at its timeline's cursor. The same arguments always give the same scene; the
/// cost follows what is visible and what has changed in the log since `memory` was last used.
Scene build_scene(const Run& run, const View& view, Viewport viewport, const Palette& palette,
                  SceneMemory& memory);
/// As above, for a single picture.
Scene build_scene(const Run& run, const View& view, Viewport viewport, const Palette& palette);

}  // namespace replan

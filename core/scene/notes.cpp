// Words beside cells, each where it hides least of what was drawn before it.
#include <algorithm>
#include <cmath>

#include "core/scene/cell_mark.hpp"
#include "core/scene/context.hpp"
#include "core/scene/cover.hpp"

namespace replan {
namespace {

/// More notes than these stand above their cells as they come.
constexpr std::size_t kMostPlaced = 48;
/// Square pixels of the design that words in a cell may hide, weighed as in Cover.
constexpr double kMostHidden = 90;
/// Places that are tried along each side.
constexpr int kPlacesTried = 20;
/// Design pixels: the height of a line, and the space around the words.
constexpr double kNoteLine = 12, kNoteAcross = 4, kNoteDown = 1.5;

class NotePlacer {
 public:
  NotePlacer(SceneContext& context, Viewport viewport)
      : context_(context), scale_(context.view.scale), cover_(context.scene) {
    if (context.view.taken) cover_.add(*context.view.taken, 2 * Cover::kWords);
    const double margin = 4 * scale_;
    room_ = {margin, viewport.above + margin, viewport.width - margin,
             viewport.height - viewport.below - margin};
  }

  void add(const Note& note, bool search) {
    const PixelBox cell = Cover::cell(context_.scene, note.about);
    const PixelBox size = size_of(note);
    const PixelBox box =
        search ? place(note, size, cell) : size.moved_to(cell.left, cell.top - size.height());
    const bool strayed = note.inside && box.common(cell) <= 0;
    if (strayed || box.apart(cell) > cell.width() * 0.6) lead(note, box, cell);
    draw(note, box);
    cover_.add(box, Cover::kWords);
  }

 private:
  [[nodiscard]] PixelBox size_of(const Note& note) const {
    double width = 0;
    for (const std::string& line : note.lines)
      width = std::max(width, words_width(context_, line) * context_.zoom);
    return {0, 0, width + 2 * kNoteAcross * scale_,
            (kNoteLine * static_cast<double>(note.lines.size()) + 2 * kNoteDown) * scale_};
  }

  /// In the cell only where it has room beside its numbers, and what stands on it.
  [[nodiscard]] PixelBox place(const Note& note, const PixelBox& size, const PixelBox& cell) const {
    if (note.inside) {
      const PixelBox inside = best_inside(size, cell);
      if (cover_.hidden(inside) <= kMostHidden * scale_ * scale_) return inside;
    }
    return best_beside(size, cell);
  }

  /// Up or down in the cell.
  [[nodiscard]] PixelBox best_inside(const PixelBox& size, const PixelBox& cell) const {
    const Cover near = cover_.within(cell);
    const double x = (cell.left + cell.right - size.width()) / 2,
                 middle = (cell.height() - size.height()) / 2;
    PixelBox best = size.moved_to(x, cell.top + middle);
    double least = near.hidden(best);
    for (int i = 0; i <= kPlacesTried; ++i) {
      const double down = (cell.height() - size.height()) * i / kPlacesTried;
      const PixelBox box = size.moved_to(x, cell.top + down);
      const double cost = near.hidden(box) + 0.5 * std::abs(down - middle);
      if (cost >= least) continue;
      least = cost;
      best = box;
    }
    return best;
  }

  /// Anywhere near the cell and in the view. Hiding a number is as bad as being some cells away.
  [[nodiscard]] PixelBox best_beside(const PixelBox& size, const PixelBox& cell) const {
    return cover_.best_beside(size, cell, room_, 6 * scale_, std::max(2.2 * cell.width(), 48 * scale_),
                              4 * scale_);
  }

  /// From the words to a cell that is not next to them.
  void lead(const Note& note, const PixelBox& box, const PixelBox& cell) {
    const auto nearest = [](const PixelBox& to, double x, double y) {
      return std::pair{std::clamp(x, to.left, to.right), std::clamp(y, to.top, to.bottom)};
    };
    const auto [x0, y0] = nearest(box, (cell.left + cell.right) / 2, (cell.top + cell.bottom) / 2);
    const double inset = cell.width() / 8;
    const auto [x1, y1] =
        nearest({cell.left + inset, cell.top + inset, cell.right - inset, cell.bottom - inset}, x0, y0);
    context_.add(Line{world(x0, y0), world(x1, y1), faded(note.colour, 0.7), context_.pixels(1)});
  }

  void draw(const Note& note, const PixelBox& box) {
    const Point corner = world(box.left, box.top);
    context_.add(Outline{corner.x, corner.y, box.width() / context_.zoom, box.height() / context_.zoom,
                         OutlineShape::filled, faded(context_.palette.background, 0.92), 0, 0});
    double y = box.top + (kNoteDown + kNoteLine / 2) * scale_;
    for (const std::string& line : note.lines) {
      context_.add(Label{world((box.left + box.right) / 2, y), Anchor::middle, note.colour, line});
      y += kNoteLine * scale_;
    }
  }

  [[nodiscard]] Point world(double x, double y) const {
    const Scene& scene = context_.scene;
    return {scene.camera.x + (x - scene.width / 2.0) / context_.zoom,
            scene.camera.y + (y - scene.height / 2.0) / context_.zoom};
  }

  SceneContext& context_;
  double scale_;
  Cover cover_;
  PixelBox room_;
};

}  // namespace

void build_notes(SceneContext& context, Viewport viewport) {
  if (context.notes.empty()) return;
  NotePlacer placer(context, viewport);
  const bool search = context.notes.size() <= kMostPlaced;
  for (const Note& note : context.notes) placer.add(note, search);
}

}  // namespace replan

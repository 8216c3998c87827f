#include "ui/canvas/cell_pen.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {
std::vector<CellSpan> CellPen::inside(std::span<const CellSpan> spans) const {
  std::vector<CellSpan> cut;
  for (const CellSpan& span : spans) {
    const CellSpan part{span.y, std::max(0, span.first), std::min(sheet_.box.width() - 1, span.last)};
    if (part.y >= 0 && part.y < sheet_.box.height() && part.first <= part.last) cut.push_back(part);
  }
  return cut;
}

void CellPen::area(std::span<const CellSpan> spans, ImU32 colour, float fill) const {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const CellSpan& span = spans[i];
    const ImVec2 a = at(span.first, span.y), b = at(span.last + 1, span.y + 1);
    if (fill > 0) list_.AddRectFilled(a, b, with_alpha(colour, fill));
    side({a.x, a.y}, {a.x, b.y}, colour);
    side({b.x, a.y}, {b.x, b.y}, colour);
    edge_towards(span, i > 0 ? &spans[i - 1] : nullptr, a.y, colour);
    edge_towards(span, i + 1 < spans.size() ? &spans[i + 1] : nullptr, b.y, colour);
  }
}

void CellPen::dashed(ImVec2 a, ImVec2 b, ImU32 colour) const {
  const float dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy), dash = look_.px(5);
  if (length <= 0) return;
  for (float from = 0; from < length; from += 2 * dash) {
    const float to = std::min(length, from + dash);
    list_.AddLine({a.x + dx * from / length, a.y + dy * from / length},
                  {a.x + dx * to / length, a.y + dy * to / length}, colour, look_.px(1.6f));
  }
}

bool CellPen::meets(const CellBox& box) const {
  const CellBox part = seen(box);
  return part.low.z <= sheet_.layer && sheet_.layer <= part.high.z;
}

void CellPen::fill(const CellBox& box, ImU32 colour) const {
  const CellBox part = seen(box);
  list_.AddRectFilled(at(part.low.x, part.low.y), at(part.high.x + 1, part.high.y + 1), colour);
}

void CellPen::dashed_frame(const CellBox& box, ImU32 colour) const {
  const CellBox part = seen(box);
  const ImVec2 a = at(part.low.x, part.low.y), b = at(part.high.x + 1, part.high.y + 1);
  dashed(a, {b.x, a.y}, colour);
  dashed({b.x, a.y}, b, colour);
  dashed({a.x, b.y}, b, colour);
  dashed(a, {a.x, b.y}, colour);
}

ImVec2 CellPen::at(int column, int row) const {
  const ImVec2 point = screen_({static_cast<double>(column), static_cast<double>(row)});
  return {std::round(point.x), std::round(point.y)};
}

/// The part of a span's edge at height `y` that its neighbour does not cover.
void CellPen::edge_towards(const CellSpan& span, const CellSpan* next, float y, ImU32 colour) const {
  const auto part = [&](int first, int last) {
    if (first <= last) side({at(first, 0).x, y}, {at(last + 1, 0).x, y}, colour);
  };
  if (next == nullptr || next->last < span.first || next->first > span.last) {
    part(span.first, span.last);
    return;
  }
  part(span.first, next->first - 1);
  part(next->last + 1, span.last);
}

}  // namespace replan::ui

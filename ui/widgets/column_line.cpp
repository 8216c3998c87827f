#include "ui/widgets/column_line.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {
namespace {

/// Points that ImGui draws at once: it takes up to four corners for each.
constexpr std::size_t kPiece = 8192;

}  // namespace

std::vector<ImVec2> column_line(std::span<const ImVec2> line) {
  std::vector<ImVec2> kept;
  for (auto first = line.begin(); first != line.end();) {
    const float column = std::floor(first->x);
    const auto end = std::find_if(first, line.end(),
                                  [column](const ImVec2& point) { return std::floor(point.x) != column; });
    auto [one, other] = std::minmax_element(
        first, end, [](const ImVec2& left, const ImVec2& right) { return left.y < right.y; });
    if (other < one) std::swap(one, other);
    kept.push_back(*one);
    if (other != one) kept.push_back(*other);
    first = end;
  }
  return kept;
}

void draw_long_line(ImDrawList& list, std::span<const ImVec2> line, ImU32 colour, float thick) {
  const std::vector<ImVec2> points = column_line(line);
  // A piece begins with the point that the one before ends with.
  for (std::size_t from = 0; from + 1 < points.size(); from += kPiece - 1) {
    const std::size_t count = std::min(kPiece, points.size() - from);
    list.AddPolyline(points.data() + from, static_cast<int>(count), colour, ImDrawFlags_None, thick);
  }
}

}  // namespace replan::ui

#include "core/world/place_writer.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/base/words.hpp"

namespace replan {
namespace {

/// Cells that are still to be written.
class Untaken {
 public:
  explicit Untaken(std::vector<Cell> cells) : cells_(std::move(cells)), taken_(cells_.size()) {
    std::sort(cells_.begin(), cells_.end(), in_node_order);
  }

  /// The first of them.
  std::optional<Cell> next() {
    while (first_ < cells_.size() && taken_[first_]) ++first_;
    return first_ < cells_.size() ? std::optional(cells_[first_]) : std::nullopt;
  }

  /// Takes the largest box that grows from `first` along one axis after the other, and returns its size.
  Box take_box(Cell first) {
    std::array<int, 3> size{1, 1, 1};
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
      std::array<int, 3> from{0, 0, 0}, slab = size;  // the cells by which the box would grow
      slab[axis] = 1;
      const auto moved = [&] { return Cell{first.x + from[0], first.y + from[1], first.z + from[2]}; };
      for (from[axis] = 1; all_there(moved(), slab); ++from[axis]) ++size[axis];
    }
    each_of(first, size, [this](Cell cell) { taken_[find(cell)] = true; });
    return {size[0], size[1], size[2]};
  }

 private:
  template <class Visit>
  static void each_of(Cell first, const std::array<int, 3>& size, const Visit& visit) {
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x) visit(Cell{first.x + x, first.y + y, first.z + z});
  }
  [[nodiscard]] bool all_there(Cell first, const std::array<int, 3>& size) const {
    bool all = true;
    each_of(first, size, [&](Cell cell) { all = all && find(cell) != cells_.size(); });
    return all;
  }
  /// The index of an untaken cell, or the end.
  [[nodiscard]] std::size_t find(Cell cell) const {
    const auto at = static_cast<std::size_t>(
        std::lower_bound(cells_.begin(), cells_.end(), cell, in_node_order) - cells_.begin());
    return at < cells_.size() && cells_[at] == cell && !taken_[at] ? at : cells_.size();
  }

  std::vector<Cell> cells_;
  std::vector<bool> taken_;
  std::size_t first_ = 0;
};

}  // namespace

Json PlaceWriter::cell(Cell cell) const {
  return coordinates_of(cell, solid_);
}

Json PlaceWriter::cells(std::vector<Cell> cells) const {
  Untaken untaken(std::move(cells));
  Json singles = Json::array(), boxes = Json::array();
  while (const auto first = untaken.next()) {
    const Box size = untaken.take_box(*first);
    if (size.node_count() == 1)
      singles.push_back(cell(*first));
    else if (solid_)
      boxes.push_back({first->x, first->y, first->z, size.width(), size.height(), size.depth()});
    else
      boxes.push_back({first->x, first->y, size.width(), size.height()});
  }
  Json result = Json::object();
  if (!singles.empty()) result["cells"] = std::move(singles);
  if (!boxes.empty()) result[solid_ ? "boxes" : "rectangles"] = std::move(boxes);
  return result;
}

}  // namespace replan

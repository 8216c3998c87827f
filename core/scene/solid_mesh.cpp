#include "core/scene/solid_mesh.hpp"

#include <algorithm>
#include <array>

#include "core/session/run.hpp"

namespace replan {
namespace {

/// The axes beside each axis, in the order x, y, z.
constexpr std::array<std::array<std::size_t, 2>, 3> kBeside = {{{1, 2}, {0, 2}, {0, 1}}};

std::array<int, 3> coordinates(Cell cell) {
  return {cell.x, cell.y, cell.z};
}

/// One layer of faces that look the same way, `width` x `height` colours, 0 where there is none: joins them to
/// rectangles, each as wide as it can be and then as high, and hands them on as (column, row, columns, rows, colour).
template <class Take>
void join(std::vector<Colour>& layer, int width, int height, Take&& take) {
  const auto at = [&](int column, int row) -> Colour& {
    return layer[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Colour colour = at(column, row);
      if (colour == 0) continue;
      int right = column + 1, bottom = row + 1;
      while (right < width && at(right, row) == colour) ++right;
      const auto alike = [&](int y) {
        return std::all_of(&at(column, y), &at(column, y) + (right - column),
                           [&](Colour c) { return c == colour; });
      };
      while (bottom < height && alike(bottom)) ++bottom;
      for (int y = row; y < bottom; ++y)
        std::fill(&at(column, y), &at(column, y) + (right - column), Colour{0});
      take(column, row, right - column, bottom - row, colour);
    }
}

SolidFace face(const std::array<int, 3>& at, std::size_t side, int across, int on, Colour colour) {
  const auto narrow = [](int value) { return static_cast<std::uint16_t>(value); };
  return {narrow(at[0]),  narrow(at[1]), narrow(at[2]), narrow(static_cast<int>(side)),
          narrow(across), narrow(on),    colour};
}

/// The colours of a block's cells and of those around it, 0 where nothing stands: each is asked for from several sides.
struct PaddedBlock {
  std::array<int, 3> low, high;  ///< of the block, the upper ends excluded
  std::vector<Colour> colours;

  [[nodiscard]] Colour& at(const std::array<int, 3>& place) {
    const auto padded = [&](std::size_t axis) {
      return static_cast<std::size_t>(place[axis] - low[axis] + 1);
    };
    return colours[(padded(2) * kSide + padded(1)) * kSide + padded(0)];
  }
  template <class ColourOf>
  void fill(ColourOf&& colour_of) {
    colours.assign(kSide * kSide * kSide, 0);
    for (int z = low[2] - 1; z <= high[2]; ++z)
      for (int y = low[1] - 1; y <= high[1]; ++y)
        for (int x = low[0] - 1; x <= high[0]; ++x) at({x, y, z}) = colour_of(Cell{x, y, z});
  }

  static constexpr std::size_t kSide = SolidMesh::kBlock + 2;
};

/// Adds the faces of a block's k-th layer across an axis that look to one side, where nothing stands before them.
void add_layer(PaddedBlock& cells, std::size_t side, int k, std::vector<SolidFace>& faces) {
  const std::size_t axis = side / 2, a = kBeside[axis][0], b = kBeside[axis][1];
  const int step = side % 2 == 0 ? -1 : 1;
  const int width = cells.high[a] - cells.low[a], height = cells.high[b] - cells.low[b];
  std::array<int, 3> at{};
  const auto go_to = [&](int i, int j) {
    at[axis] = k;
    at[a] = cells.low[a] + i;
    at[b] = cells.low[b] + j;
  };
  std::vector<Colour> layer;
  layer.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Colour any = 0;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      go_to(i, j);
      const Colour colour = cells.at(at);
      at[axis] += step;
      layer.push_back(colour != 0 && cells.at(at) == 0 ? colour : 0);
      any |= layer.back();
    }
  if (any == 0) return;
  join(layer, width, height, [&](int i, int j, int across, int on, Colour colour) {
    go_to(i, j);
    faces.push_back(face(at, side, across, on, colour));
  });
}

}  // namespace

std::size_t SolidMesh::face_count() const {
  std::size_t count = 0;
  for (const Block& block : blocks_) count += block.faces.size();
  return count;
}

void SolidMesh::follow(const Run& run, const RunDigest& digest, const Palette& palette) {
  const Colours colours{palette.obstacle, palette.mover, palette.surprise,
                        mix(palette.free, palette.obstacle, 0.5f)};
  const bool other_world = world_ != run.lattice();
  if (!follower_.follow(run, digest, other_world,
                        [&](const MapEvent& event) { mark(world_.position(event.node)); }))
    begin(run);
  if (log_id_ != run.log_id()) note_surprises(run);
  log_id_ = run.log_id();
  if (colours != colours_) {
    colours_ = colours;
    for (Block& block : blocks_) block.stale = true;
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i].stale) make(run, i);
}

void SolidMesh::begin(const Run& run) {
  world_ = run.lattice();
  const auto blocks = [](int cells) { return (cells + kBlock - 1) / kBlock; };
  grid_ = Box(blocks(world_.width()), blocks(world_.height()), blocks(world_.depth()));
  blocks_.assign(grid_.node_count(), {});
}

void SolidMesh::note_surprises(const Run& run) {
  surprising_.clear();
  for (const Surprise& surprise : run.scenario().surprises)
    for (const CellChange& change : surprise.cells)
      if (change.blocked && !surprise.announced) surprising_.push_back(world_.node(change.cell));
  std::sort(surprising_.begin(), surprising_.end());
}

std::size_t SolidMesh::block_of(Cell cell) const {
  return grid_.node({cell.x / kBlock, cell.y / kBlock, cell.z / kBlock});
}

/// Its block, and those whose faces look at it.
void SolidMesh::mark(Cell cell) {
  for (const Cell by : {Cell{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    const Cell near{cell.x + by.x, cell.y + by.y, cell.z + by.z};
    if (world_.contains(near)) blocks_[block_of(near)].stale = true;
  }
}

Colour SolidMesh::colour_of(const Run& run, NodeId node) const {
  const SearchState& state = run.timeline().state();
  if (state.moving(node)) return colours_.mover;
  const bool truth = state.truly_blocked(node), known = state.known_blocked(node);
  if (!truth && !known) return 0;
  const bool appeared = truth && run.scenario().map.blocked[node] == kFree;
  if (appeared && std::binary_search(surprising_.begin(), surprising_.end(), node)) return colours_.surprise;
  return known ? colours_.obstacle : colours_.unknown;
}

void SolidMesh::make(const Run& run, std::size_t index) {
  Block& block = blocks_[index];
  block.stale = false;
  block.revision = ++revision_;
  block.faces.clear();
  const std::array<int, 3> size = coordinates({world_.width(), world_.height(), world_.depth()});
  PaddedBlock cells{coordinates(grid_.position(static_cast<NodeId>(index))), {}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cells.low[axis] *= kBlock;
    cells.high[axis] = std::min(cells.low[axis] + kBlock, size[axis]);
  }
  cells.fill([&](Cell cell) { return world_.contains(cell) ? colour_of(run, world_.node(cell)) : 0; });
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    const int step = side % 2 == 0 ? -1 : 1;
    for (int k = cells.low[axis]; k < cells.high[axis]; ++k)
      if (k + step >= 0 && k + step < size[axis]) add_layer(cells, side, k, block.faces);
  }
}

std::vector<SolidFace> cut_faces(const Run& run, Axis across, int layer, bool towards_higher, Colour colour) {
  const Box& world = run.lattice();
  const SearchState& state = run.timeline().state();
  const auto axis = static_cast<std::size_t>(across);
  const std::size_t a = kBeside[axis][0], b = kBeside[axis][1];
  const std::array<int, 3> size = coordinates({world.width(), world.height(), world.depth()});
  std::vector<Colour> cells(static_cast<std::size_t>(size[a]) * static_cast<std::size_t>(size[b]));
  std::array<int, 3> at{};
  at[axis] = layer;
  std::size_t next = 0;
  for (at[b] = 0; at[b] < size[b]; ++at[b])
    for (at[a] = 0; at[a] < size[a]; ++at[a]) {
      const NodeId node = world.node({at[0], at[1], at[2]});
      cells[next++] = state.truly_blocked(node) || state.known_blocked(node) ? colour : 0;
    }
  std::vector<SolidFace> faces;
  join(cells, size[a], size[b], [&](int i, int j, int columns, int rows, Colour of) {
    at[axis] = layer;
    at[a] = i;
    at[b] = j;
    faces.push_back(face(at, axis * 2 + (towards_higher ? 1 : 0), columns, rows, of));
  });
  return faces;
}

}  // namespace replan

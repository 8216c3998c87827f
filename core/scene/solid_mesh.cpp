#include "core/scene/solid_mesh.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/scene/cell_colours.hpp"
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

/// What the 16 bits of a face's place can tell.
constexpr int kLongestSide = 65'535;

SolidFace face(const std::array<int, 3>& at, std::size_t side, int across, int on, Colour colour) {
  const auto narrow = [](int value) { return static_cast<std::uint16_t>(value); };
  return {narrow(at[0]),  narrow(at[1]), narrow(at[2]), narrow(static_cast<int>(side)),
          narrow(across), narrow(on),    colour};
}

/// The colours of a block's cells and of those around it, 0 where nothing stands: each is asked for from several sides.
struct PaddedBlock {
  std::array<int, 3> low, high;  ///< of the block, the upper ends excluded
  std::vector<Colour> colours;

  static constexpr std::size_t kSide = SolidMesh::kBlock + 2;
  static constexpr std::array<std::size_t, 3> kStep = {1, kSide, kSide* kSide};

  [[nodiscard]] std::size_t index(const std::array<int, 3>& place) const {
    std::size_t at = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      at += static_cast<std::size_t>(place[axis] - low[axis] + 1) * kStep[axis];
    return at;
  }
  /// Row by row, as `reader.row(first cell, count, colours)` knows them; whether there is anything.
  template <class Reader>
  bool fill(const Box& world, Reader& reader) {
    colours.assign(kSide * kSide * kSide, 0);
    const int left = std::max(low[0] - 1, 0), right = std::min(high[0] + 1, world.width());
    bool any = false;
    for (int z = std::max(low[2] - 1, 0); z < std::min(high[2] + 1, world.depth()); ++z)
      for (int y = std::max(low[1] - 1, 0); y < std::min(high[1] + 1, world.height()); ++y)
        any |= reader.row(world.node({left, y, z}), right - left, &colours[index({left, y, z})]);
    return any;
  }
};

/// Adds the faces of a block's k-th layer across an axis that look to one side, where nothing stands before them.
void add_layer(const PaddedBlock& cells, std::size_t side, int k, std::vector<Colour>& layer,
               std::vector<SolidFace>& faces) {
  const std::size_t axis = side / 2, a = kBeside[axis][0], b = kBeside[axis][1];
  const int width = cells.high[a] - cells.low[a], height = cells.high[b] - cells.low[b];
  std::array<int, 3> at = cells.low;
  at[axis] = k;
  const Colour* row = &cells.colours[cells.index(at)];
  const std::ptrdiff_t across = static_cast<std::ptrdiff_t>(PaddedBlock::kStep[a]),
                       along = static_cast<std::ptrdiff_t>(PaddedBlock::kStep[axis]),
                       before = side % 2 == 0 ? -along : along;
  layer.clear();
  Colour any = 0;
  for (int j = 0; j < height; ++j, row += PaddedBlock::kStep[b]) {
    const Colour* cell = row;
    for (int i = 0; i < width; ++i, cell += across) {
      const Colour colour = cell[before] == 0 ? *cell : 0;
      layer.push_back(colour);
      any |= colour;
    }
  }
  if (any == 0) return;
  join(layer, width, height, [&](int i, int j, int columns, int rows, Colour colour) {
    at[a] = cells.low[a] + i;
    at[b] = cells.low[b] + j;
    faces.push_back(face(at, side, columns, rows, colour));
  });
}

}  // namespace

std::size_t SolidMesh::face_count() const {
  std::size_t count = 0;
  for (const Block& block : blocks_) count += block.faces.size();
  return count;
}

/// Reads the colours of cells, with the pages of the state that hold them at hand.
class SolidMesh::Reader {
 public:
  Reader(const Run& run, const Colours& colours, const std::vector<NodeId>& surprising)
      : state_(run.timeline().state()),
        original_(run.scenario().map.blocked),
        colours_(colours),
        surprising_(surprising) {}

  /// Those of `count` cells from a node on; whether one of them is an obstacle.
  bool row(NodeId first, int count, Colour* colours) {
    bool any = false;
    for (NodeId node = first; node < first + static_cast<NodeId>(count); ++node, ++colours) {
      turn_to(node);
      const std::size_t at = node % SearchState::kPage;
      const std::uint8_t truth = truth_ != nullptr ? truth_[at] : 0,
                         known = known_ != nullptr ? known_[at] : 0;
      if ((truth | known) == 0) continue;
      any = true;
      *colours = colour(node, truth, known != 0);
    }
    return any;
  }

 private:
  void turn_to(NodeId node) {
    if (node / SearchState::kPage == page_) return;
    page_ = node / SearchState::kPage;
    truth_ = state_.map_page(EventKind::truth, node);
    known_ = state_.map_page(EventKind::known, node);
  }
  [[nodiscard]] Colour colour(NodeId node, std::uint8_t truth, bool known) const {
    if (truth >= kMoverUnit) return colours_.mover;
    const bool appeared = truth != 0 && !surprising_.empty() && original_[node] == kFree;
    if (appeared && std::binary_search(surprising_.begin(), surprising_.end(), node))
      return colours_.surprise;
    if (truth == 0) return colours_.gone;
    return known ? colours_.obstacle : colours_.unknown;
  }

  const SearchState& state_;
  const SharedBytes& original_;
  const Colours& colours_;
  const std::vector<NodeId>& surprising_;
  std::size_t page_ = SIZE_MAX;
  const std::uint8_t* truth_ = nullptr;
  const std::uint8_t* known_ = nullptr;
};

SolidMesh::Colours::Colours(const Palette& palette, bool shows_unknown)
    : obstacle(palette.obstacle),
      mover(palette.mover),
      surprise(palette.surprise),
      unknown(shows_unknown ? mix(palette.free, palette.obstacle, 0.5f) : 0),
      gone(shows_unknown ? mix(palette.free, palette.obstacle, 0.3f) : palette.obstacle) {}

void SolidMesh::follow(const Run& run, const RunDigest& digest, const Palette& palette, bool shows_unknown) {
  const Colours colours(palette, shows_unknown);
  const bool other_world = world_ != run.lattice();
  if (other_world) begin(run);
  // Of another log of the same world the faces stay until they are made anew: most are as they were.
  if (!follower_.follow(run, digest, other_world,
                        [&](const MapEvent& event) { mark(world_.position(event.node)); }))
    mark_all();
  if (log_id_ != run.log_id()) note_surprises(run);
  log_id_ = run.log_id();
  if (colours != colours_) mark_all();
  colours_ = colours;
}

void SolidMesh::begin(const Run& run) {
  world_ = run.lattice();
  const auto blocks = [](int cells) { return (cells + kBlock - 1) / kBlock; };
  grid_ = Box(blocks(world_.width()), blocks(world_.height()), blocks(world_.depth()));
  blocks_.assign(grid_.node_count(), {});
  waiting_ = blocks_.size();
  ++revision_;
}

/// Cells of surprises that came or went with another log look otherwise, though nothing stands there that did not.
void SolidMesh::note_surprises(const Run& run) {
  std::vector<NodeId> now = surprising_cells(run), other;
  std::set_symmetric_difference(now.begin(), now.end(), surprising_.begin(), surprising_.end(),
                                std::back_inserter(other));
  for (const NodeId node : other)
    if (node < world_.node_count()) mark(world_.position(node));
  surprising_ = std::move(now);
}

std::size_t SolidMesh::block_of(Cell cell) const {
  return grid_.node({cell.x / kBlock, cell.y / kBlock, cell.z / kBlock});
}

CellBox SolidMesh::cells(std::size_t block) const {
  const Cell at = grid_.position(static_cast<NodeId>(block));
  const Cell low{at.x * kBlock, at.y * kBlock, at.z * kBlock};
  return {low,
          {std::min(low.x + kBlock, world_.width()) - 1, std::min(low.y + kBlock, world_.height()) - 1,
           std::min(low.z + kBlock, world_.depth()) - 1}};
}

/// Its block, and those whose faces look at it.
void SolidMesh::mark(Cell cell) {
  for (const Cell by : {Cell{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    const Cell near{cell.x + by.x, cell.y + by.y, cell.z + by.z};
    if (world_.contains(near)) mark_block(block_of(near));
  }
}

void SolidMesh::mark_all() {
  for (std::size_t i = 0; i < blocks_.size(); ++i) mark_block(i);
}

void SolidMesh::mark_block(std::size_t block) {
  waiting_ += blocks_[block].stale ? 0 : 1;
  blocks_[block].stale = true;
}

void SolidMesh::make(const Run& run, const Point& eye, const Deadline& deadline) {
  if (waiting_ == 0) return;
  std::vector<std::pair<double, std::size_t>> stale;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (!blocks_[i].stale) continue;
    const CellBox box = cells(i);
    const Point middle{(box.low.x + box.high.x + 1) / 2.0, (box.low.y + box.high.y + 1) / 2.0,
                       (box.low.z + box.high.z + 1) / 2.0};
    stale.emplace_back(distance(middle, eye), i);
  }
  std::sort(stale.begin(), stale.end());
  Reader reader(run, colours_, surprising_);
  for (const auto& [away, block] : stale) {
    make_block(reader, block);
    if (deadline.passed()) return;
  }
}

void SolidMesh::make_block(Reader& reader, std::size_t index) {
  Block& block = blocks_[index];
  block.stale = false;
  --waiting_;
  const CellBox box = cells(index);
  PaddedBlock cells{coordinates(box.low), coordinates(box.high), {}};
  for (int& end : cells.high) ++end;
  std::vector<SolidFace> faces;
  if (cells.fill(world_, reader)) {
    const std::array<int, 3> size = world_.sides<3>();
    std::vector<Colour> layer;
    for (std::size_t side = 0; side < 6; ++side) {
      const std::size_t axis = side / 2;
      const int step = side % 2 == 0 ? -1 : 1;
      for (int k = cells.low[axis]; k < cells.high[axis]; ++k)
        if (k + step >= 0 && k + step < size[axis]) add_layer(cells, side, k, layer, faces);
    }
  }
  if (faces == block.faces) return;
  block.faces = std::move(faces);
  block.signs = signs_of(block.faces);
  block.revision = ++revision_;
}

SignSet SolidMesh::signs_of(std::span<const SolidFace> faces) const {
  SignSet signs;
  const auto show = [&](Sign sign) { signs.set(static_cast<std::size_t>(sign)); };
  for (const SolidFace& face : faces) {
    if (face.colour == colours_.obstacle) show(Sign::obstacle);
    if (face.colour == colours_.mover) show(Sign::mover);
    if (face.colour == colours_.surprise) show(Sign::surprise);
    if (face.colour == colours_.unknown) show(Sign::unknown);
    if (face.colour == colours_.gone && face.colour != colours_.obstacle) show(Sign::gone);
  }
  return signs;
}

SignSet SolidMesh::signs() const {
  SignSet all;
  for (const Block& block : blocks_) all |= block.signs;
  return all;
}

std::vector<SolidFace> cut_faces(const Run& run, Axis across, int layer, bool towards_higher,
                                 const Palette& palette, bool shows_unknown) {
  const Box& world = run.lattice();
  const auto axis = static_cast<std::size_t>(across);
  const std::size_t a = kBeside[axis][0], b = kBeside[axis][1];
  const std::array<int, 3> size = coordinates({world.width(), world.height(), world.depth()});
  if (*std::max_element(size.begin(), size.end()) > kLongestSide) return {};
  const SolidMesh::Colours colours(palette, shows_unknown);
  const std::vector<NodeId> surprising = surprising_cells(run);
  SolidMesh::Reader reader(run, colours, surprising);
  std::vector<Colour> cells(static_cast<std::size_t>(size[a]) * static_cast<std::size_t>(size[b]));
  std::array<int, 3> at{};
  at[axis] = layer;
  std::size_t next = 0;
  for (at[b] = 0; at[b] < size[b]; ++at[b])
    for (at[a] = 0; at[a] < size[a]; ++at[a], ++next)
      if (reader.row(world.node({at[0], at[1], at[2]}), 1, &cells[next]) && cells[next] != 0)
        cells[next] = mix(cells[next], palette.text, 0.22f);
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

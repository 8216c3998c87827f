#include "core/scene/coverage.hpp"

#include <algorithm>
#include <span>

namespace replan {

namespace {

/// A number for each column. Wider than the bytes it is added up from, which the compiler then knows lie elsewhere: these
/// loops over whole worlds are worth being made for many cells at a time.
using Sums = std::vector<std::uint16_t>;

/// The share of a cell that is obstacle.
constexpr int kWhole = 255;

/// The share of a block, by the sum of those of its four parts.
std::uint8_t share_of(int sum) {
  return static_cast<std::uint8_t>((sum + 3) / 4);
}

/// Adds what a row of cells whose nodes follow each other has of obstacles to each column.
void add_cells(const SearchState& state, EventKind map, NodeId first, std::span<std::uint16_t> sums) {
  for (std::size_t x = 0; x < sums.size();) {
    const NodeId node = first + static_cast<NodeId>(x);
    const std::size_t at = node % SearchState::kPage;
    const std::size_t count = std::min(sums.size() - x, SearchState::kPage - at);
    if (const std::uint8_t* page = state.map_page(map, node); page != nullptr)
      for (std::size_t i = 0; i < count; ++i)
        sums[x + i] = static_cast<std::uint16_t>(sums[x + i] + (page[at + i] != 0 ? kWhole : 0));
    x += count;
  }
}

/// As above where they lie `step` apart: a world of several layers that is not seen along z.
void add_cells_apart(const SearchState& state, EventKind map, NodeId first, NodeId step,
                     std::span<std::uint16_t> sums) {
  for (std::size_t x = 0; x < sums.size(); ++x) {
    const NodeId node = first + static_cast<NodeId>(x) * step;
    const std::uint8_t* page = state.map_page(map, node);
    if (page != nullptr && page[node % SearchState::kPage] != 0)
      sums[x] = static_cast<std::uint16_t>(sums[x] + kWhole);
  }
}

}  // namespace

Coverage::Coverage(const SeenBox& world, int layer, const SearchState& state, EventKind map) {
  allocate(world.width(), world.height());
  if (levels_.empty()) return;
  const auto width = static_cast<std::size_t>(world.width());
  fill(levels_.front(), world.height(), [&](int row, std::span<std::uint16_t> sums) {
    const NodeId first = world.node({0, row, layer}), step = world.column_step();
    if (step == 1)
      add_cells(state, map, first, sums.first(width));
    else
      add_cells_apart(state, map, first, step, sums.first(width));
  });
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const Level& below = levels_[level - 1];
    fill(levels_[level], below.rows, [&](int row, std::span<std::uint16_t> sums) {
      const std::uint8_t* shares = below.row(row);
      for (std::size_t x = 0; x < static_cast<std::size_t>(below.columns); ++x)
        sums[x] = static_cast<std::uint16_t>(sums[x] + shares[x]);
    });
  }
}

/// All shares of a level, from two rows below at a time; `add` adds one of those to the sums of its columns.
template <class AddRow>
void Coverage::fill(Level& level, int rows_below, const AddRow& add) {
  // One column more where those below are odd, so that the last block has two of them too.
  Sums sums(static_cast<std::size_t>(level.columns) * 2);
  for (int y = 0; y < level.rows; ++y) {
    std::fill(sums.begin(), sums.end(), std::uint16_t{0});
    for (int row = 2 * y; row < std::min(2 * y + 2, rows_below); ++row) add(row, sums);
    std::uint8_t* shares = &level.at(0, y);
    for (std::size_t x = 0; x < static_cast<std::size_t>(level.columns); ++x)
      shares[x] = share_of(sums[2 * x] + sums[2 * x + 1]);
  }
}

void Coverage::allocate(int columns, int rows) {
  levels_.clear();
  while (columns > 1 || rows > 1) {
    columns = (columns + 1) / 2;
    rows = (rows + 1) / 2;
    Level level{columns, rows, {}};
    level.shares.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    levels_.push_back(std::move(level));
  }
}

void Coverage::gather(std::size_t level, int x, int y) {
  Level& below = levels_[level - 1];
  int sum = 0;
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx)
      if (2 * x + dx < below.columns && 2 * y + dy < below.rows) sum += below.at(2 * x + dx, 2 * y + dy);
  levels_[level].at(x, y) = share_of(sum);
}

void Coverage::change(Cell cell, int blocked) {
  if (levels_.empty()) return;
  int x = cell.x / 2, y = cell.y / 2;
  levels_[0].at(x, y) = share_of(blocked * kWhole);
  for (std::size_t level = 1; level < levels_.size(); ++level) gather(level, x /= 2, y /= 2);
}

namespace {

/// Whether the robot's map is the true one, as far as a look at the pages that they share can tell.
bool shares_all(const Box& world, const SearchState& state) {
  for (NodeId node = 0; node < world.node_count(); node += static_cast<NodeId>(SearchState::kPage))
    if (state.map_page(EventKind::known, node) != state.map_page(EventKind::truth, node)) return false;
  return true;
}

/// Obstacles among the 2 x 2 cells of the block around a cell.
int count_block(const Run& run, const SeenBox& lattice, EventKind kind, Cell cell) {
  const SearchState& state = run.timeline().state();
  int count = 0;
  for (int y = cell.y & ~1; y <= std::min(cell.y | 1, lattice.height() - 1); ++y)
    for (int x = cell.x & ~1; x <= std::min(cell.x | 1, lattice.width() - 1); ++x) {
      const NodeId node = lattice.node({x, y, cell.z});
      count += (kind == EventKind::known ? state.known_blocked(node) : state.truly_blocked(node)) ? 1 : 0;
    }
  return count;
}

}  // namespace

void MapCoverage::recount(const Run& run, const MapEvent& event) {
  const Cell cell = world_.position(event.node);
  if (cell.z != layer_) return;
  ++revision_;
  (event.kind == EventKind::known ? known_ : truth_).change(cell, count_block(run, world_, event.kind, cell));
}

void MapCoverage::follow(const Run& run, const RunDigest& digest, const SeenBox& world, int layer) {
  const bool other_layer = world != world_ || layer != layer_;
  if (follower_.follow(run, digest, other_layer, [&](const MapEvent& event) { recount(run, event); })) return;
  const SearchState& state = run.timeline().state();
  truth_ = Coverage(world, layer, state, EventKind::truth);
  known_ = shares_all(run.lattice(), state) ? truth_ : Coverage(world, layer, state, EventKind::known);
  world_ = world;
  layer_ = layer;
  ++revision_;
}

}  // namespace replan

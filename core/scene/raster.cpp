// The lowest layer: a colour per cell, or per pixel where cells are smaller than pixels.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/scene/cell_colours.hpp"
#include "core/scene/overlay.hpp"

namespace replan {
namespace {

/// a at share = 0, b at 256; opaque. mix() for millions of texels.
Colour blend(Colour a, Colour b, unsigned share) {
  const Colour even = ((a & 0xFF00FFu) * (256 - share) + (b & 0xFF00FFu) * share) >> 8 & 0xFF00FFu;
  const Colour odd = ((a >> 8 & 0xFFu) * (256 - share) + (b >> 8 & 0xFFu) * share) & 0xFF00u;
  return even | odd | 0xFF000000u;
}

void paint_cells(SceneContext& context, CellColours& colours) {
  Raster& raster = context.scene.raster;
  raster.columns = context.right - context.left;
  raster.rows = context.bottom - context.top;
  raster.x = context.left;
  raster.y = context.top;
  raster.width = raster.columns;
  raster.height = raster.rows;
  raster.texels.resize(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  std::size_t texel = 0;
  for (int y = context.top; y < context.bottom; ++y) {
    NodeId node = context.node(context.left, y);
    for (int x = context.left; x < context.right; ++x, node += context.lattice.column_step())
      raster.texels[texel++] = colours.cell(node);
  }
}

/// Which cells, or blocks of them, the pixels along one axis cover.
struct PixelAxis {
  std::vector<int> first, last;  ///< blocks, the last included
  std::vector<int> middle;       ///< cell in the middle

  PixelAxis(double origin, double per_pixel, int pixels, int cells, int level) {
    for (int p = 0; p < pixels; ++p) {
      const auto cell = [&](double at) {
        return std::clamp(static_cast<int>(std::floor(origin + at * per_pixel)), 0, cells - 1);
      };
      first.push_back(cell(p) >> level);
      last.push_back(std::max(cell(p), cell(p + 1.0 - 1e-9)) >> level);
      middle.push_back(cell(p + 0.5));
    }
  }
};

/// The shares of obstacles in the rows of blocks first..last added up, block by block.
void gather_rows(const Coverage& coverage, int level, int first, int last,
                 std::vector<std::uint32_t>& shares) {
  const Coverage::Level& blocks = coverage.level(level);
  shares.assign(blocks.row(first), blocks.row(first) + blocks.columns);
  for (int y = first + 1; y <= last; ++y) {
    const std::uint8_t* row = blocks.row(y);
    for (std::size_t x = 0; x < shares.size(); ++x) shares[x] += row[x];
  }
}

/// As above from the cells themselves; only those in sight are filled in.
void gather_cells(const SceneContext& context, EventKind kind, int first, int last,
                  std::vector<std::uint32_t>& shares) {
  shares.assign(static_cast<std::size_t>(context.lattice.width()), 0);
  for (int y = first; y <= last; ++y) {
    for (int x = context.left; x < context.right;) {
      const NodeId node = context.node(x, y);
      const int count =
          std::min(context.right - x, context.lattice.columns_on_page(node, SearchState::kPage));
      if (const std::uint8_t* page = context.state.map_page(kind, node); page != nullptr) {
        std::size_t at = node % SearchState::kPage;
        for (int i = 0; i < count; ++i, at += context.lattice.column_step())
          if (page[at] != 0) shares[static_cast<std::size_t>(x + i)] += 255;
      }
      x += count;
    }
  }
}

/// The mean of the shares of a row of pixels' blocks; never 0 where one is not.
struct MeanShare {
  std::uint32_t sum = 0, count = 0;
  [[nodiscard]] unsigned of_255() const { return (sum + count - 1) / count; }
};

MeanShare mean_share(const std::vector<std::uint32_t>& shares, const PixelAxis& across, std::size_t pixel,
                     int rows) {
  const auto first = static_cast<std::size_t>(across.first[pixel]),
             last = static_cast<std::size_t>(across.last[pixel]);
  MeanShare mean{0, static_cast<std::uint32_t>(last - first + 1) * static_cast<std::uint32_t>(rows)};
  for (std::size_t block = first; block <= last; ++block) mean.sum += shares[block];
  return mean;
}

/// Out of 256: the mean colour of what a pixel covers, but a thin wall must still be seen.
unsigned obstacle_opacity(unsigned share) {
  constexpr unsigned kLeast = 50;
  return share == 0 ? 0 : std::max(kLeast, share * 256 / 255);
}

/// What the pixels of a row cover: the shares of obstacles in its blocks, added up over so many rows of them.
struct PixelRow {
  int cells = 0;  ///< the row of cells in the middle
  int rows = 0;
  std::vector<std::uint32_t> truth, known;
};

void paint_pixel_row(SceneContext& context, CellColours& colours, const PixelAxis& across,
                     const PixelRow& row, Colour* texels) {
  for (std::size_t p = 0; p < across.first.size(); ++p) {
    const unsigned t = mean_share(row.truth, across, p, row.rows).of_255(),
                   k = mean_share(row.known, across, p, row.rows).of_255();
    const NodeId middle = context.node(across.middle[p], row.cells);
    Colour colour = k < 255 ? colours.free(middle) : 0;
    if (t > k && colours.shows_unknown()) {
      colour = blend(colour, colours.unknown(), obstacle_opacity(t));
      context.scene.show(Sign::unknown);
    }
    if (k > 0) colour = blend(colour, colours.obstacle(middle), obstacle_opacity(k));
    texels[p] = colour;
  }
}

/// Cells that are not as they were at first stand out from their block.
void paint_changed_cells(SceneContext& context, CellColours& colours) {
  Raster& raster = context.scene.raster;
  for (const MapEvent& event : context.memory.digest.map_events()) {
    if (event.event >= context.cursor) break;
    const Cell cell = context.lattice.position(event.node);
    if (!context.in_sight(cell)) continue;
    const bool truth = context.state.truly_blocked(event.node);
    if (truth == (context.run.scenario().map.blocked[event.node] != 0)) continue;
    const auto place = [](double at, int count) {
      return std::clamp(static_cast<int>(std::floor(at)), 0, count - 1);
    };
    const int column = place((cell.x + 0.5 - raster.x) * context.zoom, raster.columns);
    const int row = place((cell.y + 0.5 - raster.y) * context.zoom, raster.rows);
    raster.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
                  static_cast<std::size_t>(column)] = colours.cell(event.node);
  }
}

void paint_pixels(SceneContext& context, CellColours& colours) {
  Raster& raster = context.scene.raster;
  const double per_pixel = 1 / context.zoom;
  // On the view's own pixels, so that each texel is drawn as one.
  const auto span = [&](double middle, int pixels, int from, int to, double& origin, int& count) {
    const double begin = middle - pixels / 2.0 * per_pixel;
    const double first = std::max(0.0, std::floor((from - begin) / per_pixel));
    const double last = std::min(static_cast<double>(pixels), std::ceil((to - begin) / per_pixel));
    origin = begin + first * per_pixel;
    count = std::max(0, static_cast<int>(last - first));
  };
  span(context.scene.camera.x, context.scene.width, context.left, context.right, raster.x, raster.columns);
  span(context.scene.camera.y, context.scene.height, context.top, context.bottom, raster.y, raster.rows);
  raster.width = raster.columns * per_pixel;
  raster.height = raster.rows * per_pixel;
  raster.texels.resize(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  const MapCoverage& coverage = context.memory.coverage;
  const int level = std::min(static_cast<int>(std::floor(std::log2(per_pixel))), coverage.truth().levels());
  const PixelAxis across(raster.x, per_pixel, raster.columns, context.lattice.width(), level);
  const PixelAxis down(raster.y, per_pixel, raster.rows, context.lattice.height(), level);
  PixelRow row;
  for (std::size_t p = 0; p < down.first.size(); ++p) {
    row.cells = down.middle[p];
    row.rows = down.last[p] - down.first[p] + 1;
    if (level == 0) {
      gather_cells(context, EventKind::truth, down.first[p], down.last[p], row.truth);
      gather_cells(context, EventKind::known, down.first[p], down.last[p], row.known);
    } else {
      gather_rows(coverage.truth(), level, down.first[p], down.last[p], row.truth);
      gather_rows(coverage.known(), level, down.first[p], down.last[p], row.known);
    }
    paint_pixel_row(context, colours, across, row,
                    raster.texels.data() + p * static_cast<std::size_t>(raster.columns));
  }
  paint_changed_cells(context, colours);
}

/// The field's range, what it is called of this planner, and its value where the mouse is.
void describe_field(SceneContext& context) {
  Scene& scene = context.scene;
  scene.range =
      context.memory.ranges.at_cursor(context.run, *scene.field, context.view.range, context.deadline);
  const OverlayKind& kind = overlay_kind(*scene.field);
  scene.field_words = kind.words != nullptr ? kind.words(context.run.info()) : std::string(kind.info.label);
  if (context.view.hovered) scene.pointed = field_value(context.run, *scene.field, *context.view.hovered);
}

}  // namespace

void build_field_sheet(SceneContext& context) {
  Raster& raster = context.scene.raster;
  context.scene.field = context.view.overlays.field();
  if (!context.scene.field) return;
  describe_field(context);
  raster.columns = context.lattice.width();
  raster.rows = context.lattice.height();
  raster.width = raster.columns;
  raster.height = raster.rows;
  raster.texels.reserve(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  CellColours colours(context);
  for (int y = 0; y < raster.rows; ++y)
    for (int x = 0; x < raster.columns; ++x) {
      const NodeId node = context.node(x, y);
      const bool stands = context.state.truly_blocked(node) || context.state.known_blocked(node);
      raster.texels.push_back(stands ? 0 : colours.value(node).value_or(0));
    }
}

void build_raster(SceneContext& context) {
  Scene& scene = context.scene;
  scene.field = context.view.overlays.field();
  if (scene.field) describe_field(context);
  if (context.right <= context.left || context.bottom <= context.top) return;
  CellColours colours(context);
  if (context.zoom >= 1) {
    paint_cells(context, colours);
  } else {
    context.memory.coverage.follow(context.run, context.memory.digest, context.lattice, context.slice);
    paint_pixels(context, colours);
  }
}

}  // namespace replan

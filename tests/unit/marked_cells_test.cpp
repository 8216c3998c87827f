// Cells that a tab marks on the canvas: those of a rectangle in a plot, and a cell's family.
#include <algorithm>
#include <variant>

#include <gtest/gtest.h>

#include "core/debug/shown_family.hpp"
#include "core/scene/scene.hpp"
#include "core/session/run.hpp"

namespace replan::marked_cells_test {
namespace {

class MarkedCells : public testing::Test {
 protected:
  MarkedCells() {
    auto scenario = std::make_shared<Scenario>();
    scenario->map = GridMap(20, 10);
    scenario->start = {2, 5};
    scenario->goal = {17, 5};
    scenario->planners = {{"dstar-lite", {}}};
    run_ = std::make_unique<replan::Run>(scenario, 0);
    run_->finish(Target::plan());
    view_.overlays = {};
    show_brushed(view_.overlays);
    show_family(view_.overlays);
  }
  [[nodiscard]] CellSet three(std::uint64_t log_id) const {
    CellSet cells(run_->lattice().node_count(), log_id);
    for (const int x : {3, 4, 9}) cells.add(run_->lattice().node({x, 7}));
    return cells;
  }
  [[nodiscard]] Scene scene(Viewport viewport = {800, 600}) const {
    static const Palette palette;
    return build_scene(*run_, view_, viewport, palette);
  }
  /// Filled cells of the row of those three.
  static std::ptrdiff_t filled(const Scene& scene) {
    return std::count_if(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) {
      const auto* outline = std::get_if<Outline>(&shape);
      return outline != nullptr && outline->shape == OutlineShape::filled && outline->y > 6.5 &&
             outline->y < 7.5;
    });
  }

  std::unique_ptr<replan::Run> run_;
  View view_;
};

TEST_F(MarkedCells, OfARectangleAreFilledInTheirRunAlone) {
  EXPECT_FALSE(scene().shows(Sign::brushed));
  view_.brushed = std::make_shared<const CellSet>(three(run_->log_id()));
  EXPECT_TRUE(scene().shows(Sign::brushed));
  EXPECT_EQ(filled(scene()), 3);
  view_.brushed = std::make_shared<const CellSet>(three(run_->log_id() + 1));
  EXPECT_FALSE(scene().shows(Sign::brushed));
}

/// In a picture in which a pixel has several cells, few of them are still there.
TEST_F(MarkedCells, OfARectangleAreMetBySmallPicturesToo) {
  view_.brushed = std::make_shared<const CellSet>(three(run_->log_id()));
  const Scene small = scene({12, 8});
  EXPECT_LT(small.camera.zoom, 1);
  EXPECT_TRUE(small.shows(Sign::brushed));
}

TEST_F(MarkedCells, OfAFamilyAreFilledUnderTheLineOfItsWay) {
  ShownFamily family{run_->log_id(), {{3.5, 7.5}, {4.5, 7.5}, {9.5, 7.5}}, nullptr};
  view_.family = std::make_shared<const ShownFamily>(family);
  EXPECT_TRUE(scene().shows(Sign::ancestors));
  EXPECT_FALSE(scene().shows(Sign::below)) << "it is not known yet";
  family.below = std::make_shared<const CellSet>(three(run_->log_id()));
  view_.family = std::make_shared<const ShownFamily>(family);
  EXPECT_TRUE(scene().shows(Sign::below));
  EXPECT_EQ(filled(scene()), 3);
}

}  // namespace
}  // namespace replan::marked_cells_test

// A link to a moment in the window: copied, everything changed, and opened again.

#include <gtest/gtest.h>

#include "core/link/link.hpp"
#include "core/trace/log_hash.hpp"
#include "tests/ui/gap_fixture.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui::links_test {
namespace {

constexpr const char* kSolid = R"({"replan": 1, "name": "Decks",
  "map": {"layers": [["....", "....", "...."], ["....", ".@@.", "...."], ["....", "....", "...."]]},
  "start": [0, 0, 0], "goal": [3, 2, 2], "planners": [{"id": "dstar-lite"}]})";

class LinksTest : public GapTest {
 protected:
  [[nodiscard]] const Timeline& log() const { return session_->run().timeline(); }
  [[nodiscard]] std::uint64_t hash_here() const {
    LogHash hash(log().cursor());
    hash.advance(log(), Deadline::never());
    return hash.value();
  }
  /// By the keys, with the address that stands in the dialog.
  std::string copied() {
    press('L', true, true);
    press(key::kEnter);
    return ImGui::GetClipboardText();
  }
  void open_another_world() {
    Scenario other;
    other.map = GridMap(5, 5);
    other.goal = {4, 4};
    other.planners = {{"astar", {}, {}}};
    ASSERT_TRUE(session_->apply(ReplaceScenario{other, ""}).ok());
    session_->settle();
    shell_->show(session_->scenario());
    ViewState& view = shell_->view();
    view.tab = "log";
    view.view.overlays = default_overlays();
    view.view.camera = {1, 1, 10};
    view.slices.set_all({Axis::z, 0});
    view.orbit = {};
    for (std::size_t pane = 0; pane < 4; ++pane) view.slices.set_orbits(pane, false);
    frames(2);
  }
};

TEST_F(LinksTest, EverythingComesBack) {
  begin(kGapWorld);
  ASSERT_TRUE(session_->apply(Lead{1}).ok());
  ASSERT_TRUE(session_->apply(RunToEnd{}).ok());
  session_->settle();
  ASSERT_TRUE(session_->apply(Seek{log().size() * 2 / 3}).ok());
  ASSERT_TRUE(session_->apply(PaintCells{{{{5, 1}, true}}}).ok());  // by hand, on the way
  ASSERT_TRUE(session_->apply(SetLockstep{Lockstep::race}).ok());
  ASSERT_TRUE(session_->apply(AddBreakpoint{"km > 1000"}).ok());
  ASSERT_TRUE(session_->apply(RunToEnd{}).ok());
  session_->settle();
  ASSERT_TRUE(session_->apply(Seek{log().size() - 5}).ok());
  ViewState& view = shell_->view();
  view.tab = "cell";
  view.view.pinned = Cell{6, 1};
  view.view.overlays = {};
  view.view.overlays.set(overlays()[2].overlay, true);
  view.view.camera = {3, 2, 40};
  frames(2);
  const std::uint64_t hash = hash_here();
  const std::size_t cursor = log().cursor();
  const Scenario world = session_->scenario();
  const OverlaySet shown = view.view.overlays;
  const std::string link = copied();
  ASSERT_TRUE(link.starts_with("replan.html#v=1&at=" + std::to_string(cursor) + "&")) << link;
  EXPECT_EQ(shell_->link(*session_).value(), link) << "what a page takes is what the dialog shows";
  open_another_world();
  press('V', true);
  rest();
  EXPECT_EQ(log().cursor(), cursor);
  EXPECT_EQ(hash_here(), hash);
  EXPECT_EQ(session_->scenario().surprises, world.surprises);
  EXPECT_EQ(session_->lead(), 1u);
  EXPECT_EQ(session_->lockstep(), Lockstep::race);
  EXPECT_EQ(session_->runs().size(), 2u);
  EXPECT_EQ(session_->debug().breakpoints.size(), 1u);
  EXPECT_EQ(view.tab, "cell");
  EXPECT_EQ(view.view.pinned, (Cell{6, 1}));
  EXPECT_EQ(view.view.overlays, shown);
  EXPECT_EQ(view.view.camera, (Camera{3, 2, 40}));
  EXPECT_FALSE(session_->modified());
  EXPECT_EQ(session_->file(), "");
  EXPECT_EQ(shell_->told(), "At event " + std::to_string(cursor) + ", as in the link");
}

TEST_F(LinksTest, AWorldInSpaceIsSeenAsItWas) {
  begin(kSolid);
  ViewState& view = shell_->view();
  view.slices.set_all({Axis::y, 1});
  view.slices.set_orbits(0, true);
  view.orbit = {0.5, 0.25, 9, {1, 2, 1}};
  view.solid.cut = true;
  frames(2);
  const std::string link = copied();
  open_another_world();
  view.solid.cut = false;
  shell_->open_link(*session_, link);
  rest();
  EXPECT_EQ(view.slices.of(0), (Slice{Axis::y, 1}));
  EXPECT_TRUE(view.slices.orbits(0));
  EXPECT_NEAR(view.orbit.yaw, 0.5, 1e-4);
  EXPECT_NEAR(view.orbit.distance, 9, 1e-3);
  EXPECT_TRUE(view.solid.cut);
}

TEST_F(LinksTest, UnsavedEditsAreAskedAboutFirst) {
  begin(kGapWorld);
  const std::string link = shell_->link(*session_).value();
  ASSERT_TRUE(session_->apply(PaintCells{{{{5, 0}, true}}}).ok());
  session_->settle();
  shell_->open_link(*session_, link);
  frames(4);
  EXPECT_TRUE(session_->modified()) << "the question comes first";
  EXPECT_EQ(session_->file(), path_);
  press(key::kEscape);
  EXPECT_TRUE(session_->modified());
}

TEST_F(LinksTest, AnotherPlanIsSaid) {
  begin(kGapWorld);
  ASSERT_TRUE(session_->apply(Seek{20}).ok());
  std::string link = shell_->link(*session_).value();
  const std::size_t at = link.find("&log=") + 5;
  link[at] = link[at] == '0' ? '1' : '0';
  shell_->open_link(*session_, link);
  rest();
  EXPECT_EQ(log().cursor(), 20u);
  EXPECT_NE(shell_->told().find("plans this world otherwise"), std::string::npos) << shell_->told();
  link.replace(link.find("at=20"), 5, "at=999999");
  shell_->open_link(*session_, link);
  rest();
  EXPECT_NE(shell_->told().find("before event " + grouped(std::size_t{999999}) + " of the link"),
            std::string::npos)
      << shell_->told();
}

TEST_F(LinksTest, TheWayThereCanBeStopped) {
  begin(kGapWorld);
  std::string link = shell_->link(*session_).value();
  link.replace(link.find("&at="), link.find("&log=") - link.find("&at="), "&at=999999");
  shell_->open_link(*session_, link);
  frames(1);
  ASSERT_TRUE(session_->apply(Cancel{}).ok());
  rest();
  EXPECT_FALSE(shell_->panels().going.has_value());
}

TEST_F(LinksTest, ADamagedOneIsRefusedAndNothingIsLost) {
  begin(kGapWorld);
  std::string link = shell_->link(*session_).value();
  link.resize(link.size() - 7);
  shell_->open_link(*session_, link);
  rest();
  EXPECT_NE(shell_->told().find("cut off"), std::string::npos) << shell_->told();
  EXPECT_EQ(session_->file(), path_);
}

TEST_F(LinksTest, TheOpenDialogTakesOne) {
  begin(kGapWorld);
  ASSERT_TRUE(session_->apply(Seek{9}).ok());
  ImGui::SetClipboardText(shell_->link(*session_).value().c_str());
  open_another_world();
  press('O', true);
  press('V', true);
  press(key::kEnter);
  rest();
  EXPECT_EQ(session_->scenario().name, "Gap");
  EXPECT_EQ(log().cursor(), 9u);
}

TEST_F(LinksTest, TheAddressIsKept) {
  begin(kGapWorld);
  shell_->panels().link_address = "https://example.org/lab/";
  EXPECT_TRUE(copied().starts_with("https://example.org/lab/#v=1&"));
  EXPECT_NE(shell_->told().find("Copied the link: "), std::string::npos);
  press('L', true, true);
  press(key::kEscape);
  EXPECT_EQ(shell_->panels().link_address, "https://example.org/lab/");
}

}  // namespace
}  // namespace replan::ui::links_test

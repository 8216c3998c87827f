// The dialogs about documents, by keyboard, on frames without a display: what the user does and what comes of
// it.
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/base/file.hpp"
#include "core/world/map_file.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/documents/files.hpp"

namespace replan::ui::dialogs_test {
namespace {

constexpr const char* kMap = "type octile\nheight 3\nwidth 4\nmap\n.@..\n....\n..@.\n";

std::string world(const std::string& name) {
  return R"({"replan": 1, "name": ")" + name +
         R"(", "caption": "About it.", "map": {"rows": ["..........", ".........."]},
        "start": [0, 0], "goal": [9, 1], "planners": [{"id": "dstar-lite"}]})";
}

class DialogsTest : public ShellTest {
 protected:
  void SetUp() override { open("first.json", world("First")); }

  void settle_in() {
    shell_->documents().settle_in(*session_, {folder_.file("state"), folder_.file("library"), {}});
  }
  void edit() { edit_cell({5, 0}); }
  void edit_cell(Cell cell) {
    session_->settle();
    ASSERT_TRUE(session_->apply(PaintCells{{{cell, true}}}).ok());
    frames(2);
  }
};

TEST_F(DialogsTest, OpenFiltersByWhatIsTypedAndTakesEnter) {
  const std::string other = folder_.with("second maze.map", kMap);
  press('O', true);
  type("maze");
  press(key::kEnter);
  EXPECT_EQ(session_->file(), other);
  EXPECT_EQ(session_->scenario().map.width, 4);
}

TEST_F(DialogsTest, ThePaletteFindsEveryWorldOfTheLibrary) {
  std::filesystem::create_directory(folder_.file("library"));
  folder_.with("library/hidden valley.map", kMap);
  settle_in();
  press('P', true);
  type("valley");
  for (int i = 0; i < 200 && shell_->documents().library()->worlds().empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    frames(1);
  }
  frames(2);
  press(key::kEnter);
  frames(4);
  EXPECT_EQ(session_->scenario().map.width, 4);
}

TEST_F(DialogsTest, AWorldOpensWithItsCamera) {
  const std::string close =
      R"({"replan": 1, "map": {"rows": ["....................", "...................."]},
    "start": [0, 0], "goal": [19, 1], "planners": [{"id": "astar"}], "view": {"camera": {"x": 3, "y": 1, "zoom": 40}}})";
  for (const char* name : {"of another size.json", "of that size.json"}) {
    folder_.with(name, close);
    press('O', true);
    type(name);
    press(key::kEnter);
    frames(3);
    ASSERT_EQ(session_->scenario().map.width, 20) << name;
    const Camera camera = shell_->view().camera(Axis::z);
    EXPECT_DOUBLE_EQ(camera.x, 3) << name;
    EXPECT_DOUBLE_EQ(camera.y, 1) << name;
    EXPECT_DOUBLE_EQ(camera.zoom, 40) << name;
    shell_->view().fit_cameras();
  }
}

/// How high the open dialog is.
float height_of_popup() {
  const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
  return popups.empty() || popups.back().Window == nullptr ? 0 : popups.back().Window->Size.y;
}

TEST_F(DialogsTest, WaitingForALargeFileTakesNoMoreRoomThanItsWords) {
  float waiting = 0, after_list = 0;
  const auto wait = [this](Dialogs& dialogs) {
    for (int i = 0; i < 12; ++i)
      offscreen_->frame([&] { static_cast<void>(dialogs.draw(offscreen_->stage().look())); });
    float height = 0;
    offscreen_->frame([&] {
      static_cast<void>(dialogs.draw(offscreen_->stage().look()));
      height = height_of_popup();
    });
    return height;
  };
  Dialogs dialogs(offscreen_->stage().renderer());
  dialogs.wait_for("large.map");
  waiting = wait(dialogs);
  dialogs.close();
  dialogs.show(DialogKind::keys);
  EXPECT_GT(wait(dialogs), waiting * 2);
  dialogs.wait_for("large.map");
  after_list = wait(dialogs);
  EXPECT_GT(waiting, 0);
  EXPECT_EQ(after_list, waiting);
}

TEST_F(DialogsTest, OpenWalksThroughFolders) {
  std::filesystem::create_directory(folder_.file("sub"));
  const std::string inside = folder_.with("sub/inside.json", world("Inside"));
  press('O', true);
  press(key::kDown);
  press(key::kEnter);  // into sub
  press(key::kDown);
  press(key::kEnter);
  EXPECT_EQ(session_->file(), inside);
  press('O', true);
  press(key::kBackspace);  // up again; sub is chosen
  press(key::kDown);
  press(key::kEnter);
  EXPECT_EQ(session_->file(), path_);
}

TEST_F(DialogsTest, OpenStaysWithAFileThatCannotBeRead) {
  folder_.with("broken.json", "no JSON");
  press('O', true);
  type("broken");
  press(key::kEnter);
  EXPECT_EQ(session_->file(), path_);
  press(key::kEscape);  // takes the filter back
  type("first");
  press(key::kEnter);
  EXPECT_EQ(session_->scenario().name, "First");
  press(key::kEscape);
  press('V');  // keys are the window's again
  EXPECT_EQ(shell_->view().tools.chosen_id(), "select");
}

TEST_F(DialogsTest, SaveAsAsksBeforeItReplaces) {
  edit();
  const std::string before = *read_file(path_);
  press('S', true, true);
  press(key::kEnter);
  EXPECT_EQ(*read_file(path_), before) << "a file was replaced without a question";
  press(key::kEscape);
  press(key::kEnter);
  press(key::kEnter);
  EXPECT_NE(*read_file(path_), before);
  EXPECT_FALSE(session_->modified());
}

TEST_F(DialogsTest, SaveAsGivesANameItsExtension) {
  press('S', true, true);
  press('A', true);
  type("copy");
  press(key::kEnter);
  EXPECT_EQ(session_->file(), folder_.file("copy.json"));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("copy.json")));
  press('S', true, true);
  press('A', true);
  type("cells.map");
  press(key::kEnter);
  EXPECT_TRUE(read_map(folder_.file("cells.map")).ok());
}

TEST_F(DialogsTest, AMapFileIsWrittenInPlaceAsLongAsItCanHoldTheEdits) {
  const std::string map = folder_.with("cells.map", kMap);
  session_ = std::make_unique<Session>(*open_document(map, session_->scenario()), map);
  edit_cell({0, 2});
  press('S', true);
  EXPECT_FALSE(session_->modified());
  EXPECT_TRUE(read_map(map)->at({0, 2}));

  edit_cell({1, 2});
  press('S', true);
  EXPECT_FALSE(session_->modified()) << "it is written in place once more";
  EXPECT_TRUE(read_map(map)->at({1, 2}));

  const std::string written = *read_file(map);
  ASSERT_TRUE(session_->apply(SetGoal{{3, 1}}).ok());
  press('S', true);
  EXPECT_TRUE(session_->modified()) << "the goal is said to be saved";
  press(key::kEnter);  // the name that is proposed
  EXPECT_EQ(session_->file(), folder_.file("cells.json"));
  EXPECT_EQ(*read_file(map), written);
  EXPECT_EQ(read_scenario(folder_.file("cells.json"))->goal, (Cell{3, 1}));
}

TEST_F(DialogsTest, DroppedFilesAreOpenedAfterUnsavedEditsAreDealtWith) {
  const std::string other = folder_.with("other.map", kMap);
  shell_->documents().drop(*session_, {other});
  EXPECT_EQ(session_->file(), other);
  shell_->documents().drop(*session_, {folder_.with("film.mp4", "")});
  EXPECT_EQ(session_->file(), other);
  shell_->documents().drop(*session_, {path_});
  edit();
  shell_->documents().drop(*session_, {other});
  frames(4);
  EXPECT_EQ(session_->file(), path_);
  press(key::kEscape);
  EXPECT_TRUE(session_->modified());
  shell_->documents().drop(*session_, {other});
  frames(4);
  press(key::kEnter);  // save, then open
  EXPECT_EQ(session_->file(), other);
  EXPECT_TRUE(read_scenario(path_)->map.at({5, 0}));
}

TEST_F(DialogsTest, ADroppedFolderIsLookedInto) {
  std::filesystem::create_directory(folder_.file("sub"));
  const std::string inside = folder_.with("sub/only.map", kMap);
  shell_->documents().drop(*session_, {folder_.file("sub")});
  frames(4);
  press(key::kDown);
  press(key::kEnter);
  EXPECT_EQ(session_->file(), inside);
}

TEST_F(DialogsTest, APickedWorldIsNobodysFile) {
  std::filesystem::create_directory(folder_.file("library"));
  folder_.with("library/a.json", world("Hall"));
  folder_.with("library/b.json", world("Garden"));
  settle_in();
  press('O', true, true);
  type("gard");
  press(key::kEnter);
  EXPECT_EQ(session_->scenario().name, "Garden");
  EXPECT_EQ(session_->file(), "");
  press('O', true, true);
  press(key::kRight);
  press(key::kLeft);
  press(key::kEnter);
  EXPECT_EQ(session_->scenario().name, "Hall");
}

TEST_F(DialogsTest, UnsavedEditsAreAskedAboutOnceAnotherWorldIsChosen) {
  std::filesystem::create_directory(folder_.file("library"));
  folder_.with("library/a.json", world("Hall"));
  folder_.with("second.json", world("Second"));
  settle_in();
  edit();
  const std::string before = *read_file(path_);
  press('O', true, true);
  press(key::kEscape);  // only looked
  press('O', true);
  press(key::kEscape);
  press('N', true);
  press(key::kEscape);
  EXPECT_TRUE(session_->modified());
  EXPECT_EQ(session_->scenario().name, "First");
  press('O', true, true);
  press(key::kEnter);  // the world is chosen
  EXPECT_EQ(session_->scenario().name, "First") << "not asked";
  press(key::kEscape);  // stays
  EXPECT_TRUE(session_->modified());
  EXPECT_EQ(*read_file(path_), before);
  press('O', true);
  type("second");
  press(key::kEnter);
  press(key::kEnter);  // save, and go on
  EXPECT_EQ(session_->scenario().name, "Second");
  EXPECT_NE(*read_file(path_), before);
}

TEST_F(DialogsTest, AChoiceInTheFileDialogOpensByAClickAndEscapeClosesItAlone) {
  press('S', true, true);
  const auto lists = [this] {
    int open = 0;
    offscreen_->frame([&] {
      shell_->draw(offscreen_->stage().look(), *session_, 0);
      open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    });
    return open;
  };
  ASSERT_EQ(lists(), 1) << "the dialog itself";
  ImVec2 at;
  offscreen_->frame([&] {
    shell_->draw(offscreen_->stage().look(), *session_, 0);
    const ImGuiWindow& dialog = *ImGui::GetCurrentContext()->OpenPopupStack[0].Window;
    at = {dialog.Pos.x + 60, dialog.Pos.y + dialog.Size.y - 34};
  });
  click(at);
  frames(4);
  EXPECT_EQ(lists(), 2);
  press(key::kEscape);
  EXPECT_EQ(lists(), 1) << "the dialog stays";
}

TEST_F(DialogsTest, AFileThatChangedOnDiskIsReadAgainOrNotWrittenOverUnasked) {
  settle_in();
  frames(2);
  const auto wait_and_look = [this] {
    std::this_thread::sleep_for(std::chrono::milliseconds(2100));
    frames(4);
  };
  folder_.with("first.json", world("Changed"));
  wait_and_look();
  press(key::kEnter);  // reload
  EXPECT_EQ(session_->scenario().name, "Changed");
  edit();
  folder_.with("first.json", world("Changed again"));
  wait_and_look();
  press(key::kEscape);  // keep mine
  EXPECT_EQ(session_->scenario().name, "Changed");
  press('S', true);
  EXPECT_EQ(read_scenario(path_)->name, "Changed again") << "written over unasked";
  press(key::kEscape);
  EXPECT_TRUE(session_->modified());
}

TEST_F(DialogsTest, WorkFromBeforeACrashIsTakenUp) {
  Scenario lost = session_->scenario();
  lost.name = "Lost and found";
  std::filesystem::create_directories(folder_.file("state/autosave"));
  const AutosaveNote note{
      .file = path_, .name = lost.name, .edits = 7, .edited_at = 1, .scripted = 0, .map_file = ""};
  folder_.with("state/autosave/x.json", autosave_text(note, lost));
  settle_in();
  frames(4);
  press(key::kEnter);
  EXPECT_EQ(session_->scenario().name, "Lost and found");
  EXPECT_EQ(session_->file(), path_);
  EXPECT_EQ(session_->unsaved_edits(), 7u);
  EXPECT_TRUE(std::filesystem::exists(folder_.file("state/autosave/x.json")));
  shell_->documents().leave();
  EXPECT_FALSE(std::filesystem::exists(folder_.file("state/autosave/x.json")));
}

TEST_F(DialogsTest, RecentFilesAreKeptAndMissingOnesDropped) {
  settle_in();
  const std::string other = folder_.with("other.map", kMap);
  shell_->documents().drop(*session_, {other});
  EXPECT_EQ(shell_->panels().recent, (std::vector<std::string>{other, path_}));
  std::filesystem::remove(path_);
  shell_->documents().open(*session_, path_);
  EXPECT_EQ(session_->file(), other);
  EXPECT_EQ(shell_->panels().recent, (std::vector<std::string>{other}));
  EXPECT_EQ(shell_->panels().notices.size(), 1u) << "nothing was said";
}

}  // namespace
}  // namespace replan::ui::dialogs_test

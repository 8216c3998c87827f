// Documents without their dialogs: folders, previews, recent files, watched files, and what is dropped.
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/file.hpp"
#include "core/world/map_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/documents/file_list.hpp"
#include "ui/documents/file_watch.hpp"
#include "ui/documents/files.hpp"
#include "ui/documents/preview.hpp"
#include "ui/documents/recent_files.hpp"
#include "ui/documents/world_library.hpp"

namespace replan::ui::documents_test {
namespace {

constexpr const char* kMap = "type octile\nheight 2\nwidth 4\nmap\n.@..\n....\n";
constexpr const char* kWorld =
    R"({"replan": 1, "name": "A door", "caption": "It shuts.", "map": {"rows": ["..@", "..."]},
        "start": [0, 0], "goal": [2, 1], "planners": [{"id": "astar"}]})";

std::vector<std::string> names(const FileList& list) {
  std::vector<std::string> names;
  for (const FileEntry& entry : list.entries()) names.push_back(entry.name);
  return names;
}

FileList list_of(std::vector<FileEntry> entries) {
  FileList list;
  list.take(std::move(entries));
  return list;
}

using Names = std::vector<std::string>;

TEST(NaturalOrder, CountsNumbersAndPassesOverCase) {
  EXPECT_TRUE(natural_less("map 2.map", "map 10.map"));
  EXPECT_FALSE(natural_less("map 10.map", "map 2.map"));
  EXPECT_TRUE(natural_less("Alpha", "beta"));
  EXPECT_TRUE(natural_less("a", "ab"));
  EXPECT_TRUE(natural_less("x07", "x8"));
  EXPECT_TRUE(natural_less("a", "é"));
  EXPECT_FALSE(natural_less("same", "same"));
  // What differs in nothing but case and zeros has an order all the same.
  EXPECT_NE(natural_less("x01", "x1"), natural_less("x1", "x01"));
}

TEST(FileList, PutsFoldersFirstWhateverTheOrder) {
  FileList list = list_of({{"b.map", FileKind::map, 10, 5},
                           {"a.map", FileKind::map, 30, 1},
                           {"zoo", FileKind::folder, 0, 9},
                           {"c10.map", FileKind::map, 20, 3},
                           {"c9.map", FileKind::map, 20, 2}});
  EXPECT_EQ(names(list), (Names{"zoo", "a.map", "b.map", "c9.map", "c10.map"}));
  list.sort_by(FileOrder::size);
  EXPECT_EQ(names(list), (Names{"zoo", "a.map", "c10.map", "c9.map", "b.map"}));
  list.sort_by(FileOrder::date);
  EXPECT_EQ(names(list), (Names{"zoo", "b.map", "c10.map", "c9.map", "a.map"}));
  list.sort_by(FileOrder::date);
  EXPECT_EQ(names(list), (Names{"zoo", "a.map", "c9.map", "c10.map", "b.map"}));
}

TEST(FileList, FiltersByKindSearchAndDots) {
  FileList list = list_of({{"plan.json", FileKind::scenario, 1, 1},
                           {"floor.PNG", FileKind::picture, 1, 1},
                           {".hidden.json", FileKind::scenario, 1, 1},
                           {"notes.md", FileKind::other, 1, 1},
                           {"Plans", FileKind::folder, 0, 1}});
  list.set_filter({"worlds", {".json", ".png"}});
  EXPECT_EQ(names(list), (Names{"Plans", "floor.PNG", "plan.json"}));
  EXPECT_EQ(list.left_out(), 2u);
  list.set_hidden(true);
  EXPECT_EQ(names(list), (Names{"Plans", ".hidden.json", "floor.PNG", "plan.json"}));
  list.set_search("PLAN");
  EXPECT_EQ(names(list), (Names{"Plans", "plan.json"}));
  list.set_search("");
  list.set_filter({"all", {}});
  EXPECT_EQ(names(list).size(), 5u);
}

TEST(FileList, KeepsTheChosenEntryThroughOrdersAndFilters) {
  FileList list =
      list_of({{"a", FileKind::other, 3, 1}, {"b", FileKind::other, 2, 1}, {"c", FileKind::other, 1, 1}});
  EXPECT_EQ(list.selected(), nullptr);
  list.move(1);
  EXPECT_EQ(list.selected()->name, "a");
  list.move(10);
  EXPECT_EQ(list.selected()->name, "c");
  list.sort_by(FileOrder::size);
  list.sort_by(FileOrder::size);
  EXPECT_EQ(list.selected()->name, "c");
  EXPECT_EQ(list.selected_index(), 0u);
  list.set_search("b");
  EXPECT_EQ(list.selected()->name, "b");
  list.jump_to("none");
  EXPECT_EQ(list.selected(), nullptr);
  list.move(-1);
  EXPECT_EQ(list.selected()->name, "b");
}

TEST(FileList, ReadsAFolderAndSaysWhyNot) {
  const test::TemporaryFolder folder;
  folder.with("a.map", kMap);
  std::filesystem::create_directory(folder.file("sub"));
  std::filesystem::create_symlink(folder.file("gone"), folder.file("dangling"));
  const auto entries = read_folder(folder.path());
  ASSERT_TRUE(entries.ok()) << entries.error();
  const FileList list = list_of(*entries);
  ASSERT_EQ(names(list), (Names{"sub", "a.map", "dangling"}));
  EXPECT_EQ(list.entries()[1].size, std::string_view(kMap).size());
  EXPECT_EQ(list.entries()[1].kind, FileKind::map);
  EXPECT_GT(list.entries()[1].modified, 0);
  folder.with("presets.json", R"({"version": 3})");
  folder.with("world.json", R"({"name": "A", "replan": 1})");
  folder.with("ci.yaml", "on: push\n");
  folder.with("sweep.json", R"({"format": "replan experiment", "version": 1})");
  folder.with("batch.json", R"({"format": "replan batch", "experiment": {"format": "replan experiment"}})");
  folder.with("office.yaml", "image: office.png\nresolution: 0.05\n");
  const auto looked_into = read_folder(folder.path());
  ASSERT_TRUE(looked_into.ok());
  for (const FileEntry& entry : *looked_into) {
    if (entry.name == "presets.json" || entry.name == "ci.yaml") {
      EXPECT_EQ(entry.kind, FileKind::other) << entry.name;
    }
    if (entry.name == "world.json") {
      EXPECT_EQ(entry.kind, FileKind::scenario);
    }
    if (entry.name == "sweep.json") {
      EXPECT_EQ(entry.kind, FileKind::experiment);
    }
    if (entry.name == "batch.json") {
      EXPECT_EQ(entry.kind, FileKind::results);
    }
    if (entry.name == "office.yaml") {
      EXPECT_EQ(entry.kind, FileKind::map);
    }
  }
  EXPECT_NE(read_folder(folder.file("gone")).error().find("is not there any more"), std::string::npos);
  EXPECT_NE(read_folder(folder.file("a.map")).error().find("is not a folder"), std::string::npos);
  ::chmod(folder.file("sub").c_str(), 0);
  if (::geteuid() != 0) {
    EXPECT_NE(read_folder(folder.file("sub")).error().find("ermission denied"), std::string::npos);
  }
  ::chmod(folder.file("sub").c_str(), 0700);
}

TEST(TypedPaths, AreCompletedAsFarAsTheyAreClear) {
  const test::TemporaryFolder folder;
  folder.with("maze-1.map", kMap);
  folder.with("maze-2.map", kMap);
  folder.with(".secret", "");
  std::filesystem::create_directory(folder.file("Sub"));
  folder.with("Sub/only.json", kWorld);
  EXPECT_EQ(completed(folder.path(), "ma"), "maze-");
  EXPECT_EQ(completed(folder.path(), "maze-1"), "maze-1.map");
  EXPECT_EQ(completed(folder.path(), "sub"), "Sub/");
  EXPECT_EQ(completed(folder.path(), "Sub/"), "Sub/only.json");
  EXPECT_EQ(completed("/", folder.path() + "/Su"), folder.path() + "/Sub/");
  EXPECT_EQ(completed(folder.path(), "nothing"), "nothing");
  EXPECT_EQ(completed(folder.path(), "no/such/folder"), "no/such/folder");
  EXPECT_EQ(completed(folder.path(), ".se"), ".secret");
}

TEST(TypedPaths, AreSeenFromTheFolder) {
  EXPECT_EQ(typed_from("/a/b", "c.map"), "/a/b/c.map");
  EXPECT_EQ(typed_from("/a/b", " ../x/ "), "/a/x");
  EXPECT_EQ(typed_from("/a/b", "/etc"), "/etc");
  EXPECT_EQ(typed_from("/a/b", ""), "/a/b");
  const std::vector<Crumb> parts = crumbs("/home/ann");
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].path, "/");
  EXPECT_EQ(parts[2].name, "ann");
  EXPECT_EQ(parts[2].path, "/home/ann");
}

TEST(Thumbnails, TellOfEveryCell) {
  GridMap map(1000, 500);
  map.set({0, 0}, true);
  map.set({999, 499}, true);
  const Thumbnail picture = thumbnail_of(map, Cell{500, 250}, std::nullopt, 100);
  EXPECT_EQ(picture.width, 100);
  EXPECT_EQ(picture.height, 50);
  EXPECT_EQ(picture.walls.front(), 255 / 100);  // one cell of the hundred of its pixel
  EXPECT_EQ(picture.walls.back(), 255 / 100);
  EXPECT_EQ(picture.walls[1], 0);
  EXPECT_EQ(picture.start, (Cell{50, 25}));
  EXPECT_FALSE(picture.goal);
  const Thumbnail line = thumbnail_of(GridMap(5000, 1), std::nullopt, std::nullopt, 100);
  EXPECT_EQ(line.width, 100);
  EXPECT_EQ(line.height, 1);
  GridMap small(3, 2);
  small.set({2, 1}, true);
  const Thumbnail same = thumbnail_of(small, std::nullopt, std::nullopt, 100);
  EXPECT_EQ(same.width, 3);
  EXPECT_EQ(same.walls, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 255}));
  EXPECT_EQ(coloured(same, dark()).back(), dark().obstacle);
  EXPECT_EQ(coloured(same, light()).front(), light().free);
}

TEST(Previews, ShowWhatIsInAFileOrWhyNot) {
  const test::TemporaryFolder folder;
  const Preview world = make_preview(folder.with("w.json", kWorld), {}, {});
  EXPECT_EQ(world.error, "");
  EXPECT_EQ(world.name, "A door");
  EXPECT_EQ(world.caption, "It shuts.");
  EXPECT_EQ(world.width, 3);
  EXPECT_EQ(world.obstacles, 1u);
  EXPECT_EQ(world.planners, (Names{"A*"}));
  EXPECT_EQ(world.thumbnail.goal, (Cell{2, 1}));
  EXPECT_EQ(make_preview(folder.with("m.map", kMap), {}, {}).obstacles, 1u);
  const std::string numbers = folder.with("n.txt", "0 1 2\n2 1 0\n");
  const Preview asked = make_preview(numbers, {}, {});
  EXPECT_NE(asked.error.find("which one is the obstacle"), std::string::npos) << asked.error;
  EXPECT_EQ(asked.numbers, (std::vector<double>{0, 1, 2})) << "there to be chosen from";
  const Preview told = make_preview(numbers, {.image = {}, .unknown = {}, .occupied = 2}, {});
  EXPECT_EQ(told.obstacles, 2u) << told.error;
  EXPECT_EQ(told.notes.size(), 1u);
  EXPECT_NE(make_preview(folder.with("broken.json", "{"), {}, {}).error, "");
  EXPECT_NE(make_preview(folder.file("gone.map"), {}, {}).error, "");
  EXPECT_NE(make_preview(folder.with("p.scen", ""), {}, {}).error, "");
  std::filesystem::resize_file(folder.with("huge.map", kMap), kMostPreviewBytes + 1);
  EXPECT_NE(make_preview(folder.file("huge.map"), {}, {}).error.find("Too large"), std::string::npos);
}

TEST(Previews, OfHeightsAreOfTheirLayers) {
  const test::TemporaryFolder folder;
  const std::string sea = folder.with("sea.asc", "ncols 2\nnrows 1\n-40 -20\n"),
                    grey = folder.with("grey.pgm", std::string("P5\n2 1\n255\n\x00\xFF", 13));
  const Preview deep = make_preview(sea, {}, {});
  EXPECT_EQ(deep.error, "");
  EXPECT_EQ(deep.depth, 64);
  ASSERT_TRUE(deep.heights.has_value());
  EXPECT_EQ(deep.heights->low, -40);
  EXPECT_EQ(deep.heights->high, -20);
  EXPECT_EQ(deep.thumbnail.walls[1], 127) << "half of its layers";
  EXPECT_EQ(make_preview(grey, {}, {}).depth, 1);
  EXPECT_EQ(make_preview(grey, {.image = {}, .heights = HeightReading{.layers = 8}}, {}).depth, 8);
  const Preview none = make_preview(sea, {.image = {}, .heights = HeightReading{.low = 5}}, {});
  EXPECT_NE(none.error.find("no layers fit"), std::string::npos) << none.error;
  Scenario current;
  current.planners = {{"jps", {}, {}}, {"astar", {}, {}}};
  const auto opened = open_document(grey, current, {.image = {}, .heights = HeightReading{.layers = 8}});
  ASSERT_TRUE(opened.ok()) << opened.error();
  EXPECT_EQ(opened->map.box(), Box(2, 1, 8));
  EXPECT_EQ(opened->planners.at(0).id, "astar");
  EXPECT_FALSE(opened->map.at(opened->start) || opened->map.at(opened->goal));
}

TEST(NewWorld, HasTheLayersThatAreAskedFor) {
  Scenario current;
  current.planners = {{"jps", {}, {}}, {"astar", {}, {}}};
  EXPECT_EQ(empty_world({16, 9}, current).planners.size(), 2u);
  const Scenario world = empty_world({16, 9, 5}, current);
  EXPECT_EQ(world.map.box(), Box(16, 9, 5));
  EXPECT_EQ(world.planners.size(), 1u) << "the one that plans in space";
  EXPECT_EQ(world.start, (Cell{2, 4, 2}));
  EXPECT_EQ(world.goal, (Cell{13, 4, 2}));
}

std::string repeated(const std::string& row, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += row;
  return text;
}

TEST(OpenDocument, UnknownCellsOfARosMapStayUnknownUntilSomebodyPaintsThem) {
  const test::TemporaryFolder folder;
  folder.with("u.pgm", std::string("P5\n4 2\n255\n\xFE\xCD\xCD\xFE\xFE\xFE\xFE\xFE", 19));
  const std::string yaml = folder.with("u.yaml",
                                       "image: u.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                                       "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  Scenario current;
  current.planners = {{"astar", {}}};
  Result<Scenario> opened = open_document(yaml, current);
  ASSERT_TRUE(opened.ok()) << opened.error();
  EXPECT_EQ(lost_in(".png", *opened).front(),
            ".png cannot hold that 2 cells are unknown on the map: there they are obstacles");
  Session session(*std::move(opened));
  const auto saved = [&] {
    const Result<void> done = save_document(session, {}, folder.file("o.yaml"));
    EXPECT_TRUE(done.ok()) << done.error();
    return read_file(folder.file("o.pgm"))->substr(11);
  };
  EXPECT_EQ(saved(), "\xFE\xCD\xCD\xFE\xFE\xFE\xFE\xFE");
  ASSERT_TRUE(session.apply(PaintCells{{{{1, 0}, false}}, 0}).ok());
  EXPECT_EQ(saved(), "\xFE\xFE\xCD\xFE\xFE\xFE\xFE\xFE");
  ASSERT_TRUE(session.apply(TurnWorld{Turn::top_bottom}).ok());
  EXPECT_EQ(saved(), "\xFE\xFE\xFE\xFE\xFE\xFE\xCD\xFE");
  ASSERT_TRUE(session.apply(ResizeWorld{{.width = 4, .height = 1, .down = Side::high}}).ok());
  EXPECT_EQ(saved(), "\xFE\xFE\xCD\xFE");
}

TEST(OpenDocument, PutsTheEndsFarApartInTheLargestRegion) {
  const test::TemporaryFolder folder;
  Scenario current;
  current.planners = {{"astar", {}}};
  // Two regions; the right one is the larger.
  const std::string path =
      folder.with("two.map", "type octile\nheight 4\nwidth 6\nmap\n.@....\n.@..@.\n.@....\n.@...@\n");
  const Result<Scenario> opened = open_document(path, current);
  ASSERT_TRUE(opened.ok()) << opened.error();
  EXPECT_EQ(opened->start, (Cell{2, 0}));
  EXPECT_EQ(opened->goal, (Cell{4, 3}));
  EXPECT_EQ(opened->planners, current.planners);
  // Where there is room they keep off the rim.
  const Result<Scenario> hall = open_document(
      folder.with("hall.map", "type octile\nheight 9\nwidth 12\nmap\n" + repeated("............\n", 9)),
      current);
  ASSERT_TRUE(hall.ok()) << hall.error();
  EXPECT_EQ(hall->start, (Cell{3, 3}));
  EXPECT_EQ(hall->goal, (Cell{8, 5}));
  // A format that knows its ends keeps them.
  const Result<void> written = write_map_file({opened->map, Cell{3, 3}, Cell{0, 0}}, folder.file("ends.txt"));
  ASSERT_TRUE(written.ok()) << written.error();
  const Result<Scenario> again = open_document(folder.file("ends.txt"), current);
  ASSERT_TRUE(again.ok()) << again.error();
  EXPECT_EQ(again->start, (Cell{3, 3}));
  EXPECT_EQ(again->goal, (Cell{0, 0}));
  // Nothing is free: it opens all the same.
  EXPECT_TRUE(
      open_document(folder.with("full.map", "type octile\nheight 1\nwidth 2\nmap\n@@\n"), current).ok());
  EXPECT_FALSE(open_document(folder.with("p.scen", "version 1\n"), current).ok());
  EXPECT_FALSE(open_document(folder.file("gone.map"), current).ok());
}

TEST(RecentFiles, AreTheLatestTenAcrossPrograms) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("state/recent.json");
  RecentFiles recent(file);
  for (int i = 0; i < 12; ++i) ASSERT_TRUE(recent.add("/maps/" + std::to_string(i) + ".map").ok());
  ASSERT_TRUE(recent.add("/maps/5.map").ok());
  ASSERT_EQ(recent.paths().size(), RecentFiles::kMost);
  EXPECT_EQ(recent.paths()[0], "/maps/5.map");
  EXPECT_EQ(recent.paths()[1], "/maps/11.map");
  RecentFiles other(file);
  EXPECT_TRUE(std::equal(other.paths().begin(), other.paths().end(), recent.paths().begin()));
  ASSERT_TRUE(other.add("/elsewhere/x.json").ok());
  ASSERT_TRUE(recent.add("/maps/0.map").ok());
  EXPECT_EQ(recent.paths()[1], "/elsewhere/x.json");
  EXPECT_EQ(recent.folders(), (Names{"/maps", "/elsewhere"}));
  ASSERT_TRUE(recent.drop("/maps/0.map").ok());
  EXPECT_EQ(RecentFiles(file).paths()[0], "/elsewhere/x.json");
  ASSERT_TRUE(recent.clear().ok());
  EXPECT_TRUE(RecentFiles(file).paths().empty());
}

TEST(RecentFiles, TakeADamagedListForNone) {
  const test::TemporaryFolder folder;
  for (const char* text : {"", "[", "[]", R"({"files": 3})", R"({"files": [1, "/a"]})"}) {
    const RecentFiles recent(folder.with("recent.json", text));
    EXPECT_LE(recent.paths().size(), 1u) << text;
  }
}

TEST(FileWatch, SeesWhatOthersWrite) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("w.json", kWorld), map = folder.with("m.map", kMap);
  FileWatch watch;
  watch.watch({stamped(path), stamped(map), stamped("")});
  EXPECT_FALSE(watch.changed());
  ASSERT_TRUE(write_file_atomically(map, "something else").ok());
  EXPECT_EQ(watch.changed(), map);
  watch.accept();
  EXPECT_FALSE(watch.changed());
  std::filesystem::remove(path);
  EXPECT_FALSE(watch.changed());  // there is nothing to be read
  folder.with("w.json", kWorld);
  EXPECT_EQ(watch.changed(), path);
}

TEST(Dropped, TakesTheBestOfWhatCame) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(sort_out({}).path, "");
  EXPECT_EQ(sort_out({"/x/floor.pgm", "/x/floor.yaml"}).path, "/x/floor.yaml");
  const Dropped several = sort_out({"/x/a.map", "/x/b.json", "/x/c.md"});
  EXPECT_EQ(several.path, "/x/b.json");
  EXPECT_NE(several.sentence.find("of 3 dropped files 'b.json' was taken"), std::string::npos);
  const Dropped unknown = sort_out({"/x/film.mp4"});
  EXPECT_EQ(unknown.path, "");
  EXPECT_NE(unknown.sentence.find("'film.mp4' is no world"), std::string::npos);
  const Dropped inside = sort_out({folder.path()});
  EXPECT_TRUE(inside.folder);
  EXPECT_EQ(inside.sentence, "");
}

TEST(Documents, OpensWorldsOfSeveralLayers) {
  const test::TemporaryFolder folder;
  const std::string decks = REPLAN_SOURCE_DIR "/maps/decks.json",
                    box = folder.with("box.3dmap", "voxel 4 3 2\n1 0 0\n");
  const auto scenario = open_document(decks, {});
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->map.box(), Box(26, 16, 5));
  Scenario planar;
  planar.planners = {{"jps", {}, {}}, {"astar", {}, {}}};
  planar.robot.kind = "dwa";
  const auto map = open_document(box, planar);
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->map.box(), Box(4, 3, 2));
  ASSERT_EQ(map->planners.size(), 1u) << "those that plan in space are kept";
  EXPECT_EQ(map->planners[0].id, "astar");
  EXPECT_EQ(map->robot.kind, RobotSetup{}.kind);
  planar.planners = {{"jps", {}, {}}};
  EXPECT_EQ(open_document(box, planar)->planners.at(0).id, "dstar-lite");
  const Preview preview = make_preview(box, {}, {});
  EXPECT_EQ(preview.error, "");
  EXPECT_EQ(preview.depth, 2);
  EXPECT_EQ(preview.thumbnail.walls[1], 127) << "one of its two layers";
  EXPECT_EQ(preview.thumbnail.walls[0], 0);
  EXPECT_TRUE(saves_in_place(box));
  WorldLibrary library(REPLAN_SOURCE_DIR "/maps");
  library.refresh();
  library.update();
  EXPECT_FALSE(library.found("two decks").empty());
}

TEST(Documents, AGeneratedWorldIsNotSavedIntoTheFileOfTheOneBefore) {
  const test::TemporaryFolder folder;
  const std::string path = folder.with("door.json", kWorld);
  Session session(*read_scenario(path), path);
  session.settle();
  EXPECT_TRUE(saves_in_place(session));
  EXPECT_EQ(document_name(session), "door.json");
  ASSERT_TRUE(session.apply(GenerateWorld{"maze", {}, 31, 21, 7}).ok());
  EXPECT_FALSE(saves_in_place(session));
  EXPECT_EQ(document_name(session), "Maze, 31 x 21");
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_TRUE(saves_in_place(session));
  EXPECT_EQ(document_name(session), "door.json");
  ASSERT_TRUE(session.apply(Redo{}).ok());
  session.saved(folder.file("maze.json"));
  EXPECT_TRUE(saves_in_place(session)) << "in the file that it was saved in";
  EXPECT_EQ(document_name(session), "maze.json");
}

TEST(WorldLibrary, FindsWorldsAndLooksAtEachOnce) {
  const test::TemporaryFolder folder;
  folder.with("b.json", kWorld);
  folder.with("a.map", kMap);
  folder.with("settings.json", "{}");
  folder.with("readme.md", "");
  WorldLibrary library(folder.path());
  library.refresh();
  EXPECT_TRUE(library.update());
  ASSERT_EQ(library.worlds().size(), 3u);
  EXPECT_EQ(library.found("").size(), 2u);  // settings.json is no world
  ASSERT_EQ(library.found("DOOR shuts").size(), 1u);
  EXPECT_EQ(library.worlds()[library.found("door")[0]].title(), "A door");
  EXPECT_EQ(library.worlds()[0].title(), "a");
  EXPECT_TRUE(library.found("window").empty());
  EXPECT_FALSE(library.update());
  std::filesystem::remove(folder.file("b.json"));
  library.refresh();
  library.update();
  EXPECT_EQ(library.worlds().size(), 2u);
}

}  // namespace
}  // namespace replan::ui::documents_test

// Small inputs from the field, each for what people's files are like: F1 to F13 of ../shared/field, which
// world_formats_test.cpp and others do not hold, and the files themselves.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/export/case_text.hpp"
#include "core/world/ends.hpp"
#include "core/world/formats/ascii_map.hpp"
#include "core/world/formats/image_map.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/ros_map.hpp"
#include "core/world/formats/sbpl_cfg.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_field_test {
namespace {

using Notes = std::vector<std::string>;

std::string error_of(const auto& result) {
  return result.ok() ? "" : result.error();
}

/// What a text map is read as, written back; or the error.
std::string read_as(const std::string& text, std::optional<double> occupied = {}) {
  const auto world = parse_ascii_map(text, "a.txt", occupied);
  return world ? ascii_text(*world) : world.error();
}
Notes notes_of(const std::string& text, std::optional<double> occupied = {}) {
  const auto world = parse_ascii_map(text, "a.txt", occupied);
  return world ? world->found.notes : Notes{world.error()};
}

const std::string kMark = "\xEF\xBB\xBF";

TEST(Field, F1BlanksPartCellsWhereEverySecondColumnIsBlank) {
  EXPECT_EQ(read_as("S 0 0\n1 1 1\nG 0 0\n"), "S..\n@@@\nG..\n");
  EXPECT_EQ(notes_of("S 0 0\n1 1 1\nG 0 0\n"),
            Notes{"a.txt: every second column is blank, so blanks part the cells: 3 x 3 of them"});
  EXPECT_EQ(read_as("\n# # #\r\n#   #\r\n# # #"), "@@@\n@.@\n@@@\n");
  EXPECT_EQ(read_as("S . . \n@ @ . \n. . G \n"), "S..\n@@.\n..G\n") << "as SBPL prints its grids";
  EXPECT_EQ(read_as("0 1 0 \n1 0 1\n"), ".@.\n@.@\n");
  EXPECT_EQ(read_as("     0     0     1\n     1     0     0\n"), "..@\n@..\n") << "as MATLAB prints";
  EXPECT_EQ(read_as("  0 255\n255   0\n"), ".@\n@.\n") << "as P2 prints";
}

TEST(Field, F1BlanksStayCellsElsewhere) {
  EXPECT_EQ(read_as("# # \n    \n"), "@.@.\n....\n") << "an even length";
  EXPECT_EQ(read_as("# # #\n#####\n"), "@.@.@\n@@@@@\n");
  EXPECT_EQ(read_as("     \n"), ".....\n") << "nothing to part";
  EXPECT_EQ(read_as("#\n \n#\n"), "@\n.\n@\n");
  EXPECT_EQ(read_as(".  .\n#  #\n"), "....\n@..@\n");
  EXPECT_TRUE(notes_of("# # \n    \n").empty());
}

TEST(Field, F1OtherSeparators) {
  EXPECT_EQ(read_as("0,0,1\n1,0,0\n"), "..@\n@..\n");
  EXPECT_EQ(read_as("0, 0, 1,\n1, 0, 0,\n"), "..@\n@..\n");
  EXPECT_EQ(read_as("S;0;1\n1;0;G\n"), "S.@\n@.G\n");
  EXPECT_EQ(read_as(".\t@\n.\t.\n"), ".@\n..\n");
  EXPECT_EQ(notes_of(".\t@\n.\t.\n"), Notes{"a.txt: tabs part the cells: 2 x 2 of them"});
  for (const char* text : {"[[0, 0, 1],\n [1, 0, 0]]\n", "[[0, 0, 1], [1, 0, 0]]", "[[0 0 1]\n [1 0 0]]\n",
                           "grid = np.array([[0, 0, 1],\n                 [1, 0, 0]], dtype=uint8)\n",
                           "[0 0 1; 1 0 0]", "A = [0, 0, 1\n     1, 0, 0];\n", "{{0, 0, 1},\n {1, 0, 0},}",
                           "[[False False  True]\n [ True False False]]",
                           "array([[0., 0., 1.],\n       [1., 0., 0.]])", "[[0, 0,\n  1], [1,\n 0, 0]]"})
    EXPECT_EQ(read_as(text), "..@\n@..\n") << text;
  EXPECT_EQ(read_as("0.000000000000000000e+00,1.000000000000000000e+00\n1.0,0\n"), ".@\n@.\n");
}

TEST(Field, F1MatricesThatCannotBeMeant) {
  EXPECT_EQ(read_as("0,,1\n"), "a.txt:1: column 3: an empty cell: write 0 for a free one");
  EXPECT_EQ(read_as("0,1 0,1\n"), "a.txt:1: column 5: two cells with nothing but blanks between them");
  EXPECT_EQ(read_as("0,1\n0\n"),
            "a.txt:2: the row has 1 cell, the rows before it have 2: make them equally long");
  EXPECT_EQ(read_as("[[0, 1], [1]]"),
            "a.txt:1: the row has 1 cell, the rows before it have 2: make them equally long");
  EXPECT_EQ(read_as("[[[0, 1]]]"),
            "a.txt:1: column 3: brackets three deep: a map has rows and columns alone");
  EXPECT_EQ(read_as("[[0, 1],\n [1, 0]"), "a.txt:2: column 8: the file ends before a bracket is closed");
  EXPECT_EQ(read_as("[[0, 1]]\n[[1, 0]]"), "a.txt:2: the text goes on after the matrix: '[[1, 0]]'");
  EXPECT_EQ(read_as("0 1\n[[0, 1]]"),
            "a.txt:1: '0 1' stands before the brackets: only a matrix, or a name and =, is read");
  EXPECT_NE(read_as("[[0 1 ... 0]]").find("numpy.set_printoptions"), std::string::npos);
  EXPECT_EQ(read_as("[[]]"), "a.txt: the rows have no cells in them");
  EXPECT_EQ(read_as("0,abc\n").rfind("a.txt:1: column 3: unknown cell 'abc'; known are ", 0), 0u);
  EXPECT_EQ(read_as("]").rfind("a.txt:", 0), 0u);
}

TEST(Field, NumbersSayWhichIsTheObstacle) {
  EXPECT_EQ(read_as("0110\n", 0), "@..@\n") << "one digit a cell";
  EXPECT_EQ(read_as("0 100\n100 0\n"), ".@\n@.\n");
  EXPECT_EQ(notes_of("0,100\n100,0\n").back(),
            "a.txt: 100 is taken for the obstacle and 0 for free; --occupied 0 is the other way round");
  EXPECT_EQ(read_as("0020\n0220\n"), "..@.\n.@@.\n");
  EXPECT_EQ(read_as("012\n"),
            "a.txt: there are the numbers 0, 1 and 2: say which one is the obstacle with --occupied VALUE, "
            "or in the Open dialog");
  EXPECT_EQ(read_as("012\n", 2), "..@\n");
  EXPECT_EQ(read_as("-1,0,100\n", 100), "..@\n");
  EXPECT_NE(read_as("5,5\n").find("all numbers are 5: say which"), std::string::npos);
  EXPECT_NE(read_as("1,2\n").find("the numbers 1 and 2: say which"), std::string::npos);
  EXPECT_NE(read_as("0,1,2,3,4,5,6,7,8,9\n").find("0, 1, 2, 3, 4, 5, 6 and 3 more"), std::string::npos);
  EXPECT_EQ(notes_of("01\n", 7),
            Notes{"a.txt: no cell is 7, which is to be the obstacle: no number makes an obstacle here"});
  EXPECT_EQ(read_as("S.G\n", 1),
            "a.txt: its letters say themselves what is an obstacle; --occupied is for numbers");
  EXPECT_EQ(read_as("..2\n").rfind("a.txt:1: column 3: unknown cell letter '2'", 0), 0u);
  EXPECT_EQ(read_as("2..\n").rfind("a.txt:1: column 1: unknown cell letter '2'", 0), 0u);
  EXPECT_EQ(parse_ascii_map("3 0 3\n", "a.txt")->found.numbers, (std::vector<double>{0, 3}));
}

/// A BMP of 24 bits, 5 x 3, its first row at the top: a height below 0.
std::string top_down_bmp() {
  std::string bytes("BM\x66\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x05\0\0\0\xFD\xFF\xFF\xFF\x01\0\x18\0", 30);
  bytes += std::string(4, '\0') + std::string("\x30\0\0\0", 4) + std::string(16, '\0');
  for (const char* row : {"@....", "..@..", "....@"}) {
    for (int x = 0; x < 5; ++x) bytes += std::string(3, row[x] == '@' ? '\0' : '\xFF');
    bytes += '\0';
  }
  return bytes;
}

TEST(Field, F2BmpsFromTheTop) {
  const auto map = decode_image_map(top_down_bmp(), "a.bmp");
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(ascii_text(MapFile{*map}), "@....\n..@..\n....@\n");
  const test::TemporaryFolder folder;
  folder.with("a.bmp", top_down_bmp());
  const auto ros = read_map(folder.with("a.yaml",
                                        "image: a.bmp\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                                        "occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  ASSERT_TRUE(ros.ok()) << ros.error();
  EXPECT_EQ(ros->blocked, map->blocked);
  const std::string cut = top_down_bmp().substr(0, 90);
  EXPECT_EQ(error_of(decode_image_map(cut, "a.bmp")), "a.bmp: the file ends before the picture does");
}

TEST(Field, F3AByteOrderMarkIsPassedOverInEveryText) {
  EXPECT_EQ(read_as(kMark + "S..\n.@.\n..G\n"), "S..\n.@.\n..G\n");
  EXPECT_EQ(read_as(kMark + "S 0 0\n1 1 1\nG 0 0\n"), "S..\n@@@\nG..\n");
  EXPECT_EQ(error_of(parse_movingai_map(kMark + "type octile\nheight 1\nwidth 1\nmap\n.\n", "a.map")), "");
  EXPECT_EQ(error_of(parse_scen(kMark + "version 1\n0\ta.map\t9\t9\t1\t1\t2\t1\t1\n", "a.scen")), "");
  EXPECT_EQ(error_of(parse_voxel_map(kMark + "voxel 1 1 1\n", "a.3dmap")), "");
  EXPECT_EQ(error_of(parse_voxel_scen(kMark + "version 1\na.3dmap\n", "a.3dscen")), "");
  EXPECT_EQ(error_of(parse_sbpl_cfg(kMark + "discretization(cells): 1 1\nobsthresh: 1\nstart(cells): 0 0\n"
                                            "end(cells): 0 0\nenvironment:\n0\n",
                                    "a.cfg")),
            "");
  EXPECT_EQ(error_of(parse_ros_yaml(kMark + "image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                                            "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
                                    "a.yaml")),
            "");
  EXPECT_EQ(error_of(decode_image_map(kMark + "P2\n1 1\n255\n0\n", "a.pgm")), "");
  EXPECT_EQ(
      error_of(parse_scenario(kMark + "{\"replan\": 1, \"map\": {\"rows\": [\"..\"]}, \"start\": [0, 0], "
                                      "\"goal\": [1, 0], \"planners\": [{\"id\": \"astar\"}]}",
                              "a.json", ".")),
      "");
  EXPECT_TRUE(is_case_text(kMark + std::string(kCaseTitle) + "\n"));
}

TEST(Field, F6ErrorsShowTheLetterOrItsCode) {
  EXPECT_EQ(shown_letter("x"), "'x'");
  EXPECT_EQ(shown_letter("\xC3\xA9t"), "'\xC3\xA9'");
  EXPECT_EQ(shown_letter("\t"), "0x09");
  EXPECT_EQ(shown_letter("\xC2\xA0"), "U+00A0");
  EXPECT_EQ(shown_letter("\xFF"), "0xFF");
  EXPECT_EQ(shown_letter("\xE2\x96"), "0xE2") << "a character cut off";
  EXPECT_EQ(shown("5\xC2\xA0"
                  "6\t\xE2\x96\x88"),
            "'5<U+00A0>6<0x09>\xE2\x96\x88'");
  EXPECT_EQ(shown(std::string(50, 'a')), "'" + std::string(40, 'a') + "...'");
  EXPECT_EQ(read_as("..\xE2\x96\x88\n").rfind("a.txt:1: column 3: unknown cell letter '\xE2\x96\x88'; ", 0),
            0u);
  EXPECT_EQ(read_as("..\x01\n").rfind("a.txt:1: column 3: unknown cell letter 0x01; ", 0), 0u);
  const auto map = [](const std::string& row) {
    return error_of(parse_movingai_map("type octile\nheight 1\nwidth 3\nmap\n" + row + "\n", "a.map"));
  };
  EXPECT_EQ(map(".\t.").rfind("a.map:5: column 2: unknown cell letter 0x09; ", 0), 0u);
  EXPECT_EQ(map(".\xC3\xA9").rfind("a.map:5: column 2: unknown cell letter '\xC3\xA9'; ", 0), 0u);
  const auto rows = [](const std::string& row) {
    return error_of(parse_scenario("{\"replan\": 1, \"map\": {\"rows\": [\"" + row + "\"]}}", "a.json", "."));
  };
  EXPECT_NE(rows(".\xC3\xA9").find("column 2: unknown cell letter '\xC3\xA9'; "), std::string::npos);
}

TEST(Field, F8TabsPartTheFieldsOfAProblem) {
  const auto scen = parse_scen("version 1\n0\ttwo words.map\t5\t3\t1\t0\t3\t2\t4.00000000\n", "a.scen");
  ASSERT_TRUE(scen.ok()) << scen.error();
  EXPECT_EQ(scen->map_name, "two words.map");
  EXPECT_EQ(scen->problems[0].goal, (Cell{3, 2}));
  EXPECT_EQ(scen_text(*scen), "version 1\n0\ttwo words.map\t5\t3\t1\t0\t3\t2\t4.00000000\n");
  EXPECT_EQ(error_of(parse_scen("version 1\n0\ta.map\t5\t\t1\t0\t3\t2\t4\n", "a.scen")),
            "a.scen:2: the map height must be a whole number from 0, not ''");
  EXPECT_EQ(error_of(parse_scen("version 1\n0\ta b.map\t5\t3\t1\t0\t3\t2\t4\tx y\n", "a.scen")),
            "a.scen:2: the line goes on after its 9 fields: 'x y'");
  const auto voxels = parse_voxel_scen("version 1\ntwo words.3dmap\n1\t2\t3\t4\t5\t6\t7.5\t1\n", "a.3dscen");
  ASSERT_TRUE(voxels.ok()) << voxels.error();
  EXPECT_EQ(voxels->map_name, "two words.3dmap");
  EXPECT_EQ(voxels->problems.size(), 1u);
}

/// A ROS map of one row: obstacle, two unknown cells, free.
std::string ros_map(const test::TemporaryFolder& folder) {
  folder.with("u.pgm", std::string("P5\n4 1\n255\n\x00\xCD\xCD\xFE", 15));
  return folder.with("u.yaml",
                     "image: u.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                     "free_thresh: 0.196\n");
}

TEST(Field, F5UnknownCellsAreKeptOrTold) {
  const test::TemporaryFolder folder;
  const std::string yaml = ros_map(folder), out = folder.file("o.yaml");
  const char* become[] = {"obstacles", "free cells", "unmapped obstacles"};
  for (const UnknownCells unknown : {UnknownCells::blocked, UnknownCells::free, UnknownCells::unmapped}) {
    const auto file = read_map_file(yaml, {.image = {}, .unknown = unknown});
    ASSERT_TRUE(file.ok()) << file.error();
    ASSERT_TRUE(write_map_file(*file, out).ok());
    EXPECT_EQ(read_file(folder.file("o.pgm"))->substr(11), std::string("\x00\xCD\xCD\xFE", 4));
    EXPECT_TRUE(lost_in(".yaml", *file).empty());
    for (const char* extension : {".txt", ".json"})
      EXPECT_EQ(
          lost_in(extension, *file),
          Notes{std::string(extension) + " cannot hold that 2 cells are unknown on the map: there they are " +
                become[static_cast<int>(unknown)]});
    EXPECT_EQ(lost_in(".png", *file),
              Notes{std::string(".png cannot hold that 2 cells are unknown on the map: there they are ") +
                    (unknown == UnknownCells::free ? "free cells" : "obstacles")});
  }
}

TEST(Field, F9AnUnknownStartIsCalledUnknown) {
  const test::TemporaryFolder folder;
  const auto file = read_map_file(ros_map(folder));
  Scenario scenario;
  scenario.map = file->map;
  scenario.map_found = file->found;
  scenario.start = {1, 0};
  scenario.goal = {3, 0};
  EXPECT_EQ(unknown_end_sentence(scenario, true),
            "The start is unknown on the map, and unknown cells are obstacles here: move it, or read them as "
            "free (--unknown free, or in the Open dialog).");
  EXPECT_EQ(unknown_end_sentence(scenario, false), "");
  EXPECT_EQ(file->found.notes_for_planning(), Notes{"2 unknown cells of the map count as blocked; --unknown "
                                                    "free or --unknown unmapped makes it otherwise, "
                                                    "as does the Open dialog"});
  EXPECT_TRUE(read_map_file(ros_map(folder), {.image = {}, .unknown = UnknownCells::free})
                  ->found.notes_for_planning()
                  .empty());
  scenario.map_file = "u.yaml";
  EXPECT_NE(unknown_end_sentence(scenario, true).find("\"unknown\": \"free\""), std::string::npos);
  scenario.start = {0, 0};
  EXPECT_EQ(unknown_end_sentence(scenario, true), "") << "an obstacle that is none of the unknown cells";
}

TEST(Field, F7AndF12RosYamlAsMapServerReadsIt) {
  const auto with = [](const std::string& line) {
    return parse_ros_yaml("image: a.pgm\nresolution: 1\norigin: [0, 0, 0]\n" + line +
                              "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
                          "a.yaml");
  };
  for (const char* word : {"1", "yes", "Yes", "TRUE", "on", "y"})
    EXPECT_TRUE(with("negate: " + std::string(word))->negate) << word;
  for (const char* word : {"0", "no", "No", "FALSE", "off", "n"})
    EXPECT_FALSE(with("negate: " + std::string(word))->negate) << word;
  EXPECT_EQ(with("negate: 0\nmode: SCALE")->mode, RosMapInfo::Mode::scale);
  EXPECT_EQ(with("negate: 0\nmode: Trinary")->mode, RosMapInfo::Mode::trinary);
  EXPECT_NE(error_of(with("negate: 0\nmode: Raw")).find("a.yaml:5: 'mode' is raw: "), std::string::npos);
  EXPECT_EQ(error_of(with("negate: 0\nmode: Trinari")),
            "a.yaml:5: 'mode' must be trinary or scale, not 'Trinari'");
  EXPECT_EQ(error_of(with("negate:")), "a.yaml:4: 'negate' must be 0 or 1, yes or no, not ''");
  EXPECT_EQ(
      error_of(parse_ros_yaml("image:\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 1\n"
                              "free_thresh: 0\n",
                              "a.yaml")),
      "a.yaml:1: 'image' must name a picture file");
  EXPECT_EQ(error_of(parse_sbpl_cfg("discretization(cells): 1 1\nobsthresh:\nstart(cells): 0 0\n", "a.cfg")),
            "a.cfg:2: a number of 'obsthresh:' must be whole, from 1 to 255, not 'start(cells):'");
}

TEST(FieldShared, ComesOutRightLineByLine) {
  REPLAN_NEED_SHARED_DATA();
  const auto folder = test::shared_data().parent_path() / "field";
  const auto text = [&](const char* name, const MapReading& reading = {}) {
    const auto world = read_map_file((folder / name).string(), reading);
    return world ? ascii_text(*world) : world.error();
  };
  EXPECT_EQ(text("spaced.txt"), "S..\n@@@\nG..\n");
  EXPECT_EQ(text("comma.txt"), "..@.\n..@.\n....\n");
  EXPECT_EQ(text("matrix.txt"), text("comma.txt"));
  EXPECT_EQ(text("topdown24.bmp"), "@....\n..@..\n....@\n");
  EXPECT_EQ(text("bom.map"), text("ok.map"));
  EXPECT_EQ(text("bom.txt"), "S..\n.@.\n..G\n");
  EXPECT_EQ(text("tab.txt"), ".@\n..\n");
  EXPECT_EQ(text("mode-case.yaml"), text("unknown.yaml"));
  EXPECT_EQ(text("negate-no.yaml"), text("unknown.yaml"));
  EXPECT_EQ(text("huge-header.png"), (folder / "huge-header.png").string() +
                                         ": the picture is too large: 60000 x 60000 pixels, at most 67108864 "
                                         "(8192 x 8192) are read");
  EXPECT_EQ(text("empty-value.yaml").rfind((folder / "empty-value.yaml").string() + ":4: ", 0), 0u);
  const auto six = read_map((folder / "exif6.jpg").string()), one = read_map((folder / "exif1.jpg").string());
  ASSERT_TRUE(six.ok() && one.ok());
  EXPECT_EQ(std::pair(six->width, six->height), std::pair(24, 40));
  EXPECT_EQ(std::pair(one->width, one->height), std::pair(40, 24));
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 24; ++x) EXPECT_EQ(six->at({x, y}), one->at({y, 23 - x}));
  EXPECT_EQ(read_picture((folder / "exif6.jpg").string(), Lying::as_stored)->width, 40);
  const auto scen = read_scen((folder / "two words.map.scen").string());
  ASSERT_TRUE(scen.ok()) << scen.error();
  EXPECT_EQ(map_beside(scen->path, scen->map_name).ok(), true);
}

}  // namespace
}  // namespace replan::world_field_test

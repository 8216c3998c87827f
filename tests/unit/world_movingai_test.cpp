#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/map_file.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_movingai_test {
namespace {

std::string error_of(const std::string& text) {
  const Result<GridMap> map = parse_movingai_map(text, "m.map");
  return map.ok() ? "" : map.error();
}
std::string scen_error_of(const std::string& text) {
  const Result<ScenFile> scen = parse_scen(text, "m.scen");
  return scen.ok() ? "" : scen.error();
}

const std::string kHeader = "type octile\nheight 2\nwidth 3\nmap\n";

TEST(MovingAiMap, ReadsEveryLetter) {
  const auto map = parse_movingai_map("type octile\nheight 1\nwidth 7\nmap\n.GS@OTW\n", "m.map");
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->blocked, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1, 1}));
}

TEST(MovingAiMap, TakesTextsAsTheyCome) {
  GridMap expected(3, 2);
  expected.set({1, 0}, true);
  expected.set({2, 1}, true);
  for (const std::string& text : {
           kHeader + ".@.\n..@\n",
           kHeader + ".@.\n..@",
           kHeader + ".@.  \n..@\t\n\n  \n\n",
           std::string("type octile\r\nheight 2\r\nwidth 3\r\nmap\r\n.@.\r\n..@\r\n"),
           std::string("type octile\r\nheight 2\r\nwidth 3\r\nmap\r\n.@.\r\n..@"),
           std::string("type octile \n\nwidth 3\nheight\t2 \nmap \n.@.\n..@\n"),
           std::string("type tile\nheight 2\nwidth 3\nmap\n.@.\n..@\n"),
       }) {
    const auto map = parse_movingai_map(text, "m.map");
    ASSERT_TRUE(map.ok()) << map.error() << "\n" << text;
    EXPECT_EQ(*map, expected) << text;
  }
}

TEST(MovingAiMap, NamesLineAndColumnOfAnUnknownLetter) {
  EXPECT_EQ(error_of(kHeader + "...\n.x.\n"),
            "m.map:6: column 2: unknown cell letter 'x'; known are . G S (free) and @ O T W (obstacle)");
  EXPECT_NE(error_of(kHeader + "...\n.\x01.\n").find("0x01"), std::string::npos);
  EXPECT_NE(error_of(kHeader + "...\n.\xC3\xA4\n").find("'\xC3\xA4'"), std::string::npos);
  EXPECT_NE(error_of(kHeader + "...\n. .\n").find("column 2: unknown cell letter 0x20"), std::string::npos);
}

TEST(MovingAiMap, RefusesTooFewAndTooManyRowsAndColumns) {
  EXPECT_EQ(error_of(kHeader + "...\n"), "m.map:5: the file ends after 1 of 2 rows");
  EXPECT_EQ(error_of(kHeader), "m.map:4: the file ends after 0 of 2 rows");
  EXPECT_EQ(error_of(kHeader + "...\n...\n...\n"), "m.map:7: more rows than the 2 that 'height' says");
  EXPECT_EQ(error_of(kHeader + "..\n...\n"), "m.map:5: the row has 2 columns, not the 3 that 'width' says");
  EXPECT_EQ(error_of(kHeader + "...\n....\n"), "m.map:6: the row has 4 columns, not the 3 that 'width' says");
  EXPECT_EQ(error_of(kHeader + "...\n\n...\n"),
            "m.map:6: the row has 0 columns, not the 3 that 'width' says");
}

TEST(MovingAiMap, RefusesBrokenHeaders) {
  for (const std::string text :
       {"", "\n", "x", "type\n", "type raw\nheight 1\nwidth 1\nmap\n.\n", "height 1\nwidth 1\nmap\n.\n",
        "type octile\nheight 1\nmap\n.\n", "type octile\nwidth 1\nmap\n.\n",
        "type octile\nheight 1\nwidth 1\n", "type octile\nheight -1\nwidth 1\nmap\n.\n",
        "type octile\nheight 0\nwidth 1\nmap\n", "type octile\nheight 1.5\nwidth 1\nmap\n.\n",
        "type octile\nheight\nwidth 1\nmap\n.\n", "type octile\nheight 1 2\nwidth 1\nmap\n.\n",
        "type octile\ndepth 1\nwidth 1\nmap\n.\n"}) {
    const std::string error = error_of(text);
    EXPECT_EQ(error.rfind("m.map:", 0), 0u) << text << " -> " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_EQ(error_of("type octile\nheight 1\nmap\n.\n"), "m.map:3: the header lacks the line 'width N'");
}

TEST(MovingAiMap, RefusesHugeDimensionsBeforeTakingMemory) {
  for (const std::string size : {"1000000000", "8193", "4294967296", "9223372036854775807",
                                 "18446744073709551616", "99999999999999999999999999999999"}) {
    const std::string error = error_of("type octile\nheight " + size + "\nwidth " + size + "\nmap\n.\n");
    EXPECT_NE(error.find("m.map:4: the map is too large: at most 67108864 cells"), std::string::npos)
        << error;
  }
  // A plausible size that the file does not hold fails at its first missing row.
  EXPECT_EQ(error_of("type octile\nheight 8192\nwidth 8192\nmap\n"),
            "m.map:4: the file ends after 0 of 8192 rows");
}

TEST(MovingAiMap, WritesWhatItReads) {
  GridMap map(5, 3);
  map.set({0, 0}, true);
  map.set({4, 2}, true);
  EXPECT_EQ(movingai_map_text(map), "type octile\nheight 3\nwidth 5\nmap\n@....\n.....\n....@\n");
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_map(map, folder.file("a.map")).ok());
  const auto back = read_map(folder.file("a.map"));
  ASSERT_TRUE(back.ok()) << back.error();
  EXPECT_EQ(*back, map);
}

TEST(MovingAiMap, NamesAMissingFile) {
  const auto map = read_map("/nowhere/a.map");
  ASSERT_FALSE(map.ok());
  EXPECT_EQ(map.error(), "cannot read '/nowhere/a.map': No such file or directory");
  EXPECT_NE(read_map("a.xyz").error().find("must end in .map"), std::string::npos);
}

TEST(MovingAiScen, ReadsTabsBlanksAndBothVersions) {
  for (const std::string& text :
       {std::string("version 1\n3\tmaps/dao/arena.map\t49\t48\t1\t11\t5\t12\t4.41421\n"),
        std::string("version 1.0\n3 maps/dao/arena.map 49 48 1 11 5 12 4.41421"),
        std::string("version 1\r\n3\tmaps/dao/arena.map\t49\t48\t1\t11\t5\t12\t4.41421\r\n\r\n  \n\n")}) {
    const auto scen = parse_scen(text, "m.scen");
    ASSERT_TRUE(scen.ok()) << scen.error();
    ASSERT_EQ(scen->problems.size(), 1u);
    const ScenProblem& problem = scen->problems[0];
    EXPECT_EQ(scen->map_name, "maps/dao/arena.map");
    EXPECT_EQ(problem.bucket, 3);
    EXPECT_EQ(problem.line, 2);
    EXPECT_EQ(problem.width, 49);
    EXPECT_EQ(problem.height, 48);
    EXPECT_EQ(problem.start, (Cell{1, 11}));
    EXPECT_EQ(problem.goal, (Cell{5, 12}));
    EXPECT_EQ(problem.length, 4.41421);
    EXPECT_EQ(problem.printed, "4.41421");
  }
}

TEST(MovingAiScen, RefusesBadLines) {
  const std::string good = "version 1\n0\ta.map\t9\t9\t1\t1\t2\t1\t1\n";
  EXPECT_EQ(scen_error_of(good), "");
  EXPECT_EQ(scen_error_of(""), "m.scen:0: not a MovingAI scenario: the first line must be 'version 1'");
  EXPECT_EQ(scen_error_of("version 2\n"), "m.scen:1: scenario version '2' is not known: only 1 is");
  EXPECT_EQ(scen_error_of(good + "0\ta.map\t9\t9\t1\t1\t2\n"),
            "m.scen:3: the goal y must be a whole number from 0, not ''");
  EXPECT_EQ(scen_error_of(good + "0\ta.map\t9\t9\t1\t-1\t2\t1\t1\n"),
            "m.scen:3: the start y must be a whole number from 0, not '-1'");
  EXPECT_EQ(scen_error_of(good + "0\ta.map\t9\t9\t1\t1\t2\t1\tnan\n"),
            "m.scen:3: the optimal length must be a number from 0, not 'nan'");
  EXPECT_EQ(scen_error_of(good + "0\ta.map\t9\t9\t1\t1\t2\t1\t1\t7\n"),
            "m.scen:3: the line goes on after its 9 fields: '7'");
  EXPECT_EQ(scen_error_of(good + "x\n"),
            "m.scen:3: the first field, the bucket, must be a whole number from 0");
  EXPECT_EQ(
      scen_error_of(good + "0\tb.map\t9\t9\t1\t1\t2\t1\t1\n"),
      "m.scen:3: the line is for map 'b.map', the ones before it for 'a.map': one file must be for one map");
}

LengthFormat format_of(const std::vector<std::string>& printed) {
  std::vector<ScenProblem> problems(printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i) problems[i].printed = printed[i];
  return LengthFormat::of(problems);
}

TEST(MovingAiScen, FindsOutHowLengthsArePrinted) {
  const LengthFormat stream = format_of({"1", "3.41421", "62.15", "127.87"});
  EXPECT_FALSE(stream.fixed);
  EXPECT_EQ(stream.digits, 6);
  const LengthFormat whole =
      format_of({"4", "4787"});  // a maze of width 1: the stream's print, not "no decimals"
  EXPECT_FALSE(whole.fixed);
  EXPECT_EQ(whole.digits, 6);
  const LengthFormat two = format_of({"244.95", "7.00", "0.00"});
  EXPECT_TRUE(two.fixed);
  EXPECT_EQ(two.digits, 2);
  const LengthFormat eight = format_of({"1534.80000000", "2.41421356"});
  EXPECT_TRUE(eight.fixed);
  EXPECT_EQ(eight.digits, 8);
}

TEST(MovingAiScen, AgreesToThePrintedPrecision) {
  const LengthFormat stream = format_of({"1", "3.41421", "62.15"});
  EXPECT_TRUE(stream.agrees(62.149978, "62.15"));
  EXPECT_TRUE(stream.agrees(62.15004, "62.15"));
  EXPECT_FALSE(stream.agrees(62.1506, "62.15"));
  EXPECT_TRUE(stream.agrees(2 + std::sqrt(2.0), "3.41421"));
  EXPECT_FALSE(stream.agrees(3.41422, "3.41421"));
  EXPECT_TRUE(stream.agrees(1007.2153, "1007.22"));
  EXPECT_FALSE(stream.agrees(1007.2149, "1007.22"));
  EXPECT_FALSE(stream.agrees(1.414, "1"));
  EXPECT_TRUE(stream.agrees(0, "0"));
  EXPECT_FALSE(stream.agrees(1, "0"));
  EXPECT_FALSE(stream.agrees(HUGE_VAL, "62.15"));
  EXPECT_FALSE(stream.agrees(std::nan(""), "62.15"));
  const LengthFormat two = format_of({"244.95", "7.00"});
  EXPECT_TRUE(two.agrees(5 * std::sqrt(2.0), "7.07"));
  EXPECT_FALSE(two.agrees(7.0, "7.07"));
  const LengthFormat eight = format_of({"2.41421356", "31.31370850"});
  EXPECT_TRUE(eight.agrees(20 + 8 * std::sqrt(2.0), "31.31370850"));
  EXPECT_FALSE(eight.agrees(31.31370860, "31.31370850"));
  // Summed with a rounded root of two.
  EXPECT_TRUE(stream.agrees(243 + 96 * std::sqrt(2.0), "378.764"));
  EXPECT_TRUE(eight.agrees(2 + 7 * std::sqrt(2.0), "11.89949493"));
}

TEST(MovingAiScen, FindsItsMapBesideIt) {
  const test::TemporaryFolder folder;
  const std::string scen = folder.file("arena.map.scen");
  EXPECT_EQ(
      map_beside(scen, "maps/dao/arena.map").error(),
      scen + ": its map 'arena.map' is not in '" + folder.path() + "': put it there or give one with --map");
  const std::string map = folder.with("arena.map", "x");
  for (const char* name : {"maps/dao/arena.map", "arena.map", "maps\\dao\\arena.map"}) {
    const auto found = map_beside(scen, name);
    ASSERT_TRUE(found.ok()) << found.error();
    EXPECT_EQ(*found, map);
  }
  EXPECT_FALSE(map_beside(scen, "maps/").ok());
}

TEST(MovingAiScen, RefusesAnotherMap) {
  const auto scen =
      parse_scen("version 1\n0\ta.map\t9\t8\t1\t1\t8\t7\t1\n0\ta.map\t9\t8\t1\t1\t9\t1\t1\n", "m.scen");
  ASSERT_TRUE(scen.ok());
  EXPECT_EQ(check_scen_fits(*scen, GridMap(9, 8), "a.map").error(), "m.scen:3: (9, 1) is outside the map");
  EXPECT_EQ(check_scen_fits(*scen, GridMap(8, 9), "b.map").error(),
            "m.scen:2: is for a map of 9 x 8 cells, 'b.map' has 8 x 9: give the right map with --map");
}

/// The nearest length n + m sqrt 2 of a lattice path to a printed one, over all whole n and m.
double nearest_lattice_length(double printed) {
  double best = 0;
  for (int m = 0; m * std::sqrt(2.0) <= printed + 1; ++m) {
    const double length = std::round(printed - m * std::sqrt(2.0)) + m * std::sqrt(2.0);
    if (std::abs(length - printed) < std::abs(best - printed)) best = length;
  }
  return best;
}

TEST(MovingAiShared, ReadsEveryFileAndTheLengthsAreThoseOfLatticePaths) {
  REPLAN_NEED_SHARED_DATA();
  const auto files = test::files_below(test::shared_data() / "movingai", ".scen");
  ASSERT_EQ(files.size(), 23u);
  std::size_t problems = 0;
  std::map<std::pair<bool, int>, int> formats;
  for (const auto& file : files) {
    const auto scen = read_scen(file.string());
    ASSERT_TRUE(scen.ok()) << scen.error();
    const auto path = map_beside(file.string(), scen->map_name);
    ASSERT_TRUE(path.ok()) << path.error();
    const auto map = read_movingai_map(*path);
    ASSERT_TRUE(map.ok()) << map.error();
    const auto fits = check_scen_fits(*scen, *map, *path);
    EXPECT_TRUE(fits.ok()) << fits.error();
    ++formats[{scen->lengths.fixed, scen->lengths.digits}];
    problems += scen->problems.size();
    for (const ScenProblem& problem : scen->problems) {
      EXPECT_TRUE(scen->agrees(nearest_lattice_length(problem.length), problem))
          << file << ":" << problem.line;
      EXPECT_FALSE(scen->agrees(problem.length + 0.02, problem)) << file << ":" << problem.line;
    }
  }
  EXPECT_EQ(problems, 43'724u);
  const std::map<std::pair<bool, int>, int> expected = {{{false, 6}, 14}, {{true, 2}, 2}, {{true, 8}, 7}};
  EXPECT_EQ(formats, expected);
}

TEST(MovingAiShared, KeepsTheFreeCellsThatArePublished) {
  REPLAN_NEED_SHARED_DATA();
  const std::map<std::string, int> free = {
      {"dao/arena", 2054},        {"wc3maps512/icecrown", 176566}, {"cities/Berlin_0_256", 48147},
      {"mapf/maze-32-32-4", 790}, {"sc1/Aftershock", 166076},      {"bg512/AR0011SR", 120458}};
  for (const auto& [name, count] : free) {
    const auto map = read_map((test::shared_data() / "movingai" / (name + ".map")).string());
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(std::count(map->blocked.begin(), map->blocked.end(), 0), count) << name;
    EXPECT_EQ(*parse_movingai_map(movingai_map_text(*map), name), *map) << name;
  }
}

}  // namespace
}  // namespace replan::world_movingai_test

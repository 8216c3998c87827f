// numpy's arrays: what is read, and what is refused with a sentence.
#include <gtest/gtest.h>

#include "core/world/formats/ascii_map.hpp"
#include "core/world/formats/npy_map.hpp"
#include "core/world/map_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_npy_test {
namespace {

/// A file as numpy.save() writes it.
std::string npy(const std::string& header, const std::string& values, char version = 1) {
  std::string padded = header;
  while ((10 + padded.size() + 1) % 64 != 0) padded += ' ';
  padded += '\n';
  std::string bytes = std::string("\x93NUMPY") + version + '\0';
  for (int i = 0; i < (version == 1 ? 2 : 4); ++i) bytes += static_cast<char>(padded.size() >> 8 * i & 0xFF);
  return bytes + padded + values;
}
std::string header(const std::string& type, const std::string& shape, const std::string& fortran = "False") {
  return "{'descr': '" + type + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
}

/// What is read, or the error.
std::string read_as(const std::string& bytes, std::optional<double> occupied = {}) {
  const auto world = parse_npy_map(bytes, "a.npy", occupied);
  return world ? ascii_text(*world) : world.error();
}

/// 0, 1, 0 / 0, 0, 1 with that many bytes each.
std::string values(std::size_t size, bool big_endian = false) {
  std::string bytes;
  for (const char value : {'\0', '\1', '\0', '\0', '\0', '\1'}) {
    std::string one(size, '\0');
    one[big_endian ? size - 1 : 0] = value;
    bytes += one;
  }
  return bytes;
}

TEST(Npy, ReadsEveryTypeInBothOrders) {
  for (const char* type : {"|b1", "|i1", "|u1"})
    EXPECT_EQ(read_as(npy(header(type, "(2, 3)"), values(1))), ".@.\n..@\n");
  for (const auto& [kind, size] : {std::pair{"2", 2}, {"4", 4}, {"8", 8}})
    for (const char* letter : {"i", "u"})
      for (const char* order : {"<", ">"})
        EXPECT_EQ(read_as(npy(header(std::string(order) + letter + kind, "(2, 3)"),
                              values(static_cast<std::size_t>(size), order[0] == '>'))),
                  ".@.\n..@\n")
            << order << letter << kind;
  EXPECT_EQ(read_as(npy(header("|u1", "(3, 2)", "True"), values(1))), "..\n@.\n.@\n") << "column by column";
  EXPECT_EQ(read_as(npy(header("|u1", "(2, 3)"), values(1), 2)), ".@.\n..@\n");
  EXPECT_EQ(read_as(npy("{'shape': (2, 3), 'fortran_order': False, 'descr': '|u1'}", values(1))),
            ".@.\n..@\n");
}

TEST(Npy, NumbersSayWhichIsTheObstacle) {
  const std::string signs = npy(header("|i1", "(1, 3)"), std::string("\xFF\0\x64", 3));
  EXPECT_EQ(
      read_as(signs).rfind("a.npy: there are the numbers -1, 0 and 100: say which one is the obstacle", 0),
      0u);
  EXPECT_EQ(read_as(signs, -1), "@..\n");
  EXPECT_EQ(read_as(npy(header("<i8", "(1, 1)"), std::string(8, '\xFF')), -1), "@\n");
  EXPECT_EQ(read_as(npy(header("<u8", "(1, 1)"), std::string(8, '\xFF')), 18446744073709551615.0), "@\n");
  EXPECT_EQ(read_as(npy(header("|b1", "(1, 2)"), std::string("\0\1", 2)), 0), "@.\n");
  const test::TemporaryFolder folder;
  const std::string path = folder.with("a.npy", signs);
  EXPECT_EQ(read_map_file(path, {.image = {}, .unknown = {}, .occupied = 100})->map.blocked,
            (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_NE(read_map(folder.with("a.map", ""), {.image = {}, .unknown = {}, .occupied = 1})
                .error()
                .find("only in a file of numbers"),
            std::string::npos);
}

TEST(Npy, RefusesWhatIsNoMap) {
  EXPECT_EQ(read_as(""), "a.npy: not a .npy file: it must begin as numpy.save() writes it");
  EXPECT_EQ(
      read_as(npy(header("<f8", "(1, 1)"), std::string(8, '\0'))),
      "a.npy: the array is of type '<f8'; booleans and whole numbers are read: save array.astype(int), or "
      "array > 0.5");
  EXPECT_NE(
      read_as(npy("{'descr': [('x', '<i8')], 'fortran_order': False, 'shape': (1,), }", "")).find("records"),
      std::string::npos);
  EXPECT_EQ(read_as(npy(header("|u1", "(6,)"), values(1))),
            "a.npy: the array has 1 dimension, a map has 2: save one plane of it");
  EXPECT_EQ(read_as(npy(header("|u1", "(1, 2, 3)"), values(1))),
            "a.npy: the array has 3 dimensions, a map has 2: save one plane of it");
  EXPECT_EQ(read_as(npy(header("|u1", "(0, 3)"), "")), "a.npy: the array has no cells");
  EXPECT_EQ(read_as(npy(header("<i8", "(99999999999999999999999, 3)"), "")),
            "a.npy: the map is too large: at most 67108864 cells (8192 x 8192) are read");
  EXPECT_EQ(read_as(npy(header("|u1", "(8192, 8192)"), "abc")),
            "a.npy: the file ends after 3 of 67108864 values");
  EXPECT_EQ(read_as(npy(header("|u1", "(2, 3)"), values(1) + "x")),
            "a.npy: the file goes on after its 6 values: save the array anew");
  EXPECT_EQ(read_as(npy(header("|u1", "(2, 3)"), values(1), 9)),
            "a.npy: version 9 of the .npy format is not known: 1 to 3 are");
  EXPECT_EQ(
      read_as(npy("{'descr': '|u1', 'shape': (2, 3), }", values(1))).rfind("a.npy: the header must be ", 0),
      0u);
  EXPECT_EQ(read_as(npy(header("|u1", "(2, 3)", "Maybe"), values(1))).rfind("a.npy: the header must be ", 0),
            0u);
  const std::string whole = npy(header("|u1", "(2, 3)"), values(1));
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parse_npy_map(whole.substr(0, length), "a.npy").ok()) << length;
}

}  // namespace
}  // namespace replan::world_npy_test

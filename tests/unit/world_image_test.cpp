#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/image_map.hpp"
#include "core/world/map_file.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan {
namespace {

/// A binary PGM, 4 x 1: black, just below and just at the default threshold, white.
const std::string kGreys = std::string("P5\n4 1\n255\n") + '\0' + '\x7F' + '\x80' + '\xFF';

std::vector<std::uint8_t> cells(const ImageMapOptions& options) {
  const auto map = decode_image_map(kGreys, "g.pgm", options);
  return map.ok() ? map->blocked : std::vector<std::uint8_t>{};
}

TEST(ImageMap, DarkerThanTheThresholdIsAnObstacle) {
  EXPECT_EQ(cells({}), (std::vector<std::uint8_t>{1, 1, 0, 0}));
  EXPECT_EQ(cells({.threshold = 1}), (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(cells({.threshold = 255}), (std::vector<std::uint8_t>{1, 1, 1, 0}));
  EXPECT_EQ(cells({.threshold = 128, .invert = true}), (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

TEST(ImageMap, ReadsBackTheWrittenPng) {
  GridMap map(7, 5);
  for (const Cell c : {Cell{0, 0}, Cell{6, 4}, Cell{3, 2}, Cell{1, 0}}) map.set(c, true);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_map(map, folder.file("a.png")).ok());
  const auto back = read_map(folder.file("a.png"));
  ASSERT_TRUE(back.ok()) << back.error();
  EXPECT_EQ(*back, map);
  EXPECT_FALSE(write_map_png(map, folder.file("no/a.png")).ok());
  EXPECT_FALSE(write_map(map, folder.file("a.jpg")).ok());
}

/// A PNG's first bytes, which claim a size.
std::string png_header(std::uint32_t width, std::uint32_t height) {
  std::string bytes("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16);
  for (const std::uint32_t side : {width, height})
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(side >> shift & 0xFF);
  return bytes + std::string("\x08\0\0\0\0\0\0\0\0", 9);
}

TEST(ImageMap, RefusesTooManyPixelsBeforeDecoding) {
  const auto map = decode_image_map(png_header(9000, 9000), "big.png");
  ASSERT_FALSE(map.ok());
  EXPECT_EQ(map.error(),
            "big.png: the picture is too large: 9000 x 9000 pixels, at most 67108864 (8192 x 8192) are read");
  EXPECT_FALSE(decode_image_map(png_header(0x7FFFFFFF, 0x7FFFFFFF), "big.png").ok());
}

TEST(ImageMap, RefusesBrokenPictures) {
  GridMap map(64, 64);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_map_png(map, folder.file("a.png")).ok());
  const std::string whole = *read_file(folder.file("a.png"));
  for (std::size_t length = 0; length + 20 < whole.size(); ++length)
    EXPECT_FALSE(decode_image_map(whole.substr(0, length), "cut.png").ok()) << length;
  EXPECT_EQ(decode_image_map("", "a.png").error(), "a.png: the file is empty");
  const auto text = decode_image_map("no picture at all", "a.png");
  EXPECT_EQ(text.error().rfind("a.png: not a picture that can be read (PNG, BMP, JPEG, PGM, PPM): ", 0), 0u);
  EXPECT_FALSE(read_image_map("/nowhere/a.png").ok());
}

TEST(ImageMap, ReadsRosPictures) {
  REPLAN_NEED_SHARED_DATA();
  const auto map = read_map((test::shared_data() / "ros" / "lse_arena.pgm").string());
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->width, 80);
  EXPECT_EQ(map->height, 60);
  EXPECT_EQ(std::count(map->blocked.begin(), map->blocked.end(), 1), 345);
}

}  // namespace
}  // namespace replan

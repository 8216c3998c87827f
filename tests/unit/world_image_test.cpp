#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/formats/image_map.hpp"
#include "core/world/formats/jpeg.hpp"
#include "core/world/map_file.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_image_test {
namespace {

/// A binary PGM, 4 x 1: black, just below and just at the default threshold, white.
const std::string kGreys = std::string("P5\n4 1\n255\n") + '\0' + '\x7F' + '\x80' + '\xFF';

std::vector<std::uint8_t> cells(const ImageMapOptions& options) {
  const auto map = decode_image_map(kGreys, "g.pgm", options);
  return map.ok() ? map->blocked.plain() : std::vector<std::uint8_t>{};
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
  EXPECT_FALSE(write_image_map(map, folder.file("no/a.png")).ok());
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
  EXPECT_NE(decode_image_map(png_header(0x7FFFFFFF, 0x7FFFFFFF), "big.png").error().find("2147483647 x"),
            std::string::npos);
  EXPECT_EQ(decode_image_map(png_header(0, 4), "a.png").error(), "a.png: the picture has no pixels");
  const std::string place = "big: the picture is too large: 60000 x 60000 pixels, at most ";
  const std::string side = "\x60\xEA";
  for (const std::string& header :
       {png_header(60000, 60000), "GIF89a" + side + side + std::string(40, '\0'),
        "BM" + std::string(12, '\0') + std::string("\x28\0\0\0", 4) + side + std::string(2, '\0') + side +
            std::string("\0\0\1\0\x18", 5) + std::string(40, '\0'),
        std::string("\0\0\2\0\0\0\0\0\0\0\0\0", 12) + side + side + std::string("\x18\0", 2),
        std::string("P5 60000 60000 255\n"), std::string("P4 60000 60000\n")})
    EXPECT_EQ(decode_image_map(header, "big").error().rfind(place, 0), 0u)
        << decode_image_map(header, "big").error();
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

/// A grey PNG of 8 x 8 pixels whose one block of compressed data says `count` times "258 bytes as before": a
/// few kilobytes that swell to a thousand times as much. stb_image looks at no checksums.
std::string png_bomb(int count) {
  std::string bits = std::string(1, '\x03');  // the last block, with the fixed codes: 3 bits
  int used = 3;
  const auto put = [&](unsigned value, int length) {
    for (int i = 0; i < length; ++i, ++used) {
      if (used % 8 == 0) bits += '\0';
      if ((value >> i & 1u) != 0) bits.back() = static_cast<char>(bits.back() | 1 << used % 8);
    }
  };
  put(0x0C, 8);                                             // the literal 0: code 00110000, first bit first
  for (int i = 0; i < count; ++i) put(0xA3, 8), put(0, 5);  // length 258: code 11000101; distance 1
  put(0, 7);                                                // the end of the block
  const std::string data = std::string("\x78\x01") + bits;
  return png_header(8, 8) + big_endian(static_cast<std::uint32_t>(data.size())) + "IDAT" + data +
         std::string(4, '\0') + big_endian(0) + "IEND" + std::string(4, '\0');
}

TEST(ImageMap, RefusesAPngThatSwells) {
  const auto small = decode_image_map(png_bomb(20), "b.png");
  EXPECT_TRUE(small.ok()) << small.error();  // more data than pixels, but in bounds
  const auto map = decode_image_map(png_bomb(100'000), "b.png");
  ASSERT_FALSE(map.ok());
  EXPECT_NE(map.error().find("outofmem"), std::string::npos) << map.error();
}

TEST(ImageMap, ReadsColoursAndTransparencyByBrightness) {
  const Picture picture{3, 1, 4, {255, 0, 0, 255, /**/ 0, 255, 0, 255, /**/ 0, 0, 0, 100}};
  // Red is 76, green 149, black seen through to white 155.
  EXPECT_EQ(image_cells(picture).blocked, (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(image_cells(picture, {.threshold = 76}).blocked, (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(image_cells(picture, {.threshold = 155}).blocked, (std::vector<std::uint8_t>{1, 1, 0}));
  EXPECT_EQ(image_cells(picture, {.threshold = 156}).blocked, (std::vector<std::uint8_t>{1, 1, 1}));
}

TEST(ImageMap, RefusesBrokenPictures) {
  GridMap map(64, 64);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_image_map(map, folder.file("a.png")).ok());
  const std::string whole = *read_file(folder.file("a.png"));
  for (std::size_t length = 0; length + 20 < whole.size(); ++length)
    EXPECT_FALSE(decode_image_map(whole.substr(0, length), "cut.png").ok()) << length;
  EXPECT_EQ(decode_image_map("", "a.png").error(), "a.png: the file is empty");
  const auto text = decode_image_map("no picture at all", "a.png");
  EXPECT_EQ(text.error().rfind(
                "a.png: not a picture that can be read (PNG, BMP, JPEG, TGA, GIF, PBM, PGM, PPM): ", 0),
            0u);
  EXPECT_FALSE(read_image_map("/nowhere/a.png").ok());
}

/// A JPEG of the fuzzers' corpus: 8 x 8, rows of white and of dark colours by turns.
std::string small_jpeg() {
  return *read_file(std::string(REPLAN_SOURCE_DIR) + "/tests/fuzz/corpus/picture/small.jpg");
}

TEST(ImageMap, ReadsJpegs) {
  const auto map = decode_image_map(small_jpeg(), "a.jpg");
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->width, 8);
  EXPECT_EQ(map->height, 8);
  EXPECT_TRUE(map->at({0, 0}));
  for (int x = 0; x < 8; ++x) EXPECT_FALSE(map->at({x, 1}) || map->at({x, 3})) << x;
}

TEST(ImageMap, RefusesBrokenJpegs) {
  const std::string whole = small_jpeg();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(decode_image_map(whole.substr(0, length), "cut.jpg").ok()) << length;
  const auto cut = decode_image_map(whole.substr(0, whole.size() - 20), "cut.jpg");
  EXPECT_EQ(cut.error().rfind("cut.jpg: not a picture that can be read (JPEG): ", 0), 0u) << cut.error();
  std::string huge = whole;
  const std::size_t frame = huge.find("\xFF\xC0");
  huge.replace(frame + 5, 4, "\xEA\x60\xEA\x60");
  EXPECT_EQ(
      decode_image_map(huge, "huge.jpg").error(),
      "huge.jpg: the picture is too large: 60000 x 60000 pixels, at most 67108864 (8192 x 8192) are read");
}

TEST(ImageMap, AJpegOfTheLargestSidesIsTooLargeToo) {
  std::string huge = small_jpeg();
  huge.replace(huge.find("\xFF\xC0") + 5, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_EQ(decode_image_map(huge, "huge.jpg")
                .error()
                .rfind("huge.jpg: the picture is too large: 65535 x 65535", 0),
            0u);
}

TEST(ImageMap, ExifTurnsAJpegUpright) {
  // 3 x 2: the values tell where each pixel was.
  const Picture stored{3, 2, 1, {1, 2, 3, 4, 5, 6}};
  const std::vector<std::uint8_t> turned[] = {{1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1},
                                              {4, 5, 6, 1, 2, 3}, {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3},
                                              {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Picture upright = turned_by_exif(stored, orientation);
    EXPECT_EQ(upright.width, orientation < 5 ? 3 : 2);
    EXPECT_EQ(upright.values, turned[orientation - 1]) << orientation;
  }
  EXPECT_EQ(turned_by_exif(stored, 9), stored);
  const std::string big("Exif\0\0MM\0\x2A\0\0\0\x08\0\1\x01\x12\0\3\0\0\0\1\0\6\0\0", 28);
  const std::string little("Exif\0\0II\x2A\0\x08\0\0\0\1\0\x12\x01\3\0\1\0\0\0\x08\0\0\0", 28);
  EXPECT_EQ(exif_orientation(big), 6);
  EXPECT_EQ(exif_orientation(little), 8);
  for (std::size_t length = 0; length < big.size(); ++length)
    EXPECT_EQ(exif_orientation(std::string_view(big).substr(0, length)), 1) << length;
  std::string jpeg = small_jpeg();
  jpeg.insert(2, std::string("\xFF\xE1\0\x1E", 4) + big);
  // Rows of white and dark by turns become columns.
  const auto map = decode_image_map(jpeg, "a.jpg");
  ASSERT_TRUE(map.ok()) << map.error();
  for (int y = 0; y < 8; ++y) EXPECT_FALSE(map->at({6, y}) || map->at({4, y})) << y;
  EXPECT_EQ(*decode_picture(jpeg, "a.jpg", kMaxCells, Lying::as_stored),
            *decode_picture(small_jpeg(), "a.jpg"));
}

TEST(ImageMap, ReadsTheFirstFrameOfAGif) {
  const std::string gif =
      *read_file(std::string(REPLAN_SOURCE_DIR) + "/tests/fuzz/corpus/picture/two-frames.gif");
  const auto map = decode_image_map(gif, "a.gif");
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->width, 5);
  EXPECT_EQ(map->blocked, (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1}));
  const std::size_t second = gif.find("\x21\xF9", gif.find('\x2C', 781));  // behind the first frame
  for (std::size_t length = 0; length < gif.size(); ++length)
    EXPECT_EQ(decode_image_map(gif.substr(0, length), "a.gif").ok(), length >= second) << length;
}

TEST(ImageMap, RefusesBmpAndTgaThatEndEarly) {
  GridMap map(9, 7);
  map.set({3, 3}, true);
  const test::TemporaryFolder folder;
  for (const char* name : {"a.bmp", "a.tga"}) {
    ASSERT_TRUE(write_image_map(map, folder.file(name)).ok());
    const std::string whole = *read_file(folder.file(name));
    ASSERT_TRUE(decode_image_map(whole, name).ok());
    // The padding behind the last row of a BMP may be missing.
    for (std::size_t length = 0; length + 2 < whole.size(); ++length)
      EXPECT_FALSE(decode_image_map(whole.substr(0, length), name).ok()) << name << length;
  }
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
}  // namespace replan::world_image_test

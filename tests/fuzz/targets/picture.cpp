#include "core/world/formats/image_map.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(picture) {
  // Large ones take seconds each, and decode no differently.
  const auto picture = decode_picture(input, "f.png", 1 << 16);
  require_good_error(picture, "f.png:");
  if (!picture) return;
  const GridMap map = image_cells(*picture);
  const GridMap inverted = image_cells(*picture, {.threshold = 128, .invert = true});
  for (std::size_t i = 0; i < map.blocked.size(); ++i)
    require(map.blocked[i] != inverted.blocked[i], "inversion changes every cell");
  if (map.blocked.size() > 4096) return;
  Picture grey{map.width, map.height, 1, {}};
  for (const std::uint8_t cell : map.blocked) grey.values.push_back(cell == kFree ? 255 : 0);
  for (const char* extension : {".png", ".bmp", ".tga", ".pgm"}) {
    const auto bytes = encode_grey(grey, extension);
    require(bytes.ok(), "every map can be written");
    const auto again = decode_image_map(*bytes, "again");
    require(again.ok() && *again == map, std::string("what was written is read back equal: ") + extension);
  }
}

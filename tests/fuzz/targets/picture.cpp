#include "core/world/image_map.hpp"
#include "tests/fuzz/target.hpp"

REPLAN_FUZZ_TARGET(picture) {
  const auto map = decode_image_map(input, "f.png");
  require_good_error(map, "f.png:");
  if (!map || map->blocked.size() > 4096) return;
  Picture grey{map->width, map->height, 1, {}};
  for (const std::uint8_t cell : map->blocked) grey.values.push_back(cell == kFree ? 255 : 0);
  for (const char* extension : {".png", ".bmp", ".tga", ".pgm"}) {
    const auto bytes = encode_grey(grey, extension);
    require(bytes.ok(), "every map can be written");
    const auto again = decode_image_map(*bytes, "again");
    require(again.ok() && *again == *map, std::string("what was written is read back equal: ") + extension);
  }
}

#include "core/world/map_file.hpp"

#include <algorithm>
#include <array>

#include "core/base/file.hpp"
#include "core/world/image_map.hpp"
#include "core/world/movingai.hpp"

namespace replan {

Result<GridMap> read_map(const std::string& path) {
  constexpr std::array kPictures = {".png", ".bmp", ".jpg", ".jpeg", ".pgm", ".ppm"};
  const std::string extension = file_extension(path);
  if (extension == ".map") return read_movingai_map(path);
  if (std::find(kPictures.begin(), kPictures.end(), extension) != kPictures.end())
    return read_image_map(path);
  return Error{"cannot read '" + path +
               "' as a map: its name must end in .map, .png, .bmp, .jpg, .pgm or .ppm"};
}

Result<void> write_map(const GridMap& map, const std::string& path) {
  const std::string extension = file_extension(path);
  if (extension == ".map") return write_movingai_map(map, path);
  if (extension == ".png") return write_map_png(map, path);
  return Error{"cannot write a map to '" + path + "': its name must end in .map or .png"};
}

}  // namespace replan

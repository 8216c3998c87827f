// A bound on the memory that decoding a picture may take.
#pragma once

#include <cstddef>

namespace replan {

/// While it lives, stb_image gets no block of memory larger than this on this thread: decoding then fails
/// with "outofmem". A few kilobytes of a PNG can swell to gigabytes, and stb_image alone lets them.
class PictureMemory {
 public:
  explicit PictureMemory(std::size_t largest_block);
  ~PictureMemory();
  PictureMemory(const PictureMemory&) = delete;
  PictureMemory& operator=(const PictureMemory&) = delete;

 private:
  std::size_t before_;
};

}  // namespace replan

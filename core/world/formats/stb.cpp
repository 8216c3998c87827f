// The one place where the stb headers are compiled. PNG, BMP, TGA and GIF are read by them (JPEG
// in core/world/jpeg.cpp, PBM, PGM and PPM in core/world/pnm.cpp); the rest stays out. The headers are
// system headers, so their warnings are not ours.
#include "core/world/formats/stb.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace replan {
namespace {

thread_local std::size_t largest_picture_block = SIZE_MAX;

void* picture_memory(void* old, std::size_t size) {
  return size > largest_picture_block ? nullptr : std::realloc(old, size);
}

/// stb_image copies the nothing of an empty PNG chunk to a null pointer, which memcpy() does not allow even
/// then.
void* copy_bytes(void* to, const void* from, std::size_t count) {
  return count == 0 ? to : std::memcpy(to, from, count);
}

}  // namespace

PictureMemory::PictureMemory(std::size_t largest_block) : before_(largest_picture_block) {
  largest_picture_block = largest_block;
}

PictureMemory::~PictureMemory() {
  largest_picture_block = before_;
}

}  // namespace replan

#define STBI_MALLOC(size) replan::picture_memory(nullptr, size)
#define STBI_REALLOC(old, size) replan::picture_memory(old, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_ONLY_GIF
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
// What stb_image.h includes must have been read before memcpy becomes another word in it.
#include <cassert>
#include <climits>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#define memcpy replan::copy_bytes
#include <stb/stb_image.h>
#undef memcpy
#include <stb/stb_image_write.h>

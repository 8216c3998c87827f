// The one place where the stb headers are compiled. PNG, BMP, JPEG and TGA are enough for maps and pictures
// (PGM and PPM are read in core/world/pnm.cpp); the rest stays out. The headers are system headers, so their
// warnings are not ours.
#include "core/base/stb.hpp"

#include <cstdint>
#include <cstdlib>

namespace replan {
namespace {

thread_local std::size_t largest_picture_block = SIZE_MAX;

void* picture_memory(void* old, std::size_t size) {
  return size > largest_picture_block ? nullptr : std::realloc(old, size);
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
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

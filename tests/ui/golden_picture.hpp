// Pictures against golden ones. REPLAN_UPDATE_GOLDEN=1 writes them anew: look at them then.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/render.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/image.hpp"

namespace replan::app {

/// Fonts may be rastered a little differently on another system; shapes and colours may not.
inline void compare_with_golden(RenderRequest request, const std::string& name) {
  const test::TemporaryFolder folder;
  request.output = folder.file(name + ".png");
  const Result<void> drawn = render(request);
  ASSERT_TRUE(drawn.ok()) << drawn.error();
  const auto golden = std::filesystem::path(REPLAN_SOURCE_DIR) / "tests" / "golden" / (name + ".png");
  if (std::getenv("REPLAN_UPDATE_GOLDEN") != nullptr) {
    std::filesystem::create_directories(golden.parent_path());
    std::filesystem::copy_file(request.output, golden, std::filesystem::copy_options::overwrite_existing);
    return;
  }
  const auto expected = ui::read_image(golden), actual = ui::read_image(request.output);
  ASSERT_TRUE(expected.ok()) << expected.error();
  ASSERT_TRUE(actual.ok()) << actual.error();
  const ui::Difference difference = ui::compare(*expected, *actual, 24);
  EXPECT_TRUE(difference.same_size);
  EXPECT_LT(difference.share, 0.01) << name << ": max " << difference.max << ", mean " << difference.mean;
  EXPECT_LT(difference.mean, 0.6) << name;
}

}  // namespace replan::app

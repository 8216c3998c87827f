// Whether what is written can be read: the contrast of every colour of text on every ground that it stands on.
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ui/theme.hpp"

namespace replan::ui::contrast_test {
namespace {

class ThemeContrast : public testing::TestWithParam<const Theme*> {};

using Named = std::pair<const char*, ImU32>;

TEST_P(ThemeContrast, TextCanBeReadOnEveryGround) {
  const Theme& t = *GetParam();
  const std::vector<Named> texts = {{"text", t.text},     {"dim", t.dim},         {"faint", t.faint},
                                    {"accent", t.accent}, {"warning", t.warning}, {"bad", t.bad},
                                    {"good", t.good}};
  const std::vector<Named> grounds = {{"background", t.background},
                                      {"panel", t.panel},
                                      {"raised", t.raised},
                                      {"hover", t.hover},
                                      {"selected", t.selected}};
  for (const auto& [name, text] : texts)
    for (const auto& [where, ground] : grounds)
      EXPECT_GE(contrast(text, ground), kTextContrast) << t.name << ": " << name << " on " << where;
}

TEST_P(ThemeContrast, ButtonsAndChipsCanBeRead) {
  const Theme& t = *GetParam();
  EXPECT_GE(contrast(t.on_accent, t.accent), kTextContrast) << t.name;
  EXPECT_GE(contrast(t.on_accent, mix(t.accent, t.text, 0.12f)), kTextContrast)
      << t.name << ": under the mouse";
  EXPECT_GE(contrast(t.bad, danger_ground(t)), kTextContrast) << t.name;
  // A chip lets a little of the world through, of any colour.
  for (const ImU32 world : {t.free, t.obstacle, t.background})
    for (const ImU32 text : {t.text, t.dim, t.warning})
      EXPECT_GE(contrast(text, mix(world, t.panel, kChipOpacity)), kTextContrast) << t.name << ": on a chip";
}

TEST_P(ThemeContrast, FaintIsFainterThanDimAndDimThanText) {
  const Theme& t = *GetParam();
  EXPECT_LT(contrast(t.faint, t.panel), contrast(t.dim, t.panel));
  EXPECT_LT(contrast(t.dim, t.panel), contrast(t.text, t.panel));
}

INSTANTIATE_TEST_SUITE_P(All, ThemeContrast, testing::Values(&dark(), &light()),
                         [](const auto& each) { return std::string(each.param->name); });

}  // namespace
}  // namespace replan::ui::contrast_test

// The field's words: complete, whole sentences, and each only once.
#include "core/plan/glossary.hpp"

#include <cctype>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/view.hpp"
#include "core/world/choices.hpp"
#include "core/world/generators/list.hpp"

namespace replan::glossary_test {
namespace {

void expect_sentences(std::string_view text, const std::string& whose) {
  ASSERT_GE(text.size(), 10u) << whose << " has no explanation";
  EXPECT_EQ(text.back(), '.') << whose << ": " << text;
  EXPECT_TRUE(std::isupper(static_cast<unsigned char>(text.front())) ||
              text.find(' ') != std::string_view::npos)
      << whose;
  EXPECT_EQ(text.find("  "), std::string_view::npos) << whose << " has a double blank: " << text;
}

TEST(Glossary, EveryTermIsExplainedOnceAndInSentences) {
  std::set<std::string_view> ids;
  for (const GlossaryTerm& term : glossary()) {
    EXPECT_TRUE(ids.insert(term.id).second) << term.id << " is there twice";
    EXPECT_FALSE(term.title.empty()) << term.id;
    expect_sentences(term.text, std::string(term.id));
    EXPECT_LE(term.text.size(), 300u) << term.id << ": too long for a tooltip";
    EXPECT_EQ(find_term(term.id), &term) << term.id << " is also an alias of something else";
    EXPECT_EQ(term.text.data()[term.text.size()], '\0');
    EXPECT_EQ(term.title.data()[term.title.size()], '\0');
  }
}

TEST(Glossary, KnowsWhatTheWindowWrites) {
  for (const char* written : {"g",
                              "rhs",
                              "dist",
                              "state",
                              "key",
                              "f",
                              "in U",
                              "lp",
                              "rp",
                              "parent",
                              "expanded",
                              "last expansion",
                              "km",
                              "|U|",
                              "k1",
                              "k2",
                              "nodes",
                              "length",
                              "turns",
                              "turning",
                              "least clearance",
                              "mean clearance",
                              "expansions",
                              "queue operations",
                              "sight checks",
                              "first plan",
                              "replans",
                              "travelled",
                              "over",
                              "under",
                              "consistent"})
    EXPECT_NE(find_term(written), nullptr) << written;
  EXPECT_EQ(find_term("U")->id, "open-list");
  EXPECT_EQ(find_term("no such word"), nullptr);
  EXPECT_EQ(find_term(""), nullptr);
}

TEST(Glossary, EverySettingAndOverlayExplainsItself) {
  for (const PlannerInfo& info : choices()) {
    expect_sentences(info.summary, std::string(info.id));
    for (const Parameter& parameter : info.parameters)
      expect_sentences(parameter.help, std::string(info.id) + "." + std::string(parameter.key));
  }
  for (const GeneratorInfo& info : generators())
    for (const Parameter& parameter : info.parameters)
      expect_sentences(parameter.help, std::string(info.id) + "." + std::string(parameter.key));
  for (const Parameter& parameter : generator_size_parameters())
    expect_sentences(parameter.help, std::string(parameter.key));
  for (const OverlayInfo& info : overlays()) expect_sentences(info.help, std::string(info.id));
}

}  // namespace
}  // namespace replan::glossary_test

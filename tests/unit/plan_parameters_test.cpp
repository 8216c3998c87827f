#include <gtest/gtest.h>

#include "core/plan/parameters.hpp"

namespace replan::plan_parameters_test {
namespace {

const std::vector<Parameter> kParameters = {
    {.key = "heuristic", .label = "Heuristic", .type = ParameterType::choice, .choices = {"octile", "zero"}},
    {.key = "range",
     .label = "Range",
     .type = ParameterType::real,
     .initial = 2,
     .low = 1,
     .high = 16,
     .unit = "cells"},
    {.key = "count", .label = "Count", .type = ParameterType::whole, .initial = 3, .low = 1, .high = 9},
    {.key = "border", .label = "Border", .type = ParameterType::toggle},
};

std::string error_of(std::string_view key, std::string_view text) {
  Settings settings;
  const auto set = set_from_text(settings, kParameters, key, text);
  return set.ok() ? "" : set.error();
}

TEST(Parameters, ReadsEveryType) {
  Settings settings;
  for (const auto& [key, text] :
       {std::pair{"heuristic", "zero"}, {"range", "2.5"}, {"count", "9"}, {"border", "true"}})
    ASSERT_TRUE(set_from_text(settings, kParameters, key, text).ok()) << key;
  EXPECT_EQ(settings.get(kParameters[0]), 1);
  EXPECT_EQ(settings.get(kParameters[1]), 2.5);
  EXPECT_EQ(settings.get(kParameters[2]), 9);
  EXPECT_EQ(settings.get(kParameters[3]), 1);
}

TEST(Parameters, WhatIsNotSetHasItsDefault) {
  Settings settings;
  EXPECT_EQ(settings.get(kParameters[1]), 2);
  EXPECT_FALSE(settings.has("range"));
  settings.set("range", 4);
  EXPECT_TRUE(settings.has("range"));
  settings.reset("range");
  EXPECT_EQ(settings.get("range", 7), 7);
  EXPECT_EQ(settings, Settings{});
}

TEST(Parameters, ErrorsNameTheAllowedRange) {
  EXPECT_EQ(error_of("range", "17"), "'range' cannot be '17': give a number from 1 to 16 cells");
  EXPECT_EQ(error_of("range", "0.99"), "'range' cannot be '0.99': give a number from 1 to 16 cells");
  EXPECT_EQ(error_of("count", "2.5"), "'count' cannot be '2.5': give a whole number from 1 to 9");
  EXPECT_EQ(error_of("heuristic", "Octile"), "'heuristic' cannot be 'Octile': give one of: octile, zero");
  EXPECT_EQ(error_of("border", "maybe"), "'border' cannot be 'maybe': give true or false");
  for (const char* text : {"", "x", "nan", "inf", "-inf", "2x", " 2", "1e999"})
    EXPECT_NE(error_of("range", text), "");
}

TEST(Parameters, AnUnknownKeyIsSuggestedTheNearest) {
  EXPECT_EQ(error_of("huristic", "zero"), "unknown setting 'huristic'; did you mean 'heuristic'?");
  EXPECT_EQ(error_of("somethingelse", "1"),
            "unknown setting 'somethingelse'; known: heuristic, range, count, border");
}

TEST(Parameters, TextIsReadBack) {
  for (const auto& [index, value] :
       {std::pair{0u, 1.0}, {1u, 0.1 + 1.2}, {1u, 16.0}, {2u, 7.0}, {3u, 1.0}, {3u, 0.0}}) {
    const auto back = parse_value(kParameters[index], format_value(kParameters[index], value));
    ASSERT_TRUE(back.ok()) << back.error();
    EXPECT_EQ(*back, value);
  }
}

TEST(Parameters, NearestNameIsWithinThreeEdits) {
  const std::vector<std::string_view> names = {"astar", "dijkstra", "dstar-lite"};
  EXPECT_EQ(nearest_name("a-star", names), "astar");
  EXPECT_EQ(nearest_name("dstarlite", names), "dstar-lite");
  EXPECT_EQ(nearest_name("dijkstra", names), "dijkstra");
  EXPECT_EQ(nearest_name("rrt-connect", names), "");
  EXPECT_EQ(nearest_name("x", {}), "");
}

}  // namespace
}  // namespace replan::plan_parameters_test

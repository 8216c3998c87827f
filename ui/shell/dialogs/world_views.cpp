#include "ui/shell/dialogs/world_views.hpp"

#include <cmath>

namespace replan::ui {
namespace {

constexpr double kLongestSide = 4096;

}  // namespace

bool size_slider(const Look& look, const char* label, int initial, int& value) {
  double shown = value;
  const bool changed = slider(look,
                              {.label = label,
                               .min = 1,
                               .max = kLongestSide,
                               .initial = static_cast<double>(initial),
                               .unit = "cells",
                               .decimals = 0,
                               .logarithmic = true},
                              shown, {label, "", "Of the world, in cells."});
  value = static_cast<int>(shown);
  return changed;
}

bool layers_slider(const Look& look, int initial, int& layers) {
  double shown = layers;
  const bool changed = slider(look,
                              {.label = "Layers",
                               .min = 1,
                               .max = 512,
                               .initial = static_cast<double>(initial),
                               .decimals = 0,
                               .logarithmic = true},
                              shown, {"Layers", "", "How many lie one above the other; one is a plane."});
  layers = static_cast<int>(shown);
  return changed;
}

std::pair<ImVec2, ImVec2> fitted(ImVec2 origin, ImVec2 box, double width, double height) {
  const float scale = std::min(box.x / static_cast<float>(width), box.y / static_cast<float>(height));
  const float w = static_cast<float>(width) * scale, h = static_cast<float>(height) * scale;
  const ImVec2 min(std::floor(origin.x + (box.x - w) * 0.5f), std::floor(origin.y + (box.y - h) * 0.5f));
  return {min, {min.x + std::max(1.0f, w), min.y + std::max(1.0f, h)}};
}

float fitting_height(const Look& look, float wanted) {
  return std::min(look.px(wanted), std::max(ImGui::GetIO().DisplaySize.y - look.px(210), look.px(80)));
}

}  // namespace replan::ui

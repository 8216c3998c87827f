#include "app/gui_settings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/base/file.hpp"

namespace replan::app {
namespace {

using Json = nlohmann::json;

/// The number under `key` if it is one in range, else `fallback`.
double number(const Json& json, const char* key, double low, double high, double fallback) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return fallback;
  const double value = found->get<double>();
  return value >= low && value <= high ? value : fallback;
}

int whole(const Json& json, const char* key, int low, int high, int fallback) {
  return static_cast<int>(number(json, key, low, high, fallback));
}

bool flag(const Json& json, const char* key, bool fallback) {
  const auto found = json.find(key);
  return found != json.end() && found->is_boolean() ? found->get<bool>() : fallback;
}

/// By its id; files of older versions hold its number among the tabs that there were.
std::string tab(const Json& json) {
  constexpr std::array kNumbered = {"planner", "cell", "open_list", "code", "figures", "debug", "log"};
  const auto found = json.find("tab");
  if (found == json.end()) return "";
  if (found->is_string()) return found->get<std::string>();
  const int number = whole(json, "tab", 0, static_cast<int>(kNumbered.size()) - 1, -1);
  return number < 0 ? "" : kNumbered[static_cast<std::size_t>(number)];
}

/// By its id; one that there is not is the usual one.
ui::FieldColours colours(const Json& json) {
  const auto found = json.find("colours");
  if (found == json.end() || !found->is_string()) return ui::FieldColours::viridis;
  return ui::field_colours_named(found->get<std::string>()).value_or(ui::FieldColours::viridis);
}

/// Of a page; empty if it is none that could stand before a link.
std::string link_address(const Json& json) {
  constexpr std::size_t kLongest = 1000;
  const auto found = json.find("link_address");
  if (found == json.end() || !found->is_string()) return "";
  const auto address = found->get<std::string>();
  const bool sound = std::all_of(address.begin(), address.end(),
                                 [](char c) { return static_cast<unsigned char>(c) > ' ' && c != '#'; });
  return sound && address.size() <= kLongest ? address : "";
}

}  // namespace

std::string settings_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && config[0] == '/') return std::string(config) + "/replan/window.json";
  const char* home = std::getenv("HOME");
  return home == nullptr || home[0] == '\0' ? "" : std::string(home) + "/.config/replan/window.json";
}

Remembered read_settings(const std::string& path) {
  Remembered result;
  const Result<std::string> text =
      path.empty() ? Result<std::string>(Error{"no home"}) : read_file(path, 1 << 20);
  if (!text) return result;
  result.first_start = false;
  const Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object()) return result;
  result.window.width = whole(json, "width", 640, 16384, result.window.width);
  result.window.height = whole(json, "height", 480, 16384, result.window.height);
  result.window.maximized = flag(json, "maximized", false);
  result.size_step = whole(json, "size_step", ui::ViewState::kSmallest, ui::ViewState::kLargest, 0);
  result.large_targets = flag(json, "large_targets", false);
  result.dark = flag(json, "dark", true);
  result.panels = flag(json, "panels", true);
  result.legend = flag(json, "legend", true);
  result.colours_so_far = flag(json, "colours_so_far", false);
  result.metres = flag(json, "metres", true);
  result.minimap = flag(json, "minimap", true);
  result.colours = colours(json);
  result.brush = whole(json, "brush", 1, 64, 1);
  result.round_brush = whole(json, "round_brush", 0, 1, 0) != 0;
  result.tab = tab(json);
  result.side_width = static_cast<float>(number(json, "side_width", 340, 640, result.side_width));
  result.side_share = static_cast<float>(number(json, "side_share", 0.15, 0.7, result.side_share));
  result.caption = flag(json, "caption", true);
  result.unit = static_cast<StepUnit>(whole(json, "step_unit", 0, 4, static_cast<int>(result.unit)));
  result.speed = number(json, "speed", 0.1, Session::kFullSpeed, result.speed);
  result.link_address = link_address(json);
  return result;
}

Result<void> write_settings(const Remembered& settings, const std::string& path) {
  if (path.empty()) return {};
  std::error_code failed;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failed);
  if (failed) return Error{path + ": its folder cannot be made (" + failed.message() + ")"};
  const Json json = {{"width", settings.window.width},
                     {"height", settings.window.height},
                     {"maximized", settings.window.maximized},
                     {"size_step", settings.size_step},
                     {"large_targets", settings.large_targets},
                     {"dark", settings.dark},
                     {"panels", settings.panels},
                     {"legend", settings.legend},
                     {"colours_so_far", settings.colours_so_far},
                     {"metres", settings.metres},
                     {"minimap", settings.minimap},
                     {"colours", ui::info_of(settings.colours).id},
                     {"brush", settings.brush},
                     {"round_brush", settings.round_brush ? 1 : 0},
                     {"tab", settings.tab},
                     {"side_width", settings.side_width},
                     {"side_share", settings.side_share},
                     {"caption", settings.caption},
                     {"step_unit", static_cast<int>(settings.unit)},
                     {"speed", settings.speed},
                     {"link_address", settings.link_address}};
  return write_file_atomically(path, json.dump(2) + "\n");
}

}  // namespace replan::app

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>

#include <yaml-cpp/yaml.h>

#include "core/plan/parameters.hpp"
#include "core/world/formats/ros_map.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

constexpr std::string_view kKeys[] = {"image",           "resolution",  "origin", "negate",
                                      "occupied_thresh", "free_thresh", "mode"};

/// Reads the document's keys. The first error is kept; what follows is harmless.
class RosYamlReader {
 public:
  RosYamlReader(const YAML::Node& root, const std::string& origin) : root_(root), origin_(origin) {}

  Result<RosMapInfo> read() {
    if (!root_.IsMap())
      return Error{origin_ + ":1: not a map_server map: lines such as 'image: map.pgm' belong here"};
    check_keys();
    if (const auto node = require("image"); node && (info_.image = text(*node)).empty())
      fail(*node, "image", "must name a picture file");
    if (const auto node = require("resolution"))
      info_.resolution = number(*node, "resolution", kMinResolution, kMaxResolution);
    if (const auto node = require("origin")) read_origin(*node);
    if (const auto node = require("negate")) read_negate(*node);
    if (const auto node = require("occupied_thresh"))
      info_.occupied_thresh = number(*node, "occupied_thresh", 0, 1);
    if (const auto node = require("free_thresh")) info_.free_thresh = number(*node, "free_thresh", 0, 1);
    if (const auto node = find("mode")) read_mode(*node);
    if (error_.empty() && info_.free_thresh > info_.occupied_thresh)
      fail(*find("free_thresh"), "free_thresh", "must not be more than 'occupied_thresh'");
    if (!error_.empty()) return Error{error_};
    return std::move(info_);
  }

 private:
  void fail(const YAML::Node& node, const std::string& key, const std::string& what) {
    if (!error_.empty()) return;
    error_ = origin_ + ":" + std::to_string(line_of(node)) + ": '" + one_line(key) + "' " + what;
  }

  /// The line of a node, from 1. Where a key has no value, yaml-cpp marks whatever comes next: then the
  /// key's.
  [[nodiscard]] int line_of(const YAML::Node& node) const {
    int line = node.Mark().line;
    for (const auto& item : root_)
      if (node.IsNull() && item.second.is(node)) line = item.first.Mark().line;
    return std::max(0, line) + 1;
  }

  /// Each key of map_server at most once; others are noted.
  void check_keys() {
    std::vector<std::string> seen;
    for (const auto& item : root_) {
      const std::string key = text(item.first);
      if (std::find(seen.begin(), seen.end(), key) != seen.end()) fail(item.first, key, "is there twice");
      seen.push_back(key);
      if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys))
        info_.notes.push_back(origin_ + ":" + std::to_string(std::max(0, item.first.Mark().line) + 1) +
                              ": the key " + shown(key) + " is not one of map_server's and was passed over");
    }
  }

  std::optional<YAML::Node> find(std::string_view key) const {
    for (const auto& item : root_)
      if (text(item.first) == key) return item.second;
    return std::nullopt;
  }

  std::optional<YAML::Node> require(std::string_view key) {
    auto node = find(key);
    if (!node && error_.empty())
      error_ = origin_ + ": the key '" + std::string(key) + "' is missing" + meant(key);
    return node;
  }

  /// What was probably written instead of a key that is missing.
  std::string meant(std::string_view key) const {
    for (const auto& item : root_) {
      const std::string other = text(item.first);
      const bool known = std::find(std::begin(kKeys), std::end(kKeys), other) != std::end(kKeys);
      if (!known && nearest_name(other, {&key, 1}) == key) return "; is " + shown(other) + " a slip of it?";
    }
    return "";
  }

  static std::string text(const YAML::Node& node) { return node.IsScalar() ? node.Scalar() : std::string(); }

  double number(const YAML::Node& node, const std::string& key, double low, double high) {
    std::string_view word = node.IsScalar() ? std::string_view(node.Scalar()) : std::string_view();
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto value = number_from<double>(word);
    if (value && *value >= low && *value <= high) return *value;
    fail(node, key,
         "must be a number from " + plain_number(low).dump() + " to " + plain_number(high).dump() + ", not " +
             (node.IsScalar() ? shown(node.Scalar()) : std::string("a list or a group")));
    return low;
  }

  void read_origin(const YAML::Node& node) {
    if (!node.IsSequence() || node.size() != 3)
      return fail(node, "origin", "must be a pose [x, y, yaw] of three numbers");
    for (std::size_t i = 0; i < 3; ++i) info_.origin[i] = number(node[i], "origin", -kMaxOrigin, kMaxOrigin);
  }

  void read_negate(const YAML::Node& node) {
    const std::string word = text(node);
    info_.negate = word == "1";
    // yes, No, TRUE, off, y, ...
    if (word != "1" && word != "0" && !YAML::convert<bool>::decode(node, info_.negate))
      fail(node, "negate", "must be 0 or 1, yes or no, not " + shown(word));
  }

  void read_mode(const YAML::Node& node) {
    std::string word = text(node);
    for (char& c : word) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (word == "raw")
      return fail(node, "mode",
                  "is raw: such a picture holds costs, not obstacles; save the map as trinary or scale");
    if (word != "trinary" && word != "scale")
      fail(node, "mode", "must be trinary or scale, not " + shown(text(node)));
    info_.mode = word == "scale" ? RosMapInfo::Mode::scale : RosMapInfo::Mode::trinary;
  }

  YAML::Node root_;
  const std::string& origin_;
  RosMapInfo info_;
  std::string error_;
};

/// A text in quotes. Not by yaml-cpp, which replaces bytes that are no UTF-8: a file's name may hold any.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    const bool control = (c >= 0 && c < ' ') || c == '\x7F';
    if (control)
      result += code;
    else
      result += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return result + "\"";
}

}  // namespace

Result<RosMapInfo> parse_ros_yaml(std::string_view text, const std::string& origin) {
  // yaml-cpp reports by exceptions; none of them leaves this function.
  try {
    return RosYamlReader(YAML::Load(std::string(text)), origin).read();
  } catch (const YAML::Exception& failed) {
    return Error{origin + ":" + std::to_string(std::max(0, failed.mark.line) + 1) +
                 ": not YAML: " + one_line(failed.msg)};
  } catch (const std::exception& failed) {
    return Error{origin + ": not YAML that can be read: " + one_line(failed.what())};
  }
}

std::string ros_yaml_text(const RosMapInfo& info) {
  const auto number = [](double value) { return plain_number(value).dump(); };
  std::string text = "image: " + quoted(info.image) + "\n";
  text += std::string("mode: ") + (info.mode == RosMapInfo::Mode::scale ? "scale" : "trinary") + "\n";
  text += "resolution: " + number(info.resolution) + "\n";
  text += "origin: [" + number(info.origin[0]) + ", " + number(info.origin[1]) + ", " +
          number(info.origin[2]) + "]\n";
  text += std::string("negate: ") + (info.negate ? "1" : "0") + "\n";
  text += "occupied_thresh: " + number(info.occupied_thresh) + "\n";
  return text + "free_thresh: " + number(info.free_thresh) + "\n";
}

}  // namespace replan

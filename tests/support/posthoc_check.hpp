// Holds a search trace to the rules of Posthoc's format 1.4.0 and to the traps that its application has: a
// text that passes loads there, and draws what it says. The rules are spelt out here once more, from the
// format's side, so that the exporter cannot agree with itself.
#pragma once

#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <yaml-cpp/yaml.h>

namespace replan::test {

class PosthocCheck {
 public:
  /// Empty if the file is as it should be, else the first complaint.
  /// `anywhere`: plans may lead through any points.
  static std::string check(const std::string& name, const std::string& text, bool anywhere = false) {
    try {
      PosthocCheck checker(name.ends_with(".json"), anywhere);
      checker.file(name, text);
      return "";
    } catch (const Complaint& complaint) {
      return complaint.text;
    } catch (const YAML::Exception& error) {
      return std::string("no YAML: ") + error.what();
    }
  }

 private:
  struct Complaint {
    std::string text;
  };
  static void require(bool holds, const std::string& rule) {
    if (!holds) throw Complaint{rule};
  }

  PosthocCheck(bool json, bool anywhere) : json_(json), anywhere_(anywhere) {}

  void file(const std::string& name, const std::string& text) {
    const bool ending =
        name.ends_with(".trace.yaml") || name.ends_with(".trace.yml") || name.ends_with(".trace.json");
    require(ending, "the name must end in .trace.json, .trace.yaml or .trace.yml");
    const YAML::Node root = YAML::Load(text);
    require(root.IsMap(), "the root must be an object");
    for (const auto& entry : root) {
      static const std::set<std::string> kKeys = {"version", "views", "events", "pivot"};
      require(kKeys.contains(entry.first.Scalar()), "unknown key " + entry.first.Scalar());
    }
    require(root["version"] && root["version"].IsScalar() && root["version"].Scalar() == "1.4.0",
            "version must be the string 1.4.0");
    require(root["views"] && root["views"].IsMap(), "views are missing");
    require(root["events"] && root["events"].IsSequence(), "events are missing");
    views(root["views"]);
    require(root["pivot"] && root["pivot"]["x"] && root["pivot"]["y"] && root["pivot"]["scale"],
            "without a pivot the path to the root is not drawn");
    for (const char* key : {"x", "y"}) expression(root["pivot"][key]);
    for (const YAML::Node& event : root["events"]) one_event(event);
    require(plans_ > 0, "no plan was written");
  }

  // --- Views ---

  void views(const YAML::Node& all) {
    require(all["main"] && all["main"].IsSequence(), "the view main is the entry point");
    for (const auto& view : all) view_names_.insert(view.first.Scalar());
    for (const auto& view : all) {
      require(view.second.IsSequence(), "a view is a list of components");
      for (const YAML::Node& part : view.second) component(view.first.Scalar(), part);
    }
    for (const std::string& name : view_names_) no_circle(all, name, 0);
  }

  void no_circle(const YAML::Node& all, const std::string& name, int depth) {
    require(depth < 10, "the view " + name + " contains itself");
    for (const YAML::Node& part : all[name])
      if (const std::string what = part["$"].Scalar(); view_names_.contains(what))
        no_circle(all, what, depth + 1);
  }

  void component(const std::string& view, const YAML::Node& part) {
    static const std::map<std::string, std::set<std::string>> kPrimitives = {
        {"rect", {"x", "y", "width", "height", "fill"}},
        {"circle", {"x", "y", "radius", "fill"}},
        {"path", {"points", "fill"}},
        {"polygon", {"points", "fill"}}};
    require(part.IsMap() && part["$"], "a component of " + view + " names nothing to draw");
    const std::string what = part["$"].Scalar();
    const auto primitive = kPrimitives.find(what);
    require(primitive != kPrimitives.end() || view_names_.contains(what),
            "neither a primitive nor a view: " + what);
    if (primitive != kPrimitives.end())
      for (const std::string& key : primitive->second) require(bool(part[key]), what + " without " + key);
    const std::string guard = part["$if"] ? part["$if"].Scalar() : "";
    bool looks_up_colour = false;
    for (const auto& property : part) {
      if (property.first.Scalar() == "$info") {
        for (const auto& shown : property.second) expression(shown.second);
      } else if (property.second.IsScalar() && property.second.Scalar().find("{{") != std::string::npos) {
        expression(property.second);
        looks_up_colour |=
            property.first.Scalar() != "$if" && property.second.Scalar().find("color[") != std::string::npos;
      }
    }
    require(!looks_up_colour || guard.find("!!color[$.type]") != std::string::npos,
            "color[...] of an unknown type has no value: guard it with $if");
    if (guard.find("!!color[$.type]") != std::string::npos) draws_colours_ = true;
    drawn_type(part, guard);
  }

  /// Which types the component draws, and how long.
  void drawn_type(const YAML::Node& part, const std::string& guard) {
    std::smatch match;
    const bool one_type = std::regex_search(guard, match, std::regex(R"(\$\.type == '(\w+)')"));
    if (one_type) drawn_.insert(match[1]);
    const YAML::Node clear = part["clear"];
    if (!clear) return;
    require(clear.IsScalar(), "clear is true, false or a type");
    const std::string until = clear.Scalar();
    if (until == "true" || until == "false") return;
    require(one_type && match[1] == until && (until == "plan" || until == "move"),
            "clear by type is for the plan and the robot: on cells it costs quadratic time");
  }

  void expression(const YAML::Node& node) {
    const std::string text = node.Scalar();
    std::smatch match;
    require(std::regex_match(text, match, std::regex(R"(\$\{\{ (.*) \}\})")), "no lone expression: " + text);
    const std::string code = std::regex_replace(match[1].str(), std::regex("'[^']*'"), "''");
    static const std::set<std::string> kScope = {"$", "events", "step", "theme", "color", "undefined"};
    static const std::set<std::string> kTheme = {"foreground", "background", "accent"};
    static const std::set<std::string> kColors = {"source",     "destination", "updating", "expanding",
                                                  "generating", "closing",     "end"};
    const std::regex word(R"([.]?[A-Za-z_$][A-Za-z_0-9]*)");
    std::string before;
    for (std::sregex_iterator at(code.begin(), code.end(), word), end; at != end; ++at) {
      const std::string found = at->str();
      if (found[0] != '.') require(kScope.contains(found), "not in scope: " + found + " in " + text);
      if (before == "theme") require(kTheme.contains(found.substr(1)), "the theme has no " + found);
      if (before == "color" && found[0] == '.')
        require(kColors.contains(found.substr(1)), "no colour " + found);
      before = found;
    }
  }

  // --- Events ---

  void one_event(const YAML::Node& event) {
    static const std::set<std::string> kColoured = {"source",     "destination", "updating", "expanding",
                                                    "generating", "closing",     "end"};
    static const std::regex kNotText("[-+.0-9].*|null|true|false|~");
    require(event.IsMap(), "an event is an object");
    const std::string type = text_of(event, "type"), id = text_of(event, "id");
    require(drawn_.contains(type) || (draws_colours_ && kColoured.contains(type)),
            "nothing draws the type " + type);
    require(!std::regex_match(id, kNotText), "an id that could be read as a number: " + id);
    parent(event, id);
    ids_.insert(id);
    const double pass = number(event, "pass");
    require(pass == pass_ || (pass == pass_ + 1 && pass_ > 0) || (pass == 1 && pass_ == 0),
            "pass counts the plans");
    pass_ = pass;
    if (type == "plan") return plan(event, id);
    const double x = number(event, "x"), y = number(event, "y");
    require(x == std::floor(x) && y == std::floor(y) && x >= 0 && y >= 0, "x and y are a cell");
    if (type == "move") return require(id == "robot", "moves are about the robot");
    require(id == "c" + std::to_string(static_cast<int>(x)) + "_" + std::to_string(static_cast<int>(y)),
            "the id is the cell's: " + id);
    if (type == "block" || type == "unblock") return walls(type, id);
    if (event["f"]) values(event, type);
    const bool search =
        type == "updating" || type == "expanding" || type == "generating" || type == "closing";
    require(!search || event["f"], type + " without f");
  }

  static std::string text_of(const YAML::Node& event, const char* key) {
    require(event[key] && event[key].IsScalar() && !event[key].Scalar().empty(),
            std::string("an event without ") + key);
    return event[key].Scalar();
  }

  /// A number as YAML and JSON read it; infinity is `.inf` in YAML and null in JSON.
  double number(const YAML::Node& event, const char* key) const {
    const YAML::Node value = event[key];
    require(bool(value), std::string("an event without ") + key);
    if (json_ && value.IsNull()) return HUGE_VAL;
    require(value.IsScalar(), std::string(key) + " is no number");
    static const std::regex kNumber(R"(-?\d+(\.\d+)?)");
    const std::string text = value.Scalar();
    if (!json_ && text == ".inf") return HUGE_VAL;
    require(std::regex_match(text, kNumber) && value.Tag() != "!",
            std::string(key) + " would be read as text: " + text);
    return std::stod(text);
  }

  void parent(const YAML::Node& event, const std::string& id) {
    const YAML::Node given = event["pId"];
    if (!given) return;
    std::string& held = parents_[id];
    if (given.IsNull())
      return require(held.empty() || held == "none", "null does not forget the parent of " + id);
    const std::string to = given.Scalar();
    require(to != "0", "a parent 0 is none at all");
    require(to != id, "its own parent: " + id);
    require(to == "none" || ids_.contains(to), "the parent " + to + " has no earlier event");
    held = to;
    std::size_t steps = 0;
    for (std::string at = id; !at.empty() && at != "none"; at = parents_.contains(at) ? parents_[at] : "")
      require(++steps <= parents_.size() + 1, "the parents of " + id + " lead in a circle");
  }

  void values(const YAML::Node& event, const std::string& type) {
    const double f = number(event, "f"), g = number(event, "g");
    if (!event["rhs"]) return;
    const double rhs = number(event, "rhs"), k1 = number(event, "k1"), k2 = number(event, "k2");
    number(event, "km");
    require(f == k1, "f is k1");
    require(k2 == std::min(g, rhs), "k2 is the smaller of g and rhs");
    if (type == "expanding") require(g == rhs, "an expanded cell is consistent");
    if (type == "updating") require(std::isinf(g), "a raised cell has no g");
  }

  void walls(const std::string& type, const std::string& id) {
    const bool blocks = type == "block";
    require(!walls_.contains(id) || walls_[id] != blocks, "twice the same: " + type + " " + id);
    walls_[id] = blocks;
  }

  void plan(const YAML::Node& event, const std::string& id) {
    require(id == "plan", "plans have one id, so that one takes the place of the other");
    require(event["points"] && event["points"].IsSequence(), "a plan without points");
    for (const YAML::Node& point : event["points"]) {
      const double x = number(point, "x"), y = number(point, "y");
      const bool corner = x == std::floor(x) && y == std::floor(y);
      require(anywhere_ || corner || x - std::floor(x) == 0.5 || y - std::floor(y) == 0.5,
              "the points are centres or corners of cells, or lie between two centres");
    }
    ++plans_;
  }

  bool json_, anywhere_;
  bool draws_colours_ = false;
  std::set<std::string> view_names_, drawn_, ids_;
  std::map<std::string, std::string> parents_;
  std::map<std::string, bool> walls_;
  double pass_ = 0;
  int plans_ = 0;
};

}  // namespace replan::test

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/base64.hpp"
#include "core/lattice/box_words.hpp"
#include "core/link/deflate.hpp"
#include "core/link/link.hpp"
#include "core/link/link_limits.hpp"
#include "core/link/link_words.hpp"
#include "core/plan/parameters.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

constexpr std::size_t kMostPanes = 4;
constexpr double kFarthest = 1e6;                         // cells, of a camera and an eye
constexpr double kLeastZoom = 0.001, kMostZoom = 10'000;  // pixels per cell

/// The words between commas.
std::vector<std::string_view> comma_parts(std::string_view list) {
  std::vector<std::string_view> parts;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    parts.push_back(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return parts;
}

/// The text of a link alone, from behind its # on: without what mail programs put around it and into it.
std::string bare_link(std::string_view text) {
  std::string bare;
  const std::size_t hash = text.find('#');
  for (const char c : text.substr(hash == std::string_view::npos ? text.size() : hash + 1))
    if (static_cast<unsigned char>(c) > ' ' && c != '<' && c != '>' && c != '"' && c != '\x7F') bare += c;
  return bare;
}

/// Each part between two &; a page's source has &amp; for it.
template <class Visit>
void each_part(std::string_view bare, const Visit& visit) {
  while (!bare.empty()) {
    const std::size_t end = std::min(bare.find('&'), bare.size());
    std::string_view part = bare.substr(0, end);
    bare.remove_prefix(std::min(end + 1, bare.size()));
    if (part.starts_with("amp;")) part.remove_prefix(4);
    if (!part.empty()) visit(part);
  }
}

/// With %2C and the like made letters again, as browsers and mail programs write some of them.
std::optional<std::string> percent_decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    unsigned code = 0;
    const char* digits = text.data() + i + 1;
    if (text.size() - i < 3 || std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2)
      return std::nullopt;
    plain += static_cast<char>(static_cast<unsigned char>(code));
    i += 2;
  }
  return plain;
}

/// Reads one link. The first error is kept, and each step after it is harmless.
class LinkReader {
 public:
  Result<Link> read(std::string_view text) {
    take_apart(bare_link(text));
    if (error_.empty()) check_link_version();
    if (error_.empty()) read_world();
    if (error_.empty()) read_link_panes();
    if (error_.empty()) read_moment();
    if (error_.empty()) read_look();
    if (error_.empty() && link_.scenario.map.box().solid()) read_solid_look();
    if (!error_.empty()) return Error{"the link: " + error_};
    return std::move(link_);
  }

 private:
  void fail(std::string sentence) {
    if (error_.empty()) error_ = one_line(std::move(sentence));
  }
  void refuse(std::string_view name, std::string_view value, const std::string& wanted) {
    fail("'" + std::string(name) + "' cannot be " + shown(value) + ": give " + wanted);
  }
  [[nodiscard]] const std::string* find(std::string_view name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] Box box() const { return link_.scenario.map.box(); }

  void take_apart(const std::string& bare) {
    each_part(bare, [this](std::string_view part) {
      const std::size_t sign = part.find('=');
      const std::string name(part.substr(0, sign));
      if (std::find(kLinkKeys.begin(), kLinkKeys.end(), name) == kLinkKeys.end()) return note_unknown(name);
      const auto value = percent_decoded(sign == std::string_view::npos ? "" : part.substr(sign + 1));
      if (!value)
        return fail("the value of '" + name + "' has a % that no two digits follow: copy the link again");
      if (!values_.emplace(name, *value).second) fail("it says '" + name + "' twice: leave one of them out");
    });
  }

  /// What another version would know, or a slip: of no matter to the run, else the version would be another.
  void note_unknown(const std::string& name) {
    constexpr std::size_t kMostNotes = 8;
    if (link_.notes.size() >= kMostNotes) return;
    const std::string_view nearest = nearest_name(name, kLinkKeys);
    link_.notes.push_back("the link says " + shown(name) +
                          ", which this version of Replan does not know, and it was left out" +
                          (nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?"));
  }

  void check_link_version() {
    const std::string* text = find(link_key::version);
    if (text == nullptr)
      return fail("'v=1' is missing, the version of its format: copy the whole link again");
    const auto version = number_from<std::uint64_t>(*text);
    if (!version || *version == 0) return refuse(link_key::version, *text, "1, the version of the format");
    if (*version > static_cast<std::uint64_t>(kLinkVersion))
      fail("it is of version " + *text + ", and this Replan reads version " + std::to_string(kLinkVersion) +
           ": open it with a newer Replan");
  }

  void read_world() {
    const std::string* text = find(link_key::world);
    if (text == nullptr || text->empty())
      return fail("its world is missing: copy the whole link again, up to the end of 'world='");
    const auto stream = from_base64url(*text);
    if (!stream) return fail("its world is damaged or cut off: copy the whole of it again");
    const auto world = inflated(*stream, kMostWorldBytes);
    if (!world) return fail("its world " + world.error());
    if (json_values_at_most(*world) > kMostWorldValues)
      return fail("its world has more than " + std::to_string(kMostWorldValues) +
                  " values, the most that a link may have");
    Result<Scenario> scenario = parse_scenario(*world, "world", kNoFolder);
    if (!scenario) return fail(scenario.error());
    if (static_cast<std::int64_t>(scenario->map.blocked.size()) > kMaxLinkCells)
      return fail("its world has " + std::to_string(scenario->map.blocked.size()) +
                  " cells, and a link may have at most " + std::to_string(kMaxLinkCells));
    link_.scenario = std::move(scenario.value());
  }

  /// A number of a pane, from 1, that is one of so many; counted from 0.
  std::optional<std::size_t> pane_of(std::string_view name, std::string_view text, std::size_t panes) {
    const auto number = number_from<std::size_t>(text);
    if (number && *number >= 1 && *number <= panes) return *number - 1;
    refuse(name, text, "a number of a pane, from 1 to " + std::to_string(panes));
    return std::nullopt;
  }

  void read_link_panes() {
    std::vector<PlannerChoice>& planners = link_.scenario.planners;
    if (const std::string* text = find(link_key::panes))
      if (const auto last = pane_of(link_key::panes, *text, planners.size())) planners.resize(*last + 1);
    if (const std::string* text = find(link_key::lead))
      link_.view.lead = pane_of(link_key::lead, *text, planners.size()).value_or(0);
  }

  void read_moment() {
    LinkView& view = link_.view;
    if (const std::string* text = find(link_key::at)) {
      const auto event = number_from<std::uint64_t>(*text);
      if (!event || *event > kMostEvents)
        return refuse(link_key::at, *text, "a number of events, from 0 to " + std::to_string(kMostEvents));
      view.event = static_cast<std::size_t>(*event);
    }
    if (const std::string* text = find(link_key::log)) {
      std::uint32_t hash = 0;
      const char* end = text->data() + text->size();
      if (text->size() != 8 || std::from_chars(text->data(), end, hash, 16).ptr != end)
        return refuse(link_key::log, *text, "the 8 digits that it was copied with, or leave it out");
      view.log = hash;
    }
    if (const std::string* text = find(link_key::lockstep)) {
      constexpr auto kNames = lockstep_names();
      const auto found = std::find(kNames.begin(), kNames.end(), *text);
      if (found == kNames.end()) return refuse(link_key::lockstep, *text, "expansions, moves or race");
      view.lockstep = static_cast<Lockstep>(found - kNames.begin());
    }
  }

  void read_look() {
    LinkView& view = link_.view;
    if (const std::string* text = find(link_key::theme)) {
      if (*text != "dark" && *text != "light") return refuse(link_key::theme, *text, "dark or light");
      view.dark = *text == "dark";
    }
    if (const std::string* text = find(link_key::overlays)) read_overlays(*text);
    if (const std::string* text = find(link_key::tab)) view.tab = *text;
    if (const std::string* text = find(link_key::pin)) read_pin(*text);
    const std::string* text = find(link_key::camera);
    if (text == nullptr) return;
    const auto numbers = numbers_of(*text);
    if (numbers.size() != 3 || numbers[2] < kLeastZoom || numbers[2] > kMostZoom)
      return refuse(link_key::camera, *text,
                    "X,Y,ZOOM, the point in the middle in cells and the pixels of a cell, such as 12,8.5,48");
    view.camera = ViewSetup::Camera{numbers[0], numbers[1], numbers[2]};
  }

  void read_overlays(const std::string& text) {
    OverlaySet set;
    for (const std::string_view id : comma_parts(text)) {
      const auto known = overlays();
      const auto found =
          std::find_if(known.begin(), known.end(), [&](const OverlayInfo& info) { return info.id == id; });
      if (found != known.end())
        set.set(found->overlay, true);
      else
        link_.notes.push_back("the link shows the overlay " + shown(id) +
                              ", which this version of Replan does not know, and it was left out");
    }
    constexpr std::size_t kMostNotes = 16;
    if (link_.notes.size() > kMostNotes) link_.notes.resize(kMostNotes);
    link_.view.overlays = set;
  }

  void read_pin(const std::string& text) {
    const bool solid = box().solid();
    std::vector<int> numbers;
    for (const std::string_view part : comma_parts(text))
      if (const auto number = number_from<int>(part)) numbers.push_back(*number);
    const bool counts = numbers.size() == (solid ? 3u : 2u) && comma_parts(text).size() == numbers.size();
    const Cell cell = counts ? Cell{numbers[0], numbers[1], solid ? numbers[2] : 0} : Cell{-1, -1, -1};
    if (!box().contains(cell))
      return refuse(link_key::pin, text,
                    std::string(solid ? "X,Y,Z" : "X,Y") + ", a cell in the world of " + size_text(box()));
    link_.view.pin = cell;
  }

  /// All numbers of a list; none if one of them is none, or out of all proportion.
  static std::vector<double> numbers_of(std::string_view list) {
    std::vector<double> numbers;
    for (const std::string_view part : comma_parts(list)) {
      const auto number = number_from<double>(part);
      if (!number || !(std::abs(*number) <= kFarthest)) return {};
      numbers.push_back(*number);
    }
    return numbers;
  }

  void read_solid_look() {
    if (const std::string* text = find(link_key::slice)) read_slices(*text);
    if (const std::string* text = find(link_key::orbit)) read_link_orbit(*text);
    if (const std::string* text = find(link_key::orbits))
      for (const std::string_view part : comma_parts(*text))
        if (const auto pane = pane_of(link_key::orbits, part, kMostPanes);
            pane && link_.view.orbits.size() < kMostPanes)
          link_.view.orbits.push_back(*pane);
    if (const std::string* text = find(link_key::solid))
      for (const std::string_view part : comma_parts(*text)) {
        if (part != "cut" && part != "glass")
          return refuse(link_key::solid, *text, "cut, glass, or both with a comma");
        (part == "cut" ? link_.view.cut : link_.view.glass) = true;
      }
  }

  void read_slices(const std::string& text) {
    link_.view.follows_robot = text == "robot";
    if (link_.view.follows_robot) return;
    const std::vector<std::string_view> parts = comma_parts(text);
    for (const std::string_view part : parts) {
      const std::size_t axis =
          part.empty() ? std::string_view::npos : std::string_view("xyz").find(part.front());
      const Axis along = axis == std::string_view::npos ? Axis::z : static_cast<Axis>(axis);
      const auto layer = number_from<int>(axis == std::string_view::npos ? part : part.substr(1));
      if (!layer || *layer < 0 || *layer >= SeenBox(box(), along).depth() || parts.size() > kMostPanes)
        return refuse(link_key::slice, text,
                      "an axis and a layer of the world for each pane, such as z3,x12, or robot");
      link_.view.slices.push_back({along, *layer});
    }
  }

  void read_link_orbit(const std::string& text) {
    const auto numbers = numbers_of(text);
    if ((numbers.size() != 2 && numbers.size() != 6) || std::abs(numbers[1]) > 89 ||
        (numbers.size() == 6 && numbers[2] <= 0))
      return refuse(
          link_key::orbit, text,
          "YAW,PITCH in degrees, the pitch at most 89, and DISTANCE,X,Y,Z in cells if not all of the world "
          "is shown");
    const double degree = std::numbers::pi / 180;
    Orbit orbit{numbers[0] * degree, numbers[1] * degree, 0, {}};
    if (numbers.size() == 6) {
      orbit.distance = numbers[2];
      orbit.focus = {numbers[3], numbers[4], numbers[5]};
    }
    link_.view.orbit = orbit;
  }

  static constexpr std::uint64_t kMostEvents = std::uint64_t{1} << 40;

  std::map<std::string, std::string, std::less<>> values_;
  Link link_;
  std::string error_;
};

}  // namespace

bool is_link(std::string_view text) {
  if (text.size() > kLongestLink + kMostLinkWords) text = text.substr(0, kMostLinkWords);
  // Of a world in letters some are # too.
  bool version = false, more = false;
  const std::string bare = bare_link(text);
  each_part(bare, [&](std::string_view part) {
    const std::string_view name = part.substr(0, std::min(part.find('='), part.size()));
    const bool known = std::find(kLinkKeys.begin(), kLinkKeys.end(), name) != kLinkKeys.end();
    (name == link_key::version ? version : more) |= known && name.size() < part.size();
  });
  return version && more;
}

Result<Link> parse_link(std::string_view text) {
  if (text.size() > kLongestLink + kMostLinkWords)
    return Error{"the link: it has " + std::to_string(text.size()) + " characters, and a link has at most " +
                 std::to_string(kLongestLink) + ": save the world as a file instead"};
  return LinkReader().read(text);
}

}  // namespace replan

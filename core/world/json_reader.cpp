#include "core/world/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/plan/parameters.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan {
namespace {

// No format of ours comes near these; a file that exceeds them would only cost time or stack.
constexpr std::size_t kMaxDepth = 32;
constexpr std::size_t kMaxKeys = 256;
constexpr std::size_t kLongestMessage = 200;
constexpr std::size_t kShownText = 100;

/// Where the parser stands: it reads through an iterator that counts lines on the way.
struct Place {
  int line = 1;
  bool line_ended = false;  // the newline read last still belongs to its line
};

class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Place* place) : at_(at), place_(place) {}
  const char& operator*() const { return *at_; }
  CountingIterator& operator++() {
    place_->line += place_->line_ended ? 1 : 0;
    place_->line_ended = *at_++ == '\n';
    return *this;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  Place* place_;
};

/// Thrown out of the JSON library's parser and caught around it: there is no other way to stop it.
struct Refused {
  std::string why;
};

/// Notes the line of each value and refuses what the library would take without a word.
class Watcher {
 public:
  Watcher(const Place& place, std::vector<int>& lines) : place_(place), lines_(lines) {}

  void operator()(Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::key) return note_key(parsed.get_ref<const std::string&>());
    if (event == Event::object_end || event == Event::array_end) return open_.pop_back();
    lines_.push_back(place_.line);
    if (event == Event::value) return;
    if (open_.size() == kMaxDepth) throw Refused{"the document is nested too deeply"};
    open_.emplace_back();
  }

 private:
  void note_key(const std::string& key) {
    std::vector<std::string>& keys = open_.back();
    if (std::find(keys.begin(), keys.end(), key) != keys.end())
      throw Refused{"the key " + replan::shown(key) + " is given twice"};
    if (keys.size() == kMaxKeys) throw Refused{"the object has too many keys"};
    keys.push_back(key);
  }

  const Place& place_;
  std::vector<int>& lines_;
  std::vector<std::vector<std::string>> open_;  // the keys of each open object; none for a list
};

/// "LINE:COLUMN: reason" out of the JSON library's message, which says all of it in its own words.
std::string syntax_error(const std::string& message) {
  int line = 0, column = 0;
  const std::size_t at = message.find("at line ");
  const std::size_t reason = at == std::string::npos ? at : message.find(": ", at);
  if (reason == std::string::npos ||
      std::sscanf(message.c_str() + at, "at line %d, column %d", &line, &column) != 2)
    return "1: not JSON: " + message.substr(0, kLongestMessage);
  return std::to_string(line) + ":" + std::to_string(column) +
         ": not JSON: " + message.substr(reason + 2, kLongestMessage);
}

/// Finds a value in a document: how many values stand before it in the text, and its path ("planners[0].id").
class Finder {
 public:
  explicit Finder(const Json& target) : target_(target) {}

  bool find(const Json& value, const std::string& path) {
    if (&value == &target_) {
      path_ = path;
      return true;
    }
    ++before_;
    if (value.is_object())
      for (auto child = value.begin(); child != value.end(); ++child)
        if (find(*child, path.empty() ? child.key() : path + "." + child.key())) return true;
    if (value.is_array())
      for (std::size_t i = 0; i < value.size(); ++i)
        if (find(value[i], path + "[" + std::to_string(i) + "]")) return true;
    return false;
  }
  [[nodiscard]] std::size_t before() const { return before_; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  const Json& target_;
  std::size_t before_ = 0;
  std::string path_;
};

std::string listed(std::initializer_list<std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

}  // namespace

bool JsonReader::parse(std::string_view text) {
  Place place;
  Watcher watcher(place, lines_);
  try {
    document_ = Json::parse(CountingIterator(text.data(), &place),
                            CountingIterator(text.data() + text.size(), &place),
                            [&](int /*depth*/, Json::parse_event_t event, Json& parsed) {
                              watcher(event, parsed);
                              return true;
                            });
  } catch (const Json::parse_error& error) {
    error_ = origin_ + ":" + syntax_error(error.what());
  } catch (const Json::exception&) {
    error_ = origin_ + ":" + std::to_string(place.line) + ": a number is too large for any use";
  } catch (const Refused& refused) {
    error_ = origin_ + ":" + std::to_string(place.line) + ": " + refused.why;
  }
  return ok();
}

JsonNode JsonReader::root() {
  return {*this, document_};
}

void JsonReader::fail(const Json& value, const std::string& what) {
  if (!ok()) return;
  Finder finder(value);
  const bool found = finder.find(document_, "");
  error_ = origin_ + ":" + std::to_string(found ? lines_[finder.before()] : 1) + ": " +
           (finder.path().empty() ? "" : one_line(finder.path()) + ": ") + what;
}

bool JsonNode::expect_object(std::initializer_list<std::string_view> known) const {
  if (!value_->is_object()) {
    fail("must be an object {...}, not " + shown());
    return false;
  }
  for (auto child = value_->begin(); child != value_->end(); ++child) {
    if (std::find(known.begin(), known.end(), child.key()) != known.end()) continue;
    const std::string_view nearest = nearest_name(child.key(), std::vector<std::string_view>(known));
    reader_->fail(*child,
                  "unknown key; " + (nearest.empty() ? "known here: " + listed(known)
                                                     : "did you mean '" + std::string(nearest) + "'?"));
    return false;
  }
  return true;
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  if (!value_->is_object()) return std::nullopt;
  const auto found = value_->find(std::string(key));
  if (found == value_->end()) return std::nullopt;
  return JsonNode(*reader_, *found);
}

std::optional<JsonNode> JsonNode::require(std::string_view key) const {
  std::optional<JsonNode> child = find(key);
  if (!child) fail("the key '" + std::string(key) + "' is missing");
  return child;
}

std::vector<JsonNode> JsonNode::items(std::size_t fewest, std::size_t most, const char* what) const {
  if (!value_->is_array() || value_->size() < fewest || value_->size() > most) {
    fail("must be " + std::string(what) + ", not " + shown());
    return {};
  }
  std::vector<JsonNode> nodes;
  nodes.reserve(value_->size());
  for (const Json& element : *value_) nodes.emplace_back(*reader_, element);
  return nodes;
}

std::string JsonNode::text() const {
  if (value_->is_string()) return value_->get<std::string>();
  fail("must be a text in quotes, not " + shown());
  return {};
}

bool JsonNode::toggle() const {
  if (value_->is_boolean()) return value_->get<bool>();
  fail("must be true or false, not " + shown());
  return false;
}

std::int64_t JsonNode::whole(std::int64_t low, std::int64_t high) const {
  std::optional<std::int64_t> result;
  if (value_->is_number_unsigned()) {
    const auto given = value_->get<std::uint64_t>();
    if (given <= static_cast<std::uint64_t>(INT64_MAX)) result = static_cast<std::int64_t>(given);
  } else if (value_->is_number_integer()) {
    result = value_->get<std::int64_t>();
  } else if (value_->is_number_float()) {  // 12.0 is a whole number, too
    const double given = value_->get<double>();
    if (given == std::floor(given) && std::abs(given) < 0x1p53) result = static_cast<std::int64_t>(given);
  }
  if (result && *result >= low && *result <= high) return *result;
  fail("must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) + ", not " +
       shown());
  return low;
}

double JsonNode::number(double low, double high) const {
  if (value_->is_number()) {
    const double given = value_->get<double>();
    if (given >= low && given <= high) return given;
  }
  fail("must be a number from " + plain_number(low).dump() + " to " + plain_number(high).dump() + ", not " +
       shown());
  return low;
}

std::size_t JsonNode::one_of(std::initializer_list<std::string_view> names) const {
  if (value_->is_string()) {
    const auto found = std::find(names.begin(), names.end(), value_->get_ref<const std::string&>());
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  }
  fail("must be one of: " + listed(names) + "; not " + shown());
  return 0;
}

std::string JsonNode::shown() const {
  if (value_->is_object()) return "an object";
  if (value_->is_array()) return "a list of " + std::to_string(value_->size());
  const std::string text = value_->dump();
  return text.size() <= kShownText ? text : text.substr(0, kShownText) + "...";
}

}  // namespace replan

// Reads JSON documents whose every key and value is checked. Errors name file, line, place in the document
// and mend. Only for source files of core: what uses it shows no JSON types in its own header.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace replan {

/// Keeps the order of keys, so that the place of a value can be found again by counting.
using Json = nlohmann::ordered_json;

class JsonNode;

/// One document being read. The first error is kept; reading goes on with default values and reports nothing
/// more, so that callers check once, at the end.
class JsonReader {
 public:
  explicit JsonReader(std::string origin) : origin_(std::move(origin)) {}

  /// Parses the text. False on a syntax error, on an object with the same key twice and beyond any sane
  /// nesting.
  bool parse(std::string_view text);
  [[nodiscard]] JsonNode root();
  [[nodiscard]] bool ok() const { return error_.empty(); }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Records that `value`, a part of the document, is wrong.
  void fail(const Json& value, const std::string& what);

 private:
  std::string origin_;
  std::string error_;
  Json document_;
  std::vector<int> lines_;  // on which the values begin, in the order of the text
};

/// A value in a document.
class JsonNode {
 public:
  JsonNode(JsonReader& reader, const Json& value) : reader_(&reader), value_(&value) {}

  [[nodiscard]] const Json& value() const { return *value_; }
  void fail(const std::string& what) const { reader_->fail(*value_, what); }

  /// Checks that this is an object without other keys than `known`; an unknown one is reported with a
  /// suggestion.
  bool expect_object(std::initializer_list<std::string_view> known) const;
  /// The value under a key, if it is there.
  [[nodiscard]] std::optional<JsonNode> find(std::string_view key) const;
  /// The value under a key; if it is missing that is an error, and nothing.
  [[nodiscard]] std::optional<JsonNode> require(std::string_view key) const;
  /// The elements of a list; anything else, or fewer or more elements, is an error and none.
  [[nodiscard]] std::vector<JsonNode> items(std::size_t fewest, std::size_t most, const char* what) const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool toggle() const;
  [[nodiscard]] std::int64_t whole(std::int64_t low, std::int64_t high) const;
  [[nodiscard]] double number(double low, double high) const;
  /// The index of the value among `names`.
  [[nodiscard]] std::size_t one_of(std::initializer_list<std::string_view> names) const;
  /// The value as a user sees it: short, on one line.
  [[nodiscard]] std::string shown() const;

 private:
  JsonReader* reader_;
  const Json* value_;
};

/// The document as text of at most about 100 columns: what fits stands on one line.
std::string pretty_json(const Json& document);
/// A number without needless digits: whole ones without a point.
Json plain_number(double value);

}  // namespace replan

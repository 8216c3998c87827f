// A small JSON Schema validator: the keywords that our own schemas use, and a refusal of any other, so that a
// schema cannot say something that goes unchecked.
#pragma once

#include <regex>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

namespace replan::test {

using SchemaJson = nlohmann::json;

class SchemaCheck {
 public:
  explicit SchemaCheck(const SchemaJson& root) : root_(root) {}

  /// Empty if `value` is as the schema says, else the first complaint.
  std::string check(const SchemaJson& value) const { return check(value, root_, "$"); }

  /// The schema that a `$ref` stands for, or the schema itself.
  const SchemaJson& resolve(const SchemaJson& schema) const {
    if (!schema.contains("$ref")) return schema;
    return root_.at(SchemaJson::json_pointer(schema.at("$ref").get<std::string>().substr(1)));
  }

 private:
  std::string check(const SchemaJson& value, const SchemaJson& given, const std::string& at) const {
    const SchemaJson& schema = resolve(given);
    for (const auto& [keyword, rule] : schema.items()) {
      std::string complaint = keyword_holds(value, schema, keyword, rule, at);
      if (!complaint.empty()) return complaint;
    }
    return {};
  }

  std::string keyword_holds(const SchemaJson& value, const SchemaJson& schema, const std::string& keyword,
                            const SchemaJson& rule, const std::string& at) const {
    static const std::set<std::string> kSilent = {"$schema", "$defs", "title", "description", "default"};
    if (kSilent.contains(keyword)) return {};
    const auto verdict = [&](bool holds) {
      return holds ? std::string() : at + ": breaks '" + keyword + "'";
    };
    if (keyword == "type") return verdict(type_holds(value, rule));
    if (keyword == "const") return verdict(value == rule);
    if (keyword == "enum") return verdict(std::find(rule.begin(), rule.end(), value) != rule.end());
    if (keyword == "minimum") return verdict(!value.is_number() || value >= rule);
    if (keyword == "maximum") return verdict(!value.is_number() || value <= rule);
    if (keyword == "minItems") return verdict(!value.is_array() || value.size() >= rule);
    if (keyword == "maxItems") return verdict(!value.is_array() || value.size() <= rule);
    if (keyword == "minLength") return verdict(!value.is_string() || value.get<std::string>().size() >= rule);
    if (keyword == "pattern")
      return verdict(!value.is_string() ||
                     std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())));
    if (keyword == "required") return verdict(has_all(value, rule));
    if (keyword == "dependentRequired") {
      for (const auto& [key, others] : rule.items())
        if (value.contains(key) && !has_all(value, others)) return verdict(false);
      return {};
    }
    if (keyword == "oneOf") return verdict(matches(value, rule, at) == 1);
    if (keyword == "anyOf") return verdict(matches(value, rule, at) >= 1);
    if (keyword == "items") return items_hold(value, rule, at);
    if (keyword == "properties" || keyword == "additionalProperties")
      return properties_hold(value, schema, at);
    return at + ": the validator does not know the keyword '" + keyword + "'";
  }

  static bool type_holds(const SchemaJson& value, const SchemaJson& rule) {
    if (rule.is_array())
      return std::any_of(rule.begin(), rule.end(), [&](const auto& r) { return type_holds(value, r); });
    const auto type = rule.get<std::string>();
    return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
           (type == "null" && value.is_null()) || (type == "string" && value.is_string()) ||
           (type == "boolean" && value.is_boolean()) || (type == "number" && value.is_number()) ||
           (type == "integer" && value.is_number_integer());
  }

  static bool has_all(const SchemaJson& value, const SchemaJson& keys) {
    return !value.is_object() || std::all_of(keys.begin(), keys.end(), [&](const auto& k) {
      return value.contains(k.template get<std::string>());
    });
  }

  std::ptrdiff_t matches(const SchemaJson& value, const SchemaJson& choices, const std::string& at) const {
    return std::count_if(choices.begin(), choices.end(),
                         [&](const auto& c) { return check(value, c, at).empty(); });
  }

  std::string items_hold(const SchemaJson& value, const SchemaJson& rule, const std::string& at) const {
    if (!value.is_array()) return {};
    for (std::size_t i = 0; i < value.size(); ++i)
      if (std::string complaint = check(value[i], rule, at + "[" + std::to_string(i) + "]");
          !complaint.empty())
        return complaint;
    return {};
  }

  std::string properties_hold(const SchemaJson& value, const SchemaJson& schema,
                              const std::string& at) const {
    if (!value.is_object()) return {};
    const SchemaJson none = SchemaJson::object();
    const SchemaJson& properties = schema.contains("properties") ? schema["properties"] : none;
    for (const auto& [key, part] : value.items()) {
      const std::string there = at + "." + key;
      const bool declared = properties.contains(key);
      if (!declared && schema.value("additionalProperties", SchemaJson(true)) == false)
        return there + ": the key is not in the schema";
      if (!declared && !schema.value("additionalProperties", SchemaJson(true)).is_object()) continue;
      const SchemaJson& rule = declared ? properties[key] : schema["additionalProperties"];
      if (std::string complaint = check(part, rule, there); !complaint.empty()) return complaint;
    }
    return {};
  }

  const SchemaJson& root_;
};

}  // namespace replan::test

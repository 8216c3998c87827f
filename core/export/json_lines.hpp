// The log as JSON Lines (.jsonl): the run on the first line, then an object per event, with names and costs
// in cells. What it says is enough to build every state of the run anew. assets/trace.schema.json describes a
// line.
#pragma once

#include "core/export/trace_file.hpp"

namespace replan {

/// The `version` of the first line.
inline constexpr int kTraceVersion = 1;

class JsonLines final : public TraceEncoder {
 public:
  explicit JsonLines(const TraceRun& run);

  [[nodiscard]] std::size_t head_parts() const override;
  void head(std::string& out, std::size_t part) override;
  void event(std::string& out, std::size_t index, const Event& event, const SearchState& state) override;
  void tail(std::string& out, const SearchState& state) override;

 private:
  [[nodiscard]] std::size_t rows() const;
  void opening(std::string& out) const;
  void row(std::string& out, std::size_t row, bool known) const;
  void moving(std::string& out) const;
  void cell(std::string& out, NodeId node) const;
  void scalar(std::string& out, Scalar which, std::uint64_t raw) const;
  void value(std::string& out, const Event& event, std::uint64_t raw) const;
  void payload(std::string& out, const Event& event) const;
  [[nodiscard]] FieldTable table_of(EventKind kind) const;
  void subject(std::string& out, const Event& event) const;
  static void numbered(std::string& out, std::uint64_t held);

  const TraceRun& run_;
  SearchState initial_;
  std::size_t events_;  // when it began
};

}  // namespace replan

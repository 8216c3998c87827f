#include "core/trace/packed_events.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace replan {
namespace {

/// What is foretold of the next event. Packing and unpacking keep the same one.
class Forecast {
 public:
  /// Deltas of nodes that are kept: a power of two.
  static constexpr std::size_t kNodes = 4096;

  [[nodiscard]] NodeId node() const { return node_; }
  [[nodiscard]] std::uint64_t delta_of_node(NodeId node) const { return of_node_[node % kNodes]; }
  [[nodiscard]] std::uint64_t delta_of_kind(EventKind kind) const {
    return of_kind_[static_cast<std::size_t>(kind)];
  }
  void learn(const Event& event) {
    node_ = event.node;
    of_node_[event.node % kNodes] = event.delta;
    of_kind_[static_cast<std::size_t>(event.kind)] = event.delta;
  }

 private:
  NodeId node_ = 0;
  std::array<std::uint64_t, kNodes> of_node_{};
  std::array<std::uint64_t, 64> of_kind_{};
};

/// An event's kind and line, and whether its delta is the one of its node's last event.
struct Label {
  EventKind kind = EventKind::pop;
  std::uint8_t line = 0;
  bool same_delta = false;
};

/// The labels that have occurred, by their numbers: fewer than 255, as planners have fewer lines that write. `kNew`
/// stands before one that has no number yet.
class Labels {
 public:
  static constexpr std::uint8_t kNew = 255;

  /// The label's number; kNew the first time.
  std::uint8_t number(const Label& label) {
    std::uint8_t& number = numbers_[slot(label)];
    if (number != kNew || size_ == kNew) return number;
    labels_[size_] = label;
    number = size_++;
    return kNew;
  }
  [[nodiscard]] const Label& label(std::uint8_t number) const { return labels_[number]; }
  void add(const Label& label) {
    if (size_ < kNew) labels_[size_++] = label;
  }

  Labels() { numbers_.fill(kNew); }

 private:
  static std::size_t slot(const Label& label) {
    return (static_cast<std::size_t>(label.kind) * 256 + label.line) * 2 + (label.same_delta ? 1 : 0);
  }
  std::array<std::uint8_t, std::size_t{64} * 256 * 2> numbers_;
  std::array<Label, kNew> labels_{};
  std::uint8_t size_ = 0;
};

/// Seven bits a byte, the lowest first.
void put(std::vector<std::uint8_t>& bytes, std::uint64_t number) {
  for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 0x80));
  bytes.push_back(static_cast<std::uint8_t>(number));
}

std::uint64_t get(const std::uint8_t*& at) {
  std::uint64_t number = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    number |= std::uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) return number;
  }
}

/// Small numbers for small steps either way.
std::uint32_t folded(std::uint32_t step) {
  return step << 1 ^ (step >> 31 != 0 ? ~0u : 0u);
}
std::uint32_t unfolded(std::uint32_t number) {
  return number >> 1 ^ ((number & 1) != 0 ? ~0u : 0u);
}

void pack_stretch(std::span<const Event> events, std::vector<std::uint8_t>& bytes) {
  Forecast forecast;
  Labels labels;
  for (const Event& event : events) {
    const Label label{event.kind, event.line, event.delta == forecast.delta_of_node(event.node)};
    const std::uint8_t number = labels.number(label);
    bytes.push_back(number);
    if (number == Labels::kNew) {
      bytes.push_back(
          static_cast<std::uint8_t>(static_cast<unsigned>(event.kind) << 1 | (label.same_delta ? 1 : 0)));
      bytes.push_back(event.line);
    }
    put(bytes, folded(event.node - forecast.node()));
    if (!label.same_delta) put(bytes, event.delta ^ forecast.delta_of_kind(event.kind));
    forecast.learn(event);
  }
}

}  // namespace

PackedEvents::PackedEvents(std::span<const Event> events) : count_(events.size()) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(events.size() * 8);
  begins_.reserve((events.size() + kStretch - 1) / kStretch);
  for (; !events.empty(); events = events.subspan(std::min(kStretch, events.size()))) {
    begins_.push_back(static_cast<std::uint32_t>(bytes.size()));
    pack_stretch(events.first(std::min(kStretch, events.size())), bytes);
  }
  bytes_ = {bytes.begin(), bytes.end()};  // without what was reserved
}

void PackedEvents::unpack(std::vector<Event>& events) const {
  events.resize(count_);
  for (std::size_t stretch = 0; stretch < begins_.size(); ++stretch) {
    const std::span<Event> rest = std::span(events).subspan(stretch * kStretch);
    unpack_to(stretch, rest.first(std::min(kStretch, rest.size())));
  }
}

void PackedEvents::unpack_stretch(std::size_t stretch, std::vector<Event>& events) const {
  events.resize(std::min(kStretch, count_ - stretch * kStretch));
  unpack_to(stretch, events);
}

void PackedEvents::unpack_to(std::size_t stretch, std::span<Event> events) const {
  Forecast forecast;
  Labels labels;
  const std::uint8_t* at = bytes_.data() + begins_[stretch];
  for (Event& event : events) {
    const std::uint8_t number = *at++;
    Label label;
    if (number == Labels::kNew) {
      label = {static_cast<EventKind>(*at >> 1), at[1], (*at & 1) != 0};
      at += 2;
      labels.add(label);
    } else {
      label = labels.label(number);
    }
    event = {.kind = label.kind, .line = label.line};
    event.node = forecast.node() + unfolded(static_cast<std::uint32_t>(get(at)));
    event.delta =
        label.same_delta ? forecast.delta_of_node(event.node) : get(at) ^ forecast.delta_of_kind(event.kind);
    forecast.learn(event);
  }
  assert(at == bytes_.data() + (stretch + 1 < begins_.size() ? begins_[stretch + 1] : bytes_.size()));
}

}  // namespace replan

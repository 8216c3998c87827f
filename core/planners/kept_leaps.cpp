#include "core/planners/kept_leaps.hpp"

#include <algorithm>
#include <utility>

namespace replan {
namespace {

void sort_by_index(std::vector<Leap>& leaps) {
  std::sort(leaps.begin(), leaps.end(), [](const Leap& a, const Leap& b) {
    return a.from < b.from || (a.from == b.from && a.to < b.to);
  });
}

}  // namespace

template <std::size_t D>
bool KeptLeaps<D>::Extent::meets(const Extent& other) const {
  for (std::size_t axis = 0; axis < D; ++axis)
    if (high[axis] < other.low[axis] || other.high[axis] < low[axis]) return false;
  return true;
}

template <std::size_t D>
void KeptLeaps<D>::Extent::take_in(const Place& place) {
  for (std::size_t axis = 0; axis < D; ++axis) {
    low[axis] = std::min(low[axis], place[axis]);
    high[axis] = std::max(high[axis], place[axis]);
  }
}

template <std::size_t D>
void KeptLeaps<D>::add(Leap leap, const Place& from, const Place& to) {
  if (groups_.empty() || groups_.back().leaps.size() == kGroup) {
    groups_.push_back({{from, from}, {}});
    groups_.back().leaps.reserve(kGroup);
  }
  Boxed boxed{leap, {from, from}};
  boxed.extent.take_in(to);
  Group& group = groups_.back();
  group.extent.take_in(from);
  group.extent.take_in(to);
  group.leaps.push_back(boxed);
}

template <std::size_t D>
std::vector<Leap> KeptLeaps<D>::take_touched(std::span<const Place> places) {
  std::vector<Leap> touched;
  if (places.empty()) return touched;
  Extent all{places.front(), places.front()};
  for (const Place& place : places) all.take_in(place);
  for (Group& group : groups_) {
    if (!group.extent.meets(all)) continue;
    std::erase_if(group.leaps, [&](const Boxed& boxed) {
      const auto holds = [&boxed](const Place& place) { return boxed.extent.meets({place, place}); };
      if (!boxed.extent.meets(all) || std::none_of(places.begin(), places.end(), holds)) return false;
      touched.push_back(boxed.leap);
      return true;
    });
  }
  std::erase_if(groups_, [](const Group& group) { return group.leaps.empty(); });
  sort_by_index(touched);
  return touched;
}

template <std::size_t D>
std::vector<Leap> KeptLeaps<D>::take_others(std::vector<NodeId> path) {
  std::sort(path.begin(), path.end());
  std::vector<Leap> others;
  std::vector<Group> groups = std::exchange(groups_, {});
  for (const Group& group : groups)
    for (const Boxed& boxed : group.leaps)
      if (std::binary_search(path.begin(), path.end(), boxed.leap.from))
        add(boxed.leap, boxed.extent.low, boxed.extent.high);
      else
        others.push_back(boxed.leap);
  sort_by_index(others);
  return others;
}

template <std::size_t D>
std::size_t KeptLeaps<D>::memory_bytes() const {
  std::size_t bytes = groups_.capacity() * sizeof(Group);
  for (const Group& group : groups_) bytes += group.leaps.capacity() * sizeof(Boxed);
  return bytes;
}

template class KeptLeaps<2>;
template class KeptLeaps<3>;

}  // namespace replan

#include "core/planners/kept_leaps.hpp"

#include <algorithm>

namespace replan {
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
void KeptLeaps<D>::clear() {
  groups_.clear();
  size_ = 0;
}

/// The last one, or another with room where the place is, so that room which was made there is filled again.
template <std::size_t D>
typename KeptLeaps<D>::Group& KeptLeaps<D>::group_for(const Place& from) {
  for (std::size_t i = groups_.size(); i-- > 0;)
    if (groups_[i].leaps.size() < kGroup && groups_[i].extent.holds(from)) return groups_[i];
  groups_.push_back({{from, from}, {}});
  return groups_.back();
}

template <std::size_t D>
void KeptLeaps<D>::add(Leap leap, const Place& from, const Place& to) {
  Boxed boxed{leap, {from, from}};
  boxed.extent.take_in(to);
  Group& group = group_for(from);
  group.extent.take_in(to);
  group.leaps.push_back(boxed);
  ++size_;
}

template <std::size_t D>
void KeptLeaps<D>::remove(NodeId from, const Place& place) {
  std::vector<Leap> removed;
  for (Group& group : groups_)
    if (group.extent.holds(place))
      take_if(
          group, [from](const Boxed& boxed) { return boxed.leap.from == from; }, removed);
  finish_taking(removed);
}

template <std::size_t D>
std::vector<Leap> KeptLeaps<D>::take_touched(std::span<const Place> places) {
  std::vector<Leap> touched;
  if (places.empty()) return touched;
  Extent all{places.front(), places.front()};
  for (const Place& place : places) all.take_in(place);
  const auto is_touched = [&](const Boxed& boxed) {
    const auto held = [&boxed](const Place& place) { return boxed.extent.holds(place); };
    return boxed.extent.meets(all) && std::any_of(places.begin(), places.end(), held);
  };
  for (Group& group : groups_)
    if (group.extent.meets(all)) take_if(group, is_touched, touched);
  finish_taking(touched);
  return touched;
}

template <std::size_t D>
std::vector<Leap> KeptLeaps<D>::take_others(std::vector<NodeId> path) {
  std::sort(path.begin(), path.end());
  std::vector<Leap> others;
  const auto is_other = [&path](const Boxed& boxed) {
    return !std::binary_search(path.begin(), path.end(), boxed.leap.from);
  };
  for (Group& group : groups_) take_if(group, is_other, others);
  finish_taking(others);
  return others;
}

template <std::size_t D>
template <class Condition>
void KeptLeaps<D>::take_if(Group& group, Condition&& condition, std::vector<Leap>& taken) {
  std::erase_if(group.leaps, [&](const Boxed& boxed) {
    if (!condition(boxed)) return false;
    taken.push_back(boxed.leap);
    return true;
  });
}

template <std::size_t D>
void KeptLeaps<D>::finish_taking(std::vector<Leap>& taken) {
  if (taken.empty()) return;
  size_ -= taken.size();
  std::erase_if(groups_, [](const Group& group) { return group.leaps.empty(); });
  std::sort(taken.begin(), taken.end(), [](const Leap& a, const Leap& b) { return a.from < b.from; });
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

#include "core/debug/law_values.hpp"

#include <algorithm>

#include "core/plan/common_parameters.hpp"

namespace replan {

template <int D>
LawValues<D>::LawValues(const LogView& view, std::size_t position)
    : heuristic_(heuristic_of(view.info, view.settings)),
      interpolated_(view.info.values.interpolated),
      waves_(view.info.values.waves),
      focused_(view.info.values.declares(fields::kFocused.kind)) {
  const SearchState state = view.log.state_at(position);
  known_ = BoxLattice<D>(view.lattice.template sides<D>(), state.known_map().plain(), view.rules());
  if (view.info.clearance) clearance_.emplace(known_, view.info.clearance(view.settings));
  pages_.resize((known_.node_count() + kPage - 1) / kPage);
  load(state);
}

template <int D>
void LawValues<D>::load(const SearchState& state) {
  constexpr std::size_t kStatePage = SearchState::kPage;
  constexpr EventKind kKinds[] = {EventKind::g,  EventKind::rhs, EventKind::queue,
                                  EventKind::lp, EventKind::rp,  EventKind::dist};
  for (std::size_t which = 0; which < scalars_.size(); ++which)
    scalars_[which] = state.scalar(static_cast<Scalar>(which));
  for (NodeId first = 0; first < known_.node_count(); first += kStatePage) {
    if (std::none_of(std::begin(kKinds), std::end(kKinds),
                     [&](EventKind kind) { return state.touched(kind, first); }))
      continue;
    const auto end = std::min<std::size_t>(known_.node_count(), first + kStatePage);
    for (NodeId node = first; node < end; ++node) {
      LawVertex& vertex = write(node);
      vertex.g = state.g(node);
      vertex.rhs = state.rhs(node);
      vertex.dist = state.dist(node);
      vertex.queue = static_cast<std::int64_t>(state.value(EventKind::queue, node));
      vertex.lp = state.lp(node) + 1u;
      vertex.rp = state.rp(node) + 1u;
      if (interpolated_) vertex.side = static_cast<std::uint32_t>(state.value(fields::kSide.kind, node));
      if (!waves_) continue;
      vertex.tag = static_cast<fields::StateTag>(state.value(fields::kTag.kind, node));
      vertex.k = {static_cast<std::int64_t>(state.value(fields::kLowest.kind, node))};
      if (focused_) vertex.f = {static_cast<std::int64_t>(state.value(fields::kFocused.kind, node))};
    }
  }
}

template <int D>
LawVertex& LawValues<D>::write(NodeId node) {
  auto& page = pages_[node / kPage];
  if (!page) page = std::make_unique<LawVertex[]>(kPage);
  return page[node % kPage];
}

template <int D>
LawVertex& LawValues<D>::changing(NodeId node, std::uint8_t change) {
  LawVertex& vertex = write(node);
  if (vertex.changed == 0) touched_.push_back({node, vertex.g, vertex.rhs, vertex.lp, vertex.queued()});
  vertex.changed |= change;
  return vertex;
}

template <int D>
void LawValues<D>::touch(NodeId node, LawVertex::Change change) {
  changing(node, change);
}

template <int D>
void LawValues<D>::apply(const Event& event) {
  const auto flip = [&event](Cost& cost) {
    cost.raw = static_cast<std::int64_t>(static_cast<std::uint64_t>(cost.raw) ^ event.delta);
  };
  switch (event.kind) {
    case EventKind::g:
      return flip(changing(event.node, LawVertex::offer).g);
    case EventKind::rhs:
      return flip(changing(event.node, LawVertex::own).rhs);
    case EventKind::dist:
      return flip(changing(event.node, LawVertex::offer).dist);
    case EventKind::queue: {
      LawVertex& vertex = changing(event.node, LawVertex::key);
      vertex.queue = static_cast<std::int64_t>(static_cast<std::uint64_t>(vertex.queue) ^ event.delta);
      return;
    }
    case EventKind::lp:
      changing(event.node, LawVertex::own).lp ^= static_cast<std::uint32_t>(event.delta);
      return;
    case EventKind::rp:
      write(event.node).rp ^= static_cast<std::uint32_t>(event.delta);
      return;
    case EventKind::epoch:
      return forget_search();
    case EventKind::known:
      turned_.push_back(event.node);
      disturbed_ = true;
      return;
    case EventKind::scalar:
      scalars_[event.node] ^= event.delta;
      disturbed_ |= event.node == static_cast<NodeId>(Scalar::start);
      return;
    case EventKind::pop:
      taken_ = at(event.node);
      return;
    default:
      return apply_own(event);
  }
}

template <int D>
void LawValues<D>::apply_own(const Event& event) {
  if (interpolated_ && event.kind == fields::kSide.kind)
    changing(event.node, LawVertex::own).side ^= static_cast<std::uint32_t>(event.delta);
  if (!waves_ || !is_own_field(event.kind)) return;
  LawVertex& vertex = changing(event.node, LawVertex::own);
  const auto delta = static_cast<std::int64_t>(event.delta);
  if (event.kind == fields::kTag.kind)
    vertex.tag = static_cast<fields::StateTag>(static_cast<std::uint8_t>(vertex.tag) ^ (event.delta & 0xFFu));
  if (event.kind == fields::kLowest.kind) vertex.k.raw ^= delta;
  if (event.kind == fields::kFocused.kind) vertex.f.raw ^= delta;
}

template <int D>
void LawValues<D>::forget_search() {
  for_each_page([this](NodeId node, const LawVertex& vertex) {
    const bool blank = vertex.g.is_infinite() && vertex.rhs.is_infinite() && !vertex.queued() &&
                       vertex.lp == 0 && vertex.rp == 0 && vertex.side == 0 &&
                       vertex.tag == fields::StateTag::fresh && vertex.k.is_infinite() &&
                       vertex.f.is_infinite();
    if (blank) return;
    LawVertex& forgotten = changing(node, LawVertex::all);
    forgotten.g = forgotten.rhs = forgotten.k = forgotten.f = Cost::infinity();
    forgotten.tag = fields::StateTag::fresh;
    forgotten.queue = 0;
    forgotten.lp = forgotten.rp = forgotten.side = 0;
  });
}

template <int D>
void LawValues<D>::finish_step() {
  if (turned_.empty()) return;
  std::sort(turned_.begin(), turned_.end());
  std::vector<CellEdit> edits;  // each cell once, if it is not as it was
  for (std::size_t i = 0; i < turned_.size(); ++i) {
    const bool again = !edits.empty() && edits.back().node == turned_[i];
    if (again)
      edits.pop_back();
    else
      edits.push_back({turned_[i], known_.obstacles()[turned_[i]] == 0});
  }
  turned_.clear();
  for (const auto& move : known_.apply(edits)) touch(move.node, LawVertex::all);
  if (clearance_)
    for (const ClearanceChange& change : clearance_->update(known_, known_.turned_by(edits)))
      touch(change.node, LawVertex::offer);
}

template <int D>
void LawValues<D>::settle() {
  for (const auto& each : touched_) write(each.node).changed = 0;
  touched_.clear();
  taken_.reset();
  disturbed_ = false;
}

template <int D>
std::size_t LawValues<D>::bytes() const {
  std::size_t bytes = pages_.size() * sizeof pages_[0] + known_.node_count() * 2;
  for (const auto& page : pages_)
    if (page) bytes += kPage * sizeof(LawVertex);
  return bytes + (clearance_ ? clearance_->memory_bytes() : 0);
}

template class LawValues<2>;
template class LawValues<3>;

}  // namespace replan

#include "core/debug/parent_tree.hpp"

#include <algorithm>

namespace replan {
namespace {

/// Points between two looks at the clock, or at the stop token: whole pages of a state.
constexpr std::size_t kParentSlice = 256 * SearchState::kPage;

}  // namespace

/// One moment, from its first point to its last.
struct ParentTableReader::Job {
  Job(const LogView& its_view, std::uint64_t log_id) : view(its_view), state(its_view.log.state()) {
    table.log_id = log_id;
    table.position = view.log.cursor();
    count = point_count(view.info, state);
    table.parents.reserve(count);
    if (view.info.values.grows()) table.cells.reserve(count);
  }
  /// Most of a large map was never touched.
  [[nodiscard]] bool untouched(NodeId first) const {
    const SearchValues& values = view.info.values;
    return !values.grows() && state.page(EventKind::lp, first) == nullptr &&
           (!values.declares(EventKind::rp) || state.page(EventKind::rp, first) == nullptr);
  }
  void read_slice() {
    constexpr std::size_t kPage = SearchState::kPage;
    const std::size_t end = std::min(count, table.parents.size() + kParentSlice);
    while (table.parents.size() < end) {
      const std::size_t first = table.parents.size(), last = std::min(end, first + kPage);
      if (untouched(static_cast<NodeId>(first)))
        table.parents.resize(last, kNoNode);
      else
        for (std::size_t i = first; i < last; ++i) take(static_cast<NodeId>(i));
    }
  }
  void take(NodeId point) {
    const NodeId parent = parent_of(view.info, state, point);
    table.parents.push_back(parent < count ? parent : kNoNode);
    if (view.info.values.grows()) table.cells.push_back(view.lattice.node(cell_of_point(view, state, point)));
  }

  LogView view;
  SearchState state;
  std::size_t count = 0;
  ParentTable table;
};

void ParentTableReader::begin(const LogView& view, std::uint64_t log_id) {
  job_ = std::make_shared<Job>(view, log_id);
}

std::shared_ptr<const ParentTable> ParentTableReader::read(const Deadline& deadline) {
  if (!job_) return nullptr;
  while (job_->table.parents.size() < job_->count) {
    job_->read_slice();
    if (deadline.passed()) break;
  }
  if (job_->table.parents.size() < job_->count) return nullptr;
  auto table = std::make_shared<const ParentTable>(std::move(job_->table));
  job_.reset();
  return table;
}

ParentTree::ParentTree(std::shared_ptr<const ParentTable> table, const std::stop_token& stop)
    : table_(std::move(table)) {
  link(stop);
  if (!stop.stop_requested()) count(stop);
}

void ParentTree::link(const std::stop_token& stop) {
  const std::vector<NodeId>& parents = table_->parents;
  begins_.assign(parents.size() + 2, 0);
  for (const NodeId parent : parents)
    if (parent != kNoNode) ++begins_[parent + 2];
  for (std::size_t i = 2; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  children_.resize(begins_.back());
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (i % kParentSlice == 0 && stop.stop_requested()) return;
    if (parents[i] != kNoNode) children_[begins_[parents[i] + 1]++] = static_cast<NodeId>(i);
  }
}

/// From the leaves up: a point is counted for its parent when all of its own children are. What is never counted is a
/// circle, or hangs on none of these.
void ParentTree::count(const std::stop_token& stop) {
  const std::vector<NodeId>& parents = table_->parents;
  below_.assign(parents.size(), 0);
  circle_.assign(parents.size(), false);
  std::vector<std::uint32_t> waits(parents.size());
  std::vector<NodeId> ready;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    waits[i] = begins_[i + 1] - begins_[i];
    if (waits[i] > 0 || parents[i] != kNoNode) ++members_;
    if (waits[i] == 0 && parents[i] != kNoNode) ready.push_back(static_cast<NodeId>(i));
  }
  for (std::size_t next = 0; next < ready.size(); ++next) {
    if (next % kParentSlice == 0 && stop.stop_requested()) return;
    const NodeId parent = parents[ready[next]];
    below_[parent] += below_[ready[next]] + 1;
    if (--waits[parent] == 0 && parents[parent] != kNoNode) ready.push_back(parent);
  }
  for (std::size_t i = 0; i < parents.size(); ++i) circle_[i] = waits[i] > 0 && parents[i] != kNoNode;
}

Ancestry ancestry(const PlannerInfo& info, const SearchState& state, NodeId point) {
  Ancestry found;
  std::vector<bool> seen(point_count(info, state));
  for (NodeId at = point; at < seen.size(); at = parent_of(info, state, at)) {
    found.circle = seen[at];
    if (found.circle) break;
    seen[at] = true;
    found.points.push_back(at);
  }
  return found;
}

CellSet cells_below(const ParentTree& tree, NodeId point, std::size_t nodes, const std::stop_token& stop) {
  CellSet cells(nodes, tree.table().log_id);
  if (point >= tree.point_count()) return cells;
  const NodeId own = tree.table().cell(point);
  std::vector<NodeId> rest = {point};
  for (std::size_t taken = 0; !rest.empty(); ++taken) {
    if (taken % kParentSlice == 0 && stop.stop_requested()) break;
    const NodeId from = rest.back();
    rest.pop_back();
    for (const NodeId each : tree.children(from)) {
      if (each == point) continue;  // round a circle
      if (const NodeId cell = tree.table().cell(each); cell != own) cells.add(cell);
      rest.push_back(each);
    }
  }
  return cells;
}

}  // namespace replan

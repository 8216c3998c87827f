#include "core/debug/parent_tree.hpp"

#include <algorithm>

namespace replan {
namespace {

/// Points between two looks at the clock: whole pages of a state.
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
    constexpr std::size_t kPoints = SearchState::kPage;
    const std::size_t end = std::min(count, table.parents.size() + kParentSlice);
    while (table.parents.size() < end) {
      const std::size_t first = table.parents.size(), last = std::min(end, first + kPoints);
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

ParentTree::ParentTree(std::shared_ptr<const ParentTable> table) {
  ParentTreeBuilder builder(std::move(table));
  while (builder.advance()) {
  }
  *this = builder.take();
}

ParentTreeBuilder::ParentTreeBuilder(std::shared_ptr<const ParentTable> table) {
  tree_.table_ = std::move(table);
  tree_.begins_.assign(tree_.table_->parents.size() + 2, 0);
}

bool ParentTreeBuilder::advance() {
  if (phase_ == Phase::whole) return false;
  const std::size_t end = std::min(length(), at_ + kParentSlice);
  go_over(at_, end);
  at_ = end;
  if (at_ < length()) return true;
  at_ = 0;
  phase_ = static_cast<Phase>(static_cast<int>(phase_) + 1);
  return phase_ != Phase::whole;
}

/// Of the phase.
std::size_t ParentTreeBuilder::length() const {
  if (phase_ == Phase::sum_up) return tree_.begins_.size();
  return phase_ == Phase::climb ? ready_.size() : tree_.table_->parents.size();
}

void ParentTreeBuilder::go_over(std::size_t begin, std::size_t end) {
  const std::size_t points = tree_.table_->parents.size();
  if (begin == 0 && phase_ == Phase::link) tree_.children_.resize(tree_.begins_.back());
  if (begin == 0 && phase_ == Phase::find_leaves) {
    tree_.below_.assign(points, 0);
    tree_.circle_.assign(points, false);
    waits_.resize(points);
  }
  for (std::size_t i = begin; i < end; ++i) visit(i);
}

void ParentTreeBuilder::visit(std::size_t number) {
  const std::vector<NodeId>& parents = tree_.table_->parents;
  std::vector<std::uint32_t>& begins = tree_.begins_;
  if (phase_ == Phase::sum_up) {
    if (number >= 2) begins[number] += begins[number - 1];
    return;
  }
  if (phase_ == Phase::climb) return climb(number);
  if (phase_ == Phase::find_leaves) return find_leaf(number);
  const NodeId parent = parents[number];
  if (parent == kNoNode) return;
  if (phase_ == Phase::count_children) ++begins[parent + 2];
  if (phase_ == Phase::link) tree_.children_[begins[parent + 1]++] = static_cast<NodeId>(number);
  if (phase_ == Phase::find_circles) tree_.circle_[number] = waits_[number] > 0;
}

void ParentTreeBuilder::find_leaf(std::size_t point) {
  const NodeId parent = tree_.table_->parents[point];
  waits_[point] = tree_.begins_[point + 1] - tree_.begins_[point];
  if (waits_[point] > 0 || parent != kNoNode) ++tree_.members_;
  if (waits_[point] == 0 && parent != kNoNode) ready_.push_back(static_cast<NodeId>(point));
}

/// From the leaves up: a point is counted for its parent when all of its own children are. What is never counted is a
/// circle, or hangs on none of these.
void ParentTreeBuilder::climb(std::size_t number) {
  const std::vector<NodeId>& parents = tree_.table_->parents;
  const NodeId point = ready_[number], parent = parents[point];
  tree_.below_[parent] += tree_.below_[point] + 1;
  if (--waits_[parent] == 0 && parents[parent] != kNoNode) ready_.push_back(parent);
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

CellsBelow::CellsBelow(std::shared_ptr<const ParentTree> tree, NodeId point, std::size_t nodes)
    : tree_(std::move(tree)), point_(point), cells_(nodes, tree_->table().log_id) {
  if (point < tree_->point_count()) rest_ = {point};
}

bool CellsBelow::advance() {
  for (std::size_t taken = 0; taken < kParentSlice && !rest_.empty(); ++taken) {
    const NodeId from = rest_.back();
    rest_.pop_back();
    for (const NodeId each : tree_->children(from)) {
      if (each == point_) continue;  // round a circle
      if (const NodeId cell = tree_->table().cell(each); cell != tree_->table().cell(point_))
        cells_.add(cell);
      rest_.push_back(each);
    }
  }
  return !rest_.empty();
}

CellSet cells_below(const ParentTree& tree, NodeId point, std::size_t nodes) {
  CellsBelow cells({std::shared_ptr<const void>(), &tree}, point, nodes);  // which owns nothing
  while (cells.advance()) {
  }
  return cells.take();
}

}  // namespace replan

#include "core/scene/tree_edges.hpp"

#include <algorithm>
#include <optional>

#include "core/plan/tree_values.hpp"

namespace replan {
namespace {

/// Reads edges one after the other.
class EdgeReader {
 public:
  EdgeReader(const Run& run, const EdgeBins::Seen& in_sight)
      : state_(run.timeline().state()), solid_(run.lattice().solid()), in_sight_(in_sight) {}

  /// Those of every so manieth page of vertices.
  DrawnTree of_pages(std::uint32_t every) {
    const std::uint32_t count = vertex_count(state_);
    for (std::uint32_t first = 0; first < count; first += VertexPage::kSize * every) {
      const VertexPage page(state_, first, solid_);
      for (std::uint32_t i = 0; i < std::min(VertexPage::kSize, count - first); ++i) take(page, first, i);
    }
    return finished(static_cast<int>(every), dearest_);
  }
  /// Those of vertices in ascending order; the dearest vertex of all costs `dearest`.
  DrawnTree of(const std::vector<std::uint32_t>& vertices, Cost dearest) {
    std::optional<VertexPage> page;
    std::uint32_t first = kNoNode;
    for (const std::uint32_t v : vertices) {
      if (v / VertexPage::kSize * VertexPage::kSize != first) {
        first = v / VertexPage::kSize * VertexPage::kSize;
        page.emplace(state_, first, solid_);
      }
      take(*page, first, v - first);
    }
    return finished(1, dearest.to_double());
  }

 private:
  void take(const VertexPage& page, std::uint32_t first, std::uint32_t i) {
    if (page.parent(i) == kNoNode || page.cost(i).is_infinite()) return;
    const double cost = page.cost(i).to_double();
    dearest_ = std::max(dearest_, cost);
    const TreeEdge edge{point_of(vertex_place(state_, page.parent(i), solid_)), point_of(page.place(i)),
                        cost};
    if (!in_sight_(edge.from, edge.to)) return;
    edges_.push_back(edge);
    edges_.back().from_goal = vertex_side(state_, first + i) == TreeSide::goal;
  }
  DrawnTree finished(int every, double dearest) {
    if (dearest > 0)
      for (TreeEdge& edge : edges_) edge.cost /= dearest;
    return {std::move(edges_), every};
  }

  const SearchState& state_;
  const bool solid_;
  const EdgeBins::Seen& in_sight_;
  std::vector<TreeEdge> edges_;
  double dearest_ = 0;
};

DrawnTree edges_in_sight(const Run& run, EdgeBins* bins, const EdgeBins::Seen& in_sight) {
  EdgeReader reader(run, in_sight);
  const std::uint32_t count = vertex_count(run.timeline().state()),
                      every = std::max(1u, (count + kMostRead - 1) / kMostRead);
  if (every > 1 && bins != nullptr) {
    bins->follow(run);
    if (const auto vertices = bins->seen(kMostRead, in_sight)) return reader.of(*vertices, bins->dearest());
  }
  return reader.of_pages(every);
}

}  // namespace

DrawnTree drawn_tree(const Run& run, EdgeBins* bins, const EdgeBins::Seen& in_sight) {
  DrawnTree tree = edges_in_sight(run, bins, in_sight);
  const std::size_t every = std::max<std::size_t>(1, (tree.edges.size() + kMostEdges - 1) / kMostEdges);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < tree.edges.size(); i += every) tree.edges[kept++] = tree.edges[i];
  tree.edges.resize(kept);
  tree.every *= static_cast<int>(every);
  return tree;
}

}  // namespace replan

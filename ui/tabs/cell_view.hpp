// One cell of the leading run at the cursor, for the parts of the Cell tab.
#pragma once

#include "core/debug/child_in_hand.hpp"
#include "core/trace/search_state.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui {

/// What a cell's values mean depends on the planner: D* Lite looks ahead by rhs, A* knows g alone.
struct CellView {
  const Run& run;
  const SearchState& state;
  Cell cell;
  NodeId node;
  bool lookahead;  // the planner keeps rhs

  CellView(const Run& of, Cell at)
      : run(of),
        state(of.timeline().state()),
        cell(at),
        node(of.lattice().node(at)),
        lookahead(of.info().values.lookahead()) {}
};

/// Each neighbour with c + g + dist = sum, the winner marked: why the cell's rhs (A*: its g) is what it is.
void draw_why(Frame& frame, const CellView& view);

/// The same of a tree of samples, for the vertex nearest to the cell: what it could have hung on, each with its sum.
void draw_vertex_why(Frame& frame, const CellView& view);

/// Of planners that breed paths: why the child in hand is as it is, the paths over the cell, and where the fittest one comes
/// from, which is kept in `leader_birth`.
void draw_paths(Frame& frame, const CellView& view, PathBirth& leader_birth);
/// Why the child in hand is as it is, alone.
void draw_child_why(Frame& frame, const CellView& view);

struct CellPast;
/// All that there is to say of that vertex: its values, why it hangs where it does, and its past; and of the sample in hand.
void draw_vertex(Frame& frame, const CellView& view, CellPast& past);

}  // namespace replan::ui

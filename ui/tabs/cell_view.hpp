// One cell of the leading run at the cursor, for the parts of the Cell tab.
#pragma once

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

/// Of a tree of samples: the vertex nearest to the cell, what it could have hung on with each sum, and what rewiring saved.
void draw_vertex(Frame& frame, const CellView& view);

}  // namespace replan::ui

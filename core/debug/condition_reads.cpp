#include "core/debug/condition_reads.hpp"

#include <algorithm>

namespace replan {

KindSet kinds_of(Op op) {
  switch (op) {
    case Op::g:
      return {EventKind::g};
    case Op::rhs:
      return {EventKind::rhs};
    case Op::dist:
      return {EventKind::dist};
    case Op::k1:
    case Op::queued:
      return {EventKind::queue};
    case Op::k2:
      return {EventKind::queue, EventKind::g, EventKind::rhs};
    case Op::order:
    case Op::times:
      return {EventKind::visit};
    case Op::lp:
      return {EventKind::lp};
    case Op::rp:
      return {EventKind::rp};
    case Op::known:
      return {EventKind::known};
    case Op::wall:
      return {EventKind::truth};
    case Op::consistent:
      return {EventKind::g, EventKind::rhs};
    case Op::queue_size:
      return {EventKind::queue};
    case Op::expansions:
      return {EventKind::visit};
    default:
      return {};
  }
}

KindSet kinds_of(const Term& term, const SearchValues& values) {
  if (term.op == Op::samples) return values.grows() ? KindSet{EventKind::visit} : KindSet();
  if (term.field.empty()) return kinds_of(term.op);
  const Field* field = values.find(term.field);
  return field == nullptr ? KindSet() : KindSet{field->kind};
}

std::optional<Scalar> scalar_of(Op op) {
  switch (op) {
    case Op::km:
      return Scalar::km;
    case Op::moves:
      return Scalar::moves;
    case Op::replans:
      return Scalar::replans;
    case Op::robot:
      return Scalar::robot;
    case Op::start:
      return Scalar::start;
    case Op::goal:
      return Scalar::goal;
    case Op::last:
      return Scalar::last;
    case Op::sub_goal:
      return Scalar::sub_goal;
    case Op::admissible:
      return Scalar::admissible;
    case Op::score:
      return Scalar::score;
    case Op::best:
      return Scalar::best;
    case Op::vertices:
      return Scalar::vertices;
    case Op::generation:
      return Scalar::generation;
    default:
      return std::nullopt;
  }
}

KindSet kinds_of(Happening happening) {
  switch (happening) {
    case Happening::plan:
    case Happening::replan:
      return {EventKind::plan_begin};
    case Happening::underconsistent:
      return {EventKind::pop};
    case Happening::sight_failed:
      return {EventKind::sight};
    case Happening::first_path:
      return {EventKind::scalar};
    case Happening::rewired:
      return {EventKind::rewired};
    case Happening::no_path:
      return {EventKind::plan_end};
    case Happening::blocked:
      return {EventKind::waiting, EventKind::collision, EventKind::gave_up};
    case Happening::surprise:
      return {EventKind::surprise};
    case Happening::move:
      return {EventKind::move};
    case Happening::arrival:
      return {EventKind::arrival};
    default:
      return {};
  }
}

std::size_t last_until(std::span<const std::size_t> positions, std::size_t position) {
  const auto found = std::upper_bound(positions.begin(), positions.end(), position);
  return found == positions.begin() ? 0 : *std::prev(found);
}

}  // namespace replan

#include "core/session/checks.hpp"

namespace replan {

LawReport Checks::laws(std::size_t) const {
  return {};
}

OracleReport Checks::oracle(std::size_t) const {
  return {};
}

}  // namespace replan

// The operators of the condition language that join two terms: what reads expressions and what writes them
// out agree on these.
#pragma once

#include <string_view>

#include "core/debug/condition.hpp"

namespace replan {

struct ConditionOperator {
  std::string_view symbol;
  Op op;
  int level;                  ///< the higher, the tighter it binds
  ValueType operand, result;  ///< of == and != any operand
};

inline constexpr int kEqualityLevel = 3;
inline constexpr int kUnaryLevel = 7;  ///< of ! and -
inline constexpr int kLeafLevel = 8;   ///< of what is no operator

// Longer symbols first: '<=' begins like '<'.
inline constexpr ConditionOperator kConditionOperators[] = {
    {"||", Op::either, 1, ValueType::truth, ValueType::truth},
    {"&&", Op::both, 2, ValueType::truth, ValueType::truth},
    {"==", Op::equal, kEqualityLevel, ValueType::number, ValueType::truth},
    {"!=", Op::unequal, kEqualityLevel, ValueType::number, ValueType::truth},
    {"<=", Op::at_most, 4, ValueType::number, ValueType::truth},
    {">=", Op::at_least, 4, ValueType::number, ValueType::truth},
    {"<", Op::less, 4, ValueType::number, ValueType::truth},
    {">", Op::more, 4, ValueType::number, ValueType::truth},
    {"+", Op::plus, 5, ValueType::number, ValueType::number},
    {"-", Op::minus, 5, ValueType::number, ValueType::number},
    {"*", Op::product, 6, ValueType::number, ValueType::number},
    {"/", Op::quotient, 6, ValueType::number, ValueType::number},
};

}  // namespace replan

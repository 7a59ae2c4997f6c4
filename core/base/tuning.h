#pragma once

#include <string>
#include <tuple>
#include <type_traits>

namespace swaplight {

/// Calls visit(name, value) for every constant of a struct of tuning constants, in the order of its fields():
/// a tuple of pairs of a name and a member, which is a number, or a struct of the same kind. Names are joined
/// by dots ("pooling.guide_step"). For programs that measure what a change costs (tests/bench); what computes
/// takes the struct.
template <typename Tuning, typename Visit>
void visitTuning(Tuning& tuning, const Visit& visit, const std::string& group = {}) {
  const auto visitOne = [&](const char* name, auto& value) {
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
      visit(group + name, value);
    else
      visitTuning(value, visit, group + name + ".");
  };
  std::apply([&](const auto&... field) { (visitOne(field.first, tuning.*field.second), ...); },
             std::remove_const_t<Tuning>::fields());
}

}  // namespace swaplight

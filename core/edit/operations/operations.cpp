#include "core/edit/operations/operations.h"

namespace swaplight {

std::string operationName(const Operation& operation) {
  return std::visit([](const auto& o) -> std::string { return o.info.name; }, operation);
}

std::string operationSummary(const Operation& operation) {
  return std::visit(
      [](const auto& o) -> std::string {
        if constexpr (requires { o.summary(); })
          return o.summary();
        else
          return o.info.name;
      },
      operation);
}

int operationReach(const Operation& operation) {
  return std::visit(
      [](const auto& o) {
        if constexpr (requires { o.reach(); })
          return o.reach();
        else
          return 0;
      },
      operation);
}

bool actsOnBeta(const Operation& operation) {
  return std::visit([]<typename T>(const T&) { return BetaOperation<T>; }, operation);
}

bool actsOnAllLights(const Operation& operation) {
  return std::visit(
      []<typename T>(const T&) {
        return SurfaceOperation<T> || requires {
          T::kOfAllLights;
        };
      },
      operation);
}

bool usesShadows(const Operation& operation) {
  return std::visit(
      [](const auto& o) {
        return requires {
          o.kUsesShadows;
        };
      },
      operation);
}

bool usesHighlights(const Operation& operation) {
  return std::visit([]<typename T>(const T&) { return HighlightOperation<T>; }, operation);
}

bool swapsTwoLights(const Operation& operation) {
  return std::visit(
      [](const auto& o) {
        return requires {
          o.kSwapsTwoLights;
        };
      },
      operation);
}

bool mixesLights(const Operation& operation) {
  return std::visit(
      [](const auto& o) {
        return requires {
          o.kMixesLights;
        };
      },
      operation);
}

}  // namespace swaplight

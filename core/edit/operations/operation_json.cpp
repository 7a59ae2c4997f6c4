#include "core/edit/operations/operation_json.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/fields/field_json.h"

namespace swaplight {

void writeOperation(const Operation& operation, Json& json) {
  json["operation"] = operationName(operation);
  std::visit([&](const auto& o) { writeFields(o, json); }, operation);
}

Operation readOperation(JsonFields& fields) {
  const std::string name = fields.text("operation").value_or("");
  std::optional<Operation> found;
  std::vector<std::string> names;
  forEachOperation([&]<typename T>(const T&) {
    names.emplace_back(T::info.name);
    if (name != T::info.name) return;
    T operation;
    readFields(fields, operation);
    found = std::move(operation);
  });
  if (!found)
    throw InputError("{}: \"{}\" is no operation, expected one of {}.", fields.where(), name,
                     fmt::join(names, ", "));
  return *found;
}

}  // namespace swaplight

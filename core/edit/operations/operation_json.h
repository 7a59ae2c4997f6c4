#pragma once

#include "core/base/json_fwd.h"
#include "core/edit/operations/operations.h"

namespace swaplight {

class JsonFields;

/// Adds "operation", the edit's name, and its fields to `json`.
void writeOperation(const Operation& operation, Json& json);
/// Throws InputError that says where, what was found and what was expected.
[[nodiscard]] Operation readOperation(JsonFields& fields);

}  // namespace swaplight

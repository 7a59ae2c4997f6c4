#pragma once

#include "core/base/json_fwd.h"

namespace swaplight {

// How a session keeps what a newer or another program has written into it, without every type having to carry
// its strangers along: what was read, less what was understood, is laid under what is written.

/// What stands in `read` and not in `understood` (the same value, read and written again): keys of objects
/// at any depth. Objects in arrays are matched by their "name", "light" or "id"; other arrays are not looked
/// into.
[[nodiscard]] Json unknownKeys(const Json& read, const Json& understood);

/// Adds to `written` what `unknown` holds and `written` does not, matched as above.
void keepUnknownKeys(Json& written, const Json& unknown);

}  // namespace swaplight

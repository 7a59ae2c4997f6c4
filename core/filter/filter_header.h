#pragma once

#include <cstddef>
#include <string>

#include "core/base/json.h"

namespace swaplight {

/// The comment of JSON that a filter's file begins with.
struct FilterHeader {
  size_t begin = 0, end = 0;  ///< of the JSON in the file's text; "*/" follows
  Json json;
};

/// `name` begins messages. Throws InputError: there is none, it has no end, it is not JSON (with the line).
[[nodiscard]] FilterHeader headerOf(const std::string& text, const std::string& name);

/// The line, from 1, in which a place of a text lies.
[[nodiscard]] int lineOf(const std::string& text, size_t offset);

}  // namespace swaplight

#include "core/edit/shapes/pattern_shape.h"

#include "core/base/error.h"

namespace swaplight {

void PatternShape::check(const std::string& where) const {
  if (!(size > 0)) throw InputError("{}: \"size\" is {}, expected more than 0.", where, size);
}

}  // namespace swaplight

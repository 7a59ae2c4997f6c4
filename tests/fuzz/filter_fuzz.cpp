#include <cmath>
#include <cstdlib>

#include "core/filter/filter_file.h"
#include "core/filter/glsl/glsl_translation.h"
#include "core/filter/size_expression.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

// A filter: its header, what its passes' sizes are, and its shader as OpenGL 4.1 compiles it.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::load([&] {
    const Filter filter = filterFromText(fuzz::textOf(data, size), "any.fs");
    static_cast<void>(translateFilter(filter));
    for (const FilterPass& pass : filter.passes)
      if (!pass.widthExpression.empty() &&
          !std::isfinite(expressionValue(pass.widthExpression, [](const std::string&) { return 640.0; })))
        std::abort();
  });
  return 0;
}

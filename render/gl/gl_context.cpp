#include "render/gl/gl_context.h"

#include <mutex>
#include <utility>

#include "render/gl/egl_context.h"

namespace swaplight {
namespace {

struct Chosen {
  std::mutex mutex;
  GlContextSource source;
};

Chosen& chosen() {
  static Chosen chosen;
  return chosen;
}

}  // namespace

void setGlContextSource(GlContextSource source) {
  const std::lock_guard lock(chosen().mutex);
  chosen().source = std::move(source);
}

std::unique_ptr<GlContext> newGlContext() {
  GlContextSource source;
  {
    const std::lock_guard lock(chosen().mutex);
    source = chosen().source;
  }
  return source ? source() : std::make_unique<EglContext>();
}

}  // namespace swaplight

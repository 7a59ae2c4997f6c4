#include "render/gl/gl_context.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <thread>

#include "render/gl/egl_context.h"
#include "render/gl/gl_thread.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

using GlContextTest = GlTest;

/// Threads get what this source makes, until it goes away.
struct Source {
  explicit Source(GlContextSource source) { setGlContextSource(std::move(source)); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  ~Source() { setGlContextSource({}); }
};

TEST_F(GlContextTest, AThreadDrawsWithWhatTheSourceMakesOnIt) {
  std::thread::id madeOn;
  std::weak_ptr<bool> alive;
  const Source source([&]() -> std::unique_ptr<GlContext> {
    struct Counted : EglContext {
      std::shared_ptr<bool> life = std::make_shared<bool>(true);
    };
    auto context = std::make_unique<Counted>();
    madeOn = std::this_thread::get_id();
    alive = context->life;
    return context;
  });
  {
    GlThread thread;
    EXPECT_EQ(thread.run([] { return std::this_thread::get_id(); }), madeOn);
    EXPECT_TRUE(thread.run([] { return glGetString(GL_VERSION) != nullptr; }));
    EXPECT_FALSE(alive.expired());
  }
  EXPECT_TRUE(alive.expired());
}

TEST_F(GlContextTest, WhatTheSourceLacksIsSaidByTheThread) {
  const Source source(
      []() -> std::unique_ptr<GlContext> { throw std::runtime_error("no context beside the window"); });
  EXPECT_THROW(GlThread(), std::runtime_error);
}

TEST_F(GlContextTest, WithoutASourceTheContextIsEgls) {
  std::thread([] {
    const std::unique_ptr<GlContext> context = newGlContext();
    EXPECT_NE(dynamic_cast<EglContext*>(context.get()), nullptr);
  }).join();
}

}  // namespace
}  // namespace swaplight

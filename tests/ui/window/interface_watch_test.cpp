// The studio draws as long as something is under way, and sleeps when all stands still.
#include "ui/window/interface_watch.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>

namespace swaplight {
namespace {

constexpr int kSoon = 8;  // frames, after which all has come to rest

class InterfaceWatchTest : public testing::Test {
 protected:
  InterfaceWatchTest() {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(800, 600);
    io.DeltaTime = 1.0F / 60;
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }

  /// Whether another frame is wanted after this one.
  bool movesAfter(const std::function<void()>& draw) {
    ImGui::NewFrame();
    draw();
    ImGui::Render();
    m_watch.frameDrawn();
    return m_watch.moves();
  }

 private:
  struct Context {
    Context() { ImGui::CreateContext(); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() { ImGui::DestroyContext(); }
  };
  Context m_context;
  InterfaceWatch m_watch;
};

/// As wide as it is told, and as high as what is in it: how boxes of progress and dialogs are made.
void box(const char* text) {
  ImGui::SetNextWindowSize(ImVec2(300, 0));
  ImGui::Begin("box");
  ImGui::TextUnformatted(text);
  ImGui::End();
}

TEST_F(InterfaceWatchTest, ABoxAsHighAsItsContentsComesToRest) {
  bool moves = true;
  for (int frame = 0; frame < kSoon; ++frame) moves = movesAfter([] { box("reading"); });
  EXPECT_FALSE(moves);
}

TEST_F(InterfaceWatchTest, ABoxThatGrowsIsDrawnUntilItHasGrown) {
  for (int frame = 0; frame < kSoon; ++frame) (void)movesAfter([] { box("reading"); });
  // What is in it is known after the frame, the height follows in the next, and what stands below that in one
  // more.
  (void)movesAfter([] { box("reading\nand solving"); });
  EXPECT_TRUE(movesAfter([] { box("reading\nand solving"); }));
  EXPECT_FALSE(movesAfter([] { box("reading\nand solving"); }));
}

TEST_F(InterfaceWatchTest, AWindowThatOpensIsUnderWay) {
  for (int frame = 0; frame < kSoon; ++frame) (void)movesAfter([] { box("one"); });
  const auto two = [] {
    box("one");
    ImGui::Begin("another", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::TextUnformatted("two");
    ImGui::End();
  };
  EXPECT_TRUE(movesAfter(two));
  bool moves = true;
  for (int frame = 0; frame < kSoon; ++frame) moves = movesAfter(two);
  EXPECT_FALSE(moves);
}

}  // namespace
}  // namespace swaplight

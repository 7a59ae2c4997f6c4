#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"
#include "ui/camera/look_preview.h"
#include "ui/control/edit_controller.h"
#include "ui/control/editing_context.h"
#include "ui/control/export_controller.h"
#include "ui/control/lights_context.h"
#include "ui/control/scopes_controller.h"
#include "ui/control/session_controller.h"
#include "ui/control/shadow_controller.h"

namespace swaplight::test {

/// Draws nothing, and counts what it is told.
class CountingRenderer : public ViewportRenderer {
 public:
  unsigned texture(const ViewportRequest& /*request*/, int /*place*/) override { return 0; }
  void changed(const Pyramid& /*picture*/, const TileRect& /*where*/) override { ++changes; }
  void setConfig(const std::shared_ptr<const ColorConfig>& /*config*/) override {}
  [[nodiscard]] std::string words() const override { return "nobody"; }

  int changes = 0;  ///< rectangles of pixels
};

/// The studio's parts without a window, wired as the window does it.
class StudioParts {
 public:
  explicit StudioParts(const std::filesystem::path& stateFolder = {})
      : session(editor, view, sets, messages, colors, stateFolder.empty() ? folder / "state" : stateFolder,
                wake) {}

  /// What the window does in every frame.
  void frame() {
    session.update();
    exports.update(messages);
    subjects.update(messages);
    edits.beginFrame();
    if (session.set()) edits.show({0, 0, session.set()->solved().width(), session.set()->solved().height()});
  }

  /// Frames until something holds; fails the test where it never does.
  template <typename Condition>
  void until(const char* what, const Condition& holds) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!holds()) {
      ASSERT_LT(std::chrono::steady_clock::now(), patience) << what << "; " << said();
      frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// A set without a file.
  void open(SolvedSet set) {
    OpenSet open;
    open.source = folder / "set.exr";
    open.original = open.found = std::make_shared<SolvedSet>(std::move(set));
    open.live = std::make_shared<LiveSet>(open.original);
    session.openSet(std::move(open));
    frame();
  }

  void append(Edit edit) {
    Document next = editor.document();
    next.edits.append(std::move(edit));
    editor.edit("Edit", std::move(next));
  }

  /// All messages, one after the other.
  [[nodiscard]] std::string said() const {
    std::string all;
    for (const Messages::Message& message : messages.messages()) all += message.text + "\n";
    return all;
  }
  [[nodiscard]] size_t errors() const {
    return static_cast<size_t>(
        std::count_if(messages.messages().begin(), messages.messages().end(),
                      [](const auto& message) { return message.kind == Messages::Kind::Error; }));
  }

  TemporaryFolder folder;
  std::atomic<int> woken{0};
  std::function<void()> wake = [this] { ++woken; };
  DocumentEditor editor;
  ViewState view;
  Messages messages;
  ColorChoice colors;
  SetController sets{wake};
  SessionController session;
  CountingRenderer renderer;
  ExportController exports{wake};
  SubjectPictures subjects{wake};
  PanelLayout layout;
  ToolInHand tool = nullptr;
  MixerState mixer;
  Swatches swatches{{}};
  LookState looks;
  ViewTable table;
  ViewerState viewer;
  EditController edits{{editor, session, subjects, renderer, messages}, wake};
  EditsState editing;
  ShadowController shadows{{{editor, view}, session, edits, editing.shadow, messages}, wake};
  LookPreview seen{wake};
  ScopesController scopes{
      {{editor, view}, session, edits, layout.scopeOptions, viewer, seen, colors, table, messages}, wake};
  LookShelf shelf{[this]() -> FilterLibrary& { return seen.library(); }, folder / "favourites.json"};
  ActionTable actions;
  Keyboard keyboard;
  ShownPicture shown;
  ChosenLights chosen{editor, view};
  LightsContext lights{{editor, view}, session,  edits, messages, colors,  layout,
                       mixer,          swatches, looks, table,    actions, shelf};
  EditingContext editingContext{{editor, view}, session, messages, colors,  layout,  tool,
                                shown,          editing, edits,    shadows, actions, keyboard};
};

/// A floor under two lights; a disc with a soft rim hides the first of them, "key", in the middle.
inline SolvedSet discSet(int width = 160, int height = 120) {
  SolvedSet set;
  set.capture.lights = {{"key", Role::Key, {}}, {"fill", Role::Fill, {}}};
  for (int i = 0; i < 2; ++i) set.contributions.emplace_back(ImageSpec::rgb(width, height));
  const float middleX = static_cast<float>(width) / 2, middleY = static_cast<float>(height) / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float far = std::hypot(static_cast<float>(x) - middleX, static_cast<float>(y) - middleY);
      const float visible = std::clamp((far - 22) / 6, 0.F, 1.F);
      for (int c = 0; c < 3; ++c) {
        set.contributions[0].span().at(c, x, y) = .5F * (.7F * visible + .02F);
        set.contributions[1].span().at(c, x, y) =
            .5F * (.3F + .1F * static_cast<float>(y) / static_cast<float>(height));
      }
    }
  updateBeta(set);
  return set;
}

/// The largest difference between two sets' contributions.
inline float largestDifference(const SolvedSet& a, const SolvedSet& b) {
  EXPECT_EQ(a.contributions.size(), b.contributions.size());
  float largest = 0;
  for (size_t i = 0; i < std::min(a.contributions.size(), b.contributions.size()); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < a.contributions[i].pixelCount(); ++p)
        largest =
            std::max(largest, std::abs(a.contributions[i].plane(c)[p] - b.contributions[i].plane(c)[p]));
  return largest;
}

}  // namespace swaplight::test

#include "ui/control/edit_controller.h"

#include <gmock/gmock.h>

#include "tests/support/studio_parts.h"

namespace swaplight {
namespace {

using test::StudioParts;
using testing::HasSubstr;

Edit fill(const std::string& light, float value) {
  Edit edit;
  edit.name = "fill " + light;
  edit.lights = {light};
  edit.energy = EnergyMode::Add;
  edit.operation = FillOperation{value};
  return edit;
}

const SolvedSet& solved(const StudioParts& studio) {
  return studio.session.set()->solved();
}

/// Frames until the picture is that of the document.
void settle(StudioParts& studio) {
  int quiet = 0;  // frames in which nothing happened
  uint64_t before = studio.edits.revision();
  studio.until("the edits do not come to rest", [&] {
    const bool changed = studio.edits.busy() || studio.edits.revision() != before;
    before = studio.edits.revision();
    quiet = changed ? 0 : quiet + 1;
    return quiet > 5;
  });
}

TEST(EditController, WithoutEditsTheSetIsShownAsItWasSolved) {
  StudioParts studio;
  studio.open(test::smallSet(3, 90, 60));
  for (int i = 0; i < 5; ++i) studio.frame();
  EXPECT_EQ(&solved(studio), studio.session.set()->original.get());
  EXPECT_FALSE(studio.edits.busy());
  EXPECT_EQ(studio.edits.revision(), 0U);
}

TEST(EditController, ThePictureFollowsTheDocumentAndUndo) {
  StudioParts studio;
  studio.open(test::smallSet(3, 300, 200));
  const auto original = studio.session.set()->original;
  const auto firstPicture = [&] {
    return studio.session.set()->live->pictures().contributions().front().identity();
  };
  const PictureIdentity solvedPicture = firstPicture();
  studio.append(fill("light2", 0.5F));
  settle(studio);
  const uint64_t first = studio.edits.revision();
  EXPECT_GT(first, 0U);
  EXPECT_FALSE(isSamePicture(firstPicture(), solvedPicture)) << "the edited set has pictures of its own";
  EXPECT_LT(test::largestDifference(solved(studio), applyEdits(*original, studio.editor.document().edits)),
            1e-6F);
  EXPECT_GT(test::largestDifference(solved(studio), *original), 0.01F);

  studio.append(fill("light1", 0));
  settle(studio);
  EXPECT_GT(studio.edits.revision(), first) << "whoever caches by it has to notice";
  EXPECT_GT(studio.renderer.changes, 0);
  EXPECT_LT(test::largestDifference(solved(studio), applyEdits(*original, studio.editor.document().edits)),
            1e-6F);

  studio.editor.undo();
  studio.editor.undo();
  settle(studio);
  EXPECT_EQ(test::largestDifference(solved(studio), *original), 0);
}

TEST(EditController, APreviewIsShownWhileTheGestureGoesOn) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  studio.edits.prepare();
  settle(studio);
  Document next = studio.editor.document();
  next.edits.append(fill("light1", 1));
  studio.editor.preview("Fill", next);
  settle(studio);
  EXPECT_LT(test::largestDifference(solved(studio), applyEdits(*studio.session.set()->original, next.edits)),
            1e-6F);
  studio.editor.cancel();
  settle(studio);
  EXPECT_EQ(test::largestDifference(solved(studio), *studio.session.set()->original), 0);
}

TEST(EditController, ANewLightIsAnotherSetToEverybody) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  studio.edits.prepare();
  settle(studio);
  const uint64_t before = studio.session.setRevision();
  Document next = studio.editor.document();
  next.edits.newLights = {"painted"};
  next.rig = fitRig(next.rig, withNewLights(studio.session.set()->original->capture, next.edits));
  studio.editor.edit("New light", next);
  settle(studio);
  EXPECT_GT(studio.session.setRevision(), before);
  EXPECT_EQ(solved(studio).lightCount(), 3);
  EXPECT_EQ(studio.session.set()->pictures().contributions().size(), 3U);
  EXPECT_EQ(studio.session.set()->original->lightCount(), 2) << "the set as solved never changes";
  studio.editor.undo();
  settle(studio);
  EXPECT_EQ(solved(studio).lightCount(), 2);
}

TEST(EditController, AnEditThatCannotBeAppliedIsSaidOnceAndTheOthersAre) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  EditStack good;
  good.append(fill("light1", 0.25F));
  studio.append(fill("light1", 0.25F));
  studio.append(fill("nobody", 1));
  settle(studio);
  EXPECT_THAT(studio.said(), HasSubstr("nobody"));
  EXPECT_EQ(studio.errors(), 1U);
  EXPECT_LT(test::largestDifference(solved(studio), applyEdits(*studio.session.set()->original, good)),
            1e-6F);
  for (int i = 0; i < 10; ++i) studio.frame();
  EXPECT_EQ(studio.errors(), 1U);
}

TEST(EditController, AnEditThatCannotBeAppliedLeavesTheOthersPrepared) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  studio.append(fill("light1", 0.25F));
  studio.append(fill("nobody", 1));
  settle(studio);
  const Edit& first = *studio.editor.document().edits.edits.front();
  const auto prepared = studio.edits.prepared(first);
  ASSERT_TRUE(prepared);
  studio.append(fill("light2", 0.5F));
  settle(studio);
  EXPECT_EQ(studio.edits.prepared(first), prepared)
      << "or its masks would be drawn at every step of a slider";
  EXPECT_EQ(studio.errors(), 1U);
}

TEST(EditController, ManyMasksThatTakeTheirTimeAreNeededAtOnce) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  Document next = studio.editor.document();
  for (int i = 0; i < 6; ++i) {
    Edit edit = fill("light1", 0.25F);
    edit.mask = {MaskShape{SimilarShape{SimilarShape::By::Color, 10 * i, 5, 0.05F, false}}};
    next.edits.append(edit);
  }
  studio.editor.edit("As a session has them", next);
  settle(studio);
  EXPECT_LT(test::largestDifference(
                solved(studio), applyEdits(*studio.session.set()->original, studio.editor.document().edits)),
            1e-6F);
}

TEST(EditController, ALightThatTheSetHasByNowIsNotAddedAgain) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  Document next = studio.editor.document();
  next.edits.newLights = {"light1"};
  studio.editor.edit("From a session of another set", next);
  settle(studio);
  EXPECT_THAT(studio.said(), HasSubstr("light1"));
  EXPECT_EQ(solved(studio).lightCount(), 2);
}

TEST(EditController, AnotherSetBeginsWithoutTheEditsOfTheLast) {
  StudioParts studio;
  studio.open(test::smallSet(2, 100, 80));
  studio.append(fill("light1", 1));  // its room may still be in the making
  studio.frame();
  studio.open(test::smallSet(3, 60, 50));
  settle(studio);
  EXPECT_EQ(solved(studio).lightCount(), 3);
  EXPECT_EQ(solved(studio).width(), 60);
  EXPECT_EQ(test::largestDifference(solved(studio), *studio.session.set()->original), 0);
}

TEST(EditController, FindsShadowsWhenAskedAndOnceForAll) {
  StudioParts studio;
  studio.open(test::discSet());
  EXPECT_EQ(studio.edits.shadows("key"), nullptr);
  EXPECT_TRUE(studio.edits.findingShadows());
  studio.until("no shadows", [&] { return studio.edits.shadows("key") != nullptr; });
  EXPECT_TRUE(studio.edits.shadowsCurrent());
  const auto key = studio.edits.shadows("key");
  EXPECT_NE(studio.edits.shadows("fill"), nullptr);
  EXPECT_EQ(studio.edits.shadows("nobody"), nullptr);
  EXPECT_FALSE(studio.edits.findingShadows());

  // Another threshold finds others; what was handed out does not change.
  const Image visibility = key->visibility.clone();
  Document next = studio.editor.document();
  next.edits.shadowThresholds["key"] = -1;
  studio.editor.edit("Threshold", next);
  EXPECT_FALSE(studio.edits.shadowsCurrent());
  studio.until("no other shadows", [&] { return studio.edits.shadowsCurrent(); });
  EXPECT_NE(studio.edits.shadows("key"), key);
  EXPECT_TRUE(std::equal(visibility.plane(0), visibility.plane(0) + visibility.pixelCount(),
                         key->visibility.plane(0)));
}

TEST(EditController, ALabelIsObeyedByTheSearch) {
  StudioParts studio;
  studio.open(test::discSet());
  studio.until("no shadows", [&] { return studio.edits.shadows("key") != nullptr; });
  const auto visible = [&] { return studio.edits.shadows("key")->visibility.view().at(0, 80, 60); };
  EXPECT_LT(visible(), .1F);
  Document next = studio.editor.document();
  next.edits.shadowMarks["key"] = {{ShadowMark::Kind::Lit, 80, 60}};
  studio.editor.edit("This is lit", next);
  EXPECT_FALSE(studio.edits.shadowsCurrent());
  studio.until("no other shadows", [&] { return studio.edits.shadowsCurrent(); });
  EXPECT_EQ(visible(), 1);
  studio.editor.undo();
  studio.until("the first ones", [&] { return studio.edits.shadowsCurrent(); });
  EXPECT_LT(visible(), .1F);
}

TEST(EditController, ASearchThatFailsIsSaidOnce) {
  StudioParts studio;
  studio.open(test::discSet());
  Document next = studio.editor.document();
  next.edits.shadowMarks["key"] = {{ShadowMark::Kind::Lit, 8000, 60}};
  studio.editor.edit("Of a larger picture", next);
  static_cast<void>(studio.edits.shadows("key"));
  studio.until("nothing is said", [&] { return studio.errors() > 0; });
  for (int i = 0; i < 50; ++i) {
    studio.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(studio.errors(), 1U) << studio.said();
  EXPECT_THAT(studio.said(), HasSubstr("8000, 60"));
}

TEST(EditController, AShadowsEditWaitsForTheShadows) {
  StudioParts studio;
  studio.open(test::discSet());
  Edit edit;
  edit.lights = {"key"};
  edit.energy = EnergyMode::Add;
  edit.operation = ShadowOperation{ShadowOperation::Kind::Lighten, 1, 12, {1, 1, 1}};
  studio.append(edit);
  settle(studio);
  studio.until("no shadows", [&] { return studio.edits.shadowsCurrent(); });
  settle(studio);
  const SolvedSet& now = solved(studio);
  const float before = studio.session.set()->original->contributions[0].view().at(1, 80, 60);
  EXPECT_GT(now.contributions[0].view().at(1, 80, 60), 3 * before)
      << "the middle of the disc's shadow is filled";
}

TEST(EditController, TheSearchCanBeStoppedAndTakenUpAgain) {
  StudioParts studio;
  studio.open(test::discSet(480, 360));
  EXPECT_EQ(studio.edits.shadows("key"), nullptr);
  studio.edits.stopFindingShadows();
  studio.until("the search does not stop", [&] { return !studio.edits.findingShadows(); });
  EXPECT_TRUE(studio.edits.stoppedFindingShadows());
  for (int i = 0; i < 5; ++i) studio.frame();
  EXPECT_FALSE(studio.edits.findingShadows()) << "nobody begins again by himself";
  studio.edits.findShadowsAgain();
  studio.until("no shadows", [&] { return studio.edits.shadows("key") != nullptr; });
}

TEST(EditController, AnotherThreadReadsAWholePictureWhileEditsGoOn) {
  StudioParts studio;
  studio.open(test::smallSet(3, 400, 300));
  studio.edits.prepare();
  settle(studio);
  const std::shared_ptr<LiveSet> live = studio.session.set()->live;
  std::atomic<bool> done{false};
  std::atomic<int> readings{0}, torn{0};
  std::thread reader([&] {
    while (!done) {
      const LiveSet::Reading seen = live->read();
      const auto& pictures = seen.pictures().contributions();
      if (pictures.size() != seen.set().contributions.size()) ++torn;
      for (size_t i = 0; i < pictures.size(); ++i) {
        // The largest level is the set's own pixels, and a fill makes all of them alike in beta.
        const auto level = pictures[i].level(0);
        float sum = 0;
        for (int y = 0; y < level.height; y += 16) sum += level.at(1, 5, y);
        if (!(sum >= 0)) ++torn;
      }
      ++readings;
    }
  });
  for (int k = 0; k < 40; ++k) {
    Document next = studio.editor.document();
    next.edits = {};
    next.edits.append(fill("light1", 0.01F * static_cast<float>(k)));
    if (k % 4 == 3) next.edits.newLights = {"painted"};
    studio.editor.edit("Fill", next);
    for (int i = 0; i < 3; ++i) studio.frame();
  }
  studio.until("nobody reads", [&] { return readings > 3; });
  done = true;
  reader.join();
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace swaplight

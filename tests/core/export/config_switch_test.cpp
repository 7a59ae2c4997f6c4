#include <gtest/gtest.h>

#include <future>
#include <thread>
#include <utility>

#include "core/export/frame_sequence.h"
#include "core/ocio/chosen_config.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

/// A configuration with the built-in's names that says other things by them: ACEScg has red and green
/// swapped, the view of sRGB is a square root.
constexpr const char* kOther = R"(ocio_profile_version: 2
name: other
roles: {default: raw, scene_linear: lin_rec709}
file_rules:
  - !<Rule> {name: Default, colorspace: raw}
displays:
  sRGB:
    - !<View> {name: sRGB, colorspace: root}
colorspaces:
  - !<ColorSpace> {name: lin_rec709}
  - !<ColorSpace>
    name: acescg
    to_scene_reference: !<MatrixTransform> {matrix: [0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}
  - !<ColorSpace>
    name: root
    from_scene_reference: !<ExponentTransform> {value: [0.5, 0.5, 0.5, 1]}
  - !<ColorSpace> {name: raw, isdata: true}
)";

class ConfigSwitch : public testing::Test {
 protected:
  ConfigSwitch() {
    test::writeBytes(m_file, kOther);
    for (Image& light : m_set->contributions) light.setColorSpace("acescg");
    m_rig = defaultRig(m_set->capture);
    m_rig.lights[0].color.kind = LightColor::Kind::LinearRgb;
    m_rig.lights[0].color.value = {1, .4F, .1F};
    m_options.display = {"sRGB", "sRGB"};
    m_options.write.pixelType = "float";
  }

  [[nodiscard]] Image frame(const std::string& name) const { return readImage(m_folder / name).image; }

  /// The frame as one configuration makes it.
  Image whole(const ColorConfig& config, const std::string& name) {
    exportFrame(config, *m_set, m_rig, m_folder / name, m_options);
    return frame(name);
  }

  const test::TemporaryFolder m_folder;
  const std::filesystem::path m_file = m_folder / "other.ocio";
  /// The one in use, as a studio keeps it: nobody else does.
  std::shared_ptr<const ColorConfig> m_config = sessionConfig({});
  std::shared_ptr<SolvedSet> m_set = std::make_shared<SolvedSet>(test::smallSet(2, 8, 6));
  Rig m_rig;
  FrameOptions m_options;
};

float difference(const Image& a, const Image& b) {
  float most = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      most = std::max(most, std::abs(a.plane(c)[p] - b.plane(c)[p]));
  return most;
}

TEST_F(ConfigSwitch, AFrameIsOfOneConfigurationWhateverIsChosenMeanwhile) {
  const Image own = whole(*m_config, "own.exr");
  const Image other = whole(*sessionConfig(m_file), "other.exr");
  ASSERT_GT(difference(own, other), .1F);

  std::promise<void> halfDone, chosen;
  std::thread exporting([&, config = m_config] {
    bool waited = false;
    Progress progress;
    progress.report = [&](float, std::string_view what) {
      if (what != "writing" || std::exchange(waited, true)) return;
      halfDone.set_value();  // the light is on the set, the view is still to come
      chosen.get_future().wait();
    };
    exportFrame(*config, *m_set, m_rig, m_folder / "meanwhile.exr", m_options, progress);
  });
  halfDone.get_future().wait();
  m_config = sessionConfig(m_file);
  chosen.set_value();
  exporting.join();
  EXPECT_EQ(difference(frame("meanwhile.exr"), own), 0)
      << "from the other it differs by " << difference(frame("meanwhile.exr"), other);
}

TEST_F(ConfigSwitch, TheFramesOfASequenceAreOfOneConfiguration) {
  SequenceOptions options{{1, 2, 3}, m_folder / "frame.%d.exr", m_options, 1, false, false};
  const auto input = [&](int) { return FrameInput{m_set, m_rig, {}, nullptr}; };
  const auto config = m_config;
  const SequenceSummary summary =
      exportSequence(*config, options, input, [&](const FrameOutcome&) { m_config = sessionConfig(m_file); });
  ASSERT_EQ(summary.count(FrameOutcome::State::Written), 3);
  EXPECT_EQ(difference(frame("frame.2.exr"), frame("frame.1.exr")), 0);
  EXPECT_EQ(difference(frame("frame.3.exr"), frame("frame.1.exr")), 0);
}

}  // namespace
}  // namespace swaplight

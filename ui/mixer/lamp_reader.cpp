#include "ui/mixer/lamp_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "core/balance/photograph.h"
#include "core/balance/reading_rig.h"
#include "core/base/error.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

/// "key -0.5 st, fill off".
std::string levels(const LampReading& reading) {
  std::vector<std::string> lamps;
  for (const ReadLamp& lamp : reading.lamps)
    lamps.push_back(lamp.on ? fmt::format("{} {:+.1f} st", lamp.light, std::log2(lamp.luminance))
                            : lamp.light + " off");
  return fmt::format("{}", fmt::join(lamps, ", "));
}

}  // namespace

void LampReader::start(std::shared_ptr<const ColorConfig> config, std::shared_ptr<const SolvedSet> set,
                       const std::filesystem::path& photograph) {
  m_set = set;
  m_name = photograph.filename().string();
  m_job.start(
      [config = std::move(config), set = std::move(set), photograph](const Progress& progress) {
        const CapturePixels pixels = loadPhotographOf(*config, *set, photograph, "", progress.part(0, 0.5F));
        try {
          return readLamps(*set, pixels, {}, progress.part(0.5F, 1));
        } catch (const InputError& error) {
          throw InputError("{}: {}", photograph.string(), error.what());
        }
      },
      m_wake);
}

void LampReader::update(LightsContext& studio) {
  takeOrReport(m_job, studio.messages, "this photograph", [&](const LampReading& reading) {
    const std::shared_ptr<const SolvedSet> set = std::exchange(m_set, nullptr);
    if (!studio.set() || studio.set()->original != set) return;
    studio.editor.commit();
    editRig(studio, "Read lamps from " + m_name,
            rigOfReading(*studio.colors.config(), studio.document().rig, *set, reading));
    studio.messages.info(fmt::format("Lamps read from {}: {}", m_name, levels(reading)));
    for (const std::string& warning : reading.warnings) studio.messages.warn(m_name + ": " + warning);
  });
}

}  // namespace swaplight

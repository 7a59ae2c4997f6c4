// How long a frame takes, from the lights' colours to pixels: on the graphics card (upload, relight,
// readback, show) and on the processor (straight to the window's 8-bit pixels). Prints tables in Markdown.
// Random pictures: the work does not depend on what is in them. Not measured: drawing the window itself.
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string_view>
#include <vector>

#include "core/base/parallel.h"
#include "core/ocio/color_config.h"
#include "core/relight/relight.h"
#include "core/view/display/display_table.h"
#include "core/view/window_pixels.h"
#include "render/gl/egl_context.h"
#include "render/gl/gl_info.h"
#include "render/relight_renderer.h"
#include "render/view_renderer.h"

namespace swaplight {
namespace {

struct Size {
  int width, height;
};
constexpr Size kFullHd{1920, 1080}, kUltraHd{3840, 2160};

SolvedSet syntheticSet(Size size, int lights) {
  SolvedSet set;
  uint32_t random = 7;
  for (int i = 0; i < lights; ++i) {
    set.capture.lights.push_back({fmt::format("light{}", i)});
    Image& image = set.contributions.emplace_back(ImageSpec::rgb(size.width, size.height));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        image.plane(c)[p] = static_cast<float>((random = random * 1664525 + 1013904223) >> 20) / 4095 /
                            static_cast<float>(lights);
  }
  set.beta = Image({size.width, size.height, {"beta"}, "data"}, 0);
  return set;
}

/// Milliseconds: the median, and the fastest, of many runs.
struct Times {
  double median = 0, best = 0;
};

/// Seconds since some moment: of the clock on the wall, or of work done by all threads of this process, which
/// other programs do not disturb.
bool countsWork = false;
double secondsNow() {
  timespec now{};
  clock_gettime(countsWork ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Times timed(const std::function<void(int run)>& work, int runs = 15) {
  std::vector<double> times;
  for (int run = -2; run < runs; ++run) {
    const double start = secondsNow();
    work(run);
    if (run >= 0) times.push_back(1000 * (secondsNow() - start));
  }
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times.front()};
}

std::string cell(const Times& times) {
  return fmt::format("{:.1f} ({:.1f})", times.median, times.best);
}

/// One light's colour changes from run to run, as under a slider.
std::vector<Rgb> factorsOf(int lights, int run) {
  std::vector<Rgb> factors(static_cast<size_t>(lights), Rgb(1));
  factors[0] = Rgb(1, 0.5F + 0.01F * static_cast<float>(run), 0.8F);
  return factors;
}

void graphicsTable() {
  const EglContext context;
  fmt::print("\n### Graphics: {}\n\n", glInfo().renderer);
  fmt::print("| picture | lights | upload | relight | readback | show |\n|---|---|---|---|---|---|\n");
  for (const Size size : {kFullHd, kUltraHd})
    for (const int lights : {2, 3, 4, 8}) {
      const SolvedSet set = syntheticSet(size, lights);
      RelightRenderer renderer(set);
      const ColorConfig config("");
      ViewRenderer viewer(config, "lin_rec709");
      ViewTarget target;
      const ViewWindow window{0, 0, fitZoom(size.width, size.height, 1920, 1080), 1920, 1080};
      const Times upload = timed(
          [&](int) {
            for (int i = 0; i < lights; ++i)
              renderer.updateContribution(i, set.contributions[static_cast<size_t>(i)].view(), 0, 0);
            finishGl();
          },
          5);
      const Times relit = timed([&](int run) {
        renderer.relight(factorsOf(lights, run));
        finishGl();
      });
      const Times readback = timed([&](int) { (void)renderer.readback(); }, 5);
      const Times shown = timed([&](int run) {
        viewer.draw(renderer.relight(factorsOf(lights, run)), window, {}, target);
        finishGl();
      });
      fmt::print("| {} x {} | {} | {} | {} | {} | {} |\n", size.width, size.height, lights, cell(upload),
                 cell(relit), cell(readback), cell({shown.median - relit.median, shown.best - relit.best}));
    }
}

void processorTable() {
  fmt::print("\n### Processor: {} threads\n\n", threadCount());
  fmt::print("| picture, window | lights | full frame, linear | one light changed, window, {} |",
             "plain sRGB");
  fmt::print(" the same, ACES |\n|---|---|---|---|---|\n");
  const ColorConfig config("");
  ViewSettings plain, film;
  for (const std::string& view : config.views(config.defaultDisplay())) {
    if (view.find("ACES") != std::string::npos) film.display.view = view;
    if (view == config.defaultDisplay()) plain.display.view = view;
  }
  const DisplayTable plainTable(config, "lin_rec709", plain), filmTable(config, "lin_rec709", film);
  for (const Size size : {kFullHd, kUltraHd})
    for (const int lights : {2, 3, 4, 8, 16}) {
      const SolvedSet set = syntheticSet(size, lights);
      std::vector<Pyramid> pyramids;
      for (const Image& image : set.contributions) pyramids.emplace_back(image.view());
      const ViewWindow window{0, 0, fitZoom(size.width, size.height, 1920, 1080), 1920, 1080};
      std::vector<uint8_t> codes(static_cast<size_t>(window.width) * static_cast<size_t>(window.height) * 4);
      LayerSum memory;
      const auto show = [&](const DisplayTable& table) {
        return timed([&](int run) {
          std::vector<ViewLayer> layers;
          layers.reserve(pyramids.size());
          for (int i = 0; i < lights; ++i)
            layers.push_back(
                {&pyramids[static_cast<size_t>(i)], factorsOf(lights, run)[static_cast<size_t>(i)]});
          windowPixels(
              layers, window,
              [&](const float* r, const float* g, const float* b, int count, uint8_t* rgba) {
                table.apply(r, g, b, count, rgba);
              },
              codes.data(), &memory);
        });
      };
      Image frame(ImageSpec::rgb(size.width, size.height));
      const Times full = timed([&](int run) { relight(set, factorsOf(lights, run), 1, frame.span()); });
      fmt::print("| {} x {} in 1920 x 1080 | {} | {} | {} | {} |\n", size.width, size.height, lights,
                 cell(full), cell(show(plainTable)), cell(show(filmTable)));
    }
}

}  // namespace
}  // namespace swaplight

// Arguments, all optional: processor, graphics (only that table), --work (time of work instead of the
// clock's).
int main(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const auto said = [&](std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  swaplight::countsWork = said("--work");
  fmt::print("Milliseconds{}: the median of 15 runs (the fastest).\n",
             swaplight::countsWork ? " of work, all threads together" : "");
  try {
    if (!said("graphics")) swaplight::processorTable();
    if (!said("processor")) swaplight::graphicsTable();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
  return 0;
}

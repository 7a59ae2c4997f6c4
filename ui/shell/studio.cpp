#include "ui/shell/studio.h"

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/diagnosis/crash_report.h"
#include "core/diagnosis/program_log.h"
#include "core/file/user_folders.h"
#include "core/image/io/image_io.h"
#include "core/ocio/color_config.h"
#include "render/gl/gl_info.h"
#include "ui/kit/imgui_session.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/shell/script.h"
#include "ui/shell/studio_window.h"
#include "ui/state/window_memory.h"

namespace swaplight {
namespace {

constexpr int kScreenshotFrames = 4;  // until every window has its size

void writeScreenshot(Window& window, const std::filesystem::path& file) {
  const auto [width, height, rgba] = window.pixels();
  Image image(ImageSpec::rgb(width, height));
  image.setColorSpace("srgb");
  for (size_t p = 0; p < image.pixelCount(); ++p)
    for (int c = 0; c < 3; ++c)
      image.plane(c)[p] = static_cast<float>(rgba[4 * p + static_cast<size_t>(c)]) / 255.0F;
  writeImage(image, file);
}

std::string firstError(const Messages& messages) {
  for (const Messages::Message& message : messages.messages())
    if (message.kind == Messages::Kind::Error) return message.text;
  return {};
}

void drawFrame(StudioWindow& studio, const StudioOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  studio.frame();
  std::this_thread::sleep_until(begin + std::chrono::duration<double>(options.frameSeconds));
}

void run(Window& window, StudioWindow& studio, const StudioOptions& options) {
  std::optional<Script> script;
  if (!options.script.empty())
    script.emplace(options.script, [&](const std::filesystem::path& file) { writeScreenshot(window, file); });
  if (script) window.keepPixels();
  bool drawn = false;
  int framesLeft = kScreenshotFrames;
  while (!studio.done()) {
    window.wait(studio.restSeconds());
    if (options.stop && *options.stop) return studio.leave();
    studio.update();
    const bool scripted = script && !script->done();
    if (scripted && drawn) script->step(studio);  // its first line may want a screenshot
    const bool busy = studio.busy();
    if (!busy && (scripted || !options.screenshot.empty())) window.requestFrames(1);
    if (window.frameWanted()) {
      drawFrame(studio, options);
      drawn = true;
    }
    if (options.screenshot.empty() || scripted || busy) continue;
    if (const std::string error = firstError(studio.context().messages); !error.empty())
      throw InputError(error);
    if (--framesLeft == 0) {
      writeScreenshot(window, options.screenshot);
      return;
    }
  }
}

/// For whoever reads a crash report afterwards.
void noteCircumstances(const ViewerContext& context) {
  const GlInfo graphics = glInfo();
  setCrashFact("graphics", graphics.renderer + ", OpenGL " + graphics.version);
  setCrashFact("engine", context.renderer.words());
  setCrashFact("colour", context.colors.config()->name());
  logLine("drawn by " + graphics.renderer);
}

void sayLastCrash(Messages& messages) {
  if (const auto report = unseenCrash(stateFolder() / "crash"))
    messages.errorThatStays(
        "Swaplight crashed when it was last used. To report it, send this file and what "
        "\"swaplight doctor\" prints: " +
        report->string());
}

std::unique_ptr<Window> openFor(const StudioOptions& options) {
  if (!options.screenshot.empty()) return openOffscreen(options.width, options.height);
  if (options.sizeGiven) return openWindow("Swaplight", options.width, options.height);
  const WindowMemory last = readWindowMemory(windowMemoryFile());
  return openWindow("Swaplight", last.width, last.height, last.maximized);
}

}  // namespace

void runStudio(const StudioOptions& options) {
  const ImGuiSession imgui;
  const std::unique_ptr<Window> window = openFor(options);
  applyTheme(options.scale > 0 ? options.scale : window->contentScale());
  if (!options.layoutProbe.empty()) probeLayout(options.layoutProbe);
  if (!options.script.empty()) rememberLayout();
  openProgramLog(stateFolder());
  logLine(std::string("swaplight ") + version() + " studio");
  StudioWindow studio(*window, options);
  noteCircumstances(studio.context());
  if (options.screenshot.empty()) sayLastCrash(studio.context().messages);
  if (!options.file.empty()) studio.open(options.file);
  run(*window, studio, options);
}

}  // namespace swaplight

#include <map>
#include <memory>

#include "app/program/interrupt.h"
#include "app/program/number_range.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "ui/bench/bench_paint.h"
#include "ui/bench/bench_tools.h"
#include "ui/bench/bench_ui.h"
#include "ui/shell/studio.h"

namespace swaplight {
namespace {

/// "1920x1080"
void readSize(const std::string& text, StudioOptions& options) {
  const size_t x = text.find('x');
  try {
    options.width = std::stoi(text.substr(0, x));
    options.height = std::stoi(text.substr(x + 1));
  } catch (const std::exception&) {
    options.width = 0;
  }
  if (x == std::string::npos || options.width < 320 || options.height < 240 || options.width > 16384 ||
      options.height > 16384)
    throw InputError("--size {}: write WIDTHxHEIGHT in pixels, from 320x240 to 16384x16384", text);
}

void sayCircumstances(const Json& json, Terminal& terminal) {
  terminal.say("{}, in a {} of {} x {}, {} lights, load {:.1f}", json["engine"].get<std::string>(),
               json["in"].get<std::string>(), json["window"][0].get<int>(), json["window"][1].get<int>(),
               json["lights"].get<int>(), json["load_before"][0].get<double>());
}

int bench(const StudioOptions& options, Terminal& terminal) {
  const Json json = benchUi(options);
  sayCircumstances(json, terminal);
  std::string table = fmt::format("{:<26}{:^27}{:^27}\n{:<26}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>14}\n",
                                  "milliseconds", "a frame", "input to picture", "", "median", "p95", "worst",
                                  "median", "p95", "worst", "all threads");
  for (const Json& one : json["cases"]) {
    table += fmt::format("{:<26}", one["case"].get<std::string>());
    for (const char* what : {"frame_ms", "latency_ms"})
      for (const char* part : {"median", "p95", "worst"})
        table += fmt::format("{:>9.1f}", one[what][part].get<double>());
    table += fmt::format("{:>14.1f}\n", one["processor_ms_a_frame"].get<double>());
    if (one.contains("exact_after_ms"))
      table += fmt::format("  at full size after {:.0f} ms\n", one["exact_after_ms"].get<double>());
  }
  table += fmt::format("most memory held: {} MB", json["peak_memory_mb"].get<long>());
  terminal.result(table, json);
  return 0;
}

int benchPainting(const StudioOptions& options, Terminal& terminal) {
  const Json json = benchPaint(options);
  sayCircumstances(json, terminal);
  std::string table;
  for (const Json& one : json["cases"]) {
    table += fmt::format("{}: {} edits, {} MB of history\n{:<28}{:>9}{:>9}{:>9}\n",
                         one["case"].get<std::string>(), one["edits"].get<int>(),
                         one["history_mb"].get<int>(), "  milliseconds", "median", "p95", "worst");
    for (const char* what : {"dab_ms", "undo_ms", "redo_ms"}) {
      table += fmt::format("  {:<26}", std::string(what).substr(0, std::string(what).find('_')));
      for (const char* part : {"median", "p95", "worst"})
        table += fmt::format("{:>9.1f}", one[what][part].get<double>());
      table += '\n';
    }
    const Json& save = one["save"];
    table += fmt::format("  saved after {:.0f} ms ({} KB), holding up a frame for {:.1f} ms at most\n",
                         save["until_saved_ms"].get<double>(), save["file_kb"].get<int>(),
                         save["longest_frame_ms"].get<double>());
  }
  table += fmt::format("most memory held: {} MB", json["peak_memory_mb"].get<long>());
  terminal.result(table, json);
  return 0;
}

int benchOtherTools(const StudioOptions& options, Terminal& terminal) {
  const Json json = benchTools(options);
  sayCircumstances(json, terminal);
  std::string table =
      fmt::format("{:<36}{:>14}{:>14}{:>14}", "milliseconds", "median frame", "longest frame", "until shown");
  for (const Json& one : json["steps"]) {
    const auto median = one.find("median_frame_ms");  // of drags
    table += fmt::format("\n{:<36}{:>14}{:>14.1f}{:>14.1f}", one["what"].get<std::string>(),
                         median == one.end() ? "" : fmt::format("{:.1f}", median->get<double>()),
                         one["longest_frame_ms"].get<double>(), one["until_shown_ms"].get<double>());
  }
  terminal.result(table, json);
  return 0;
}

}  // namespace

void addStudioVerb(Program& program) {
  struct Arguments {
    StudioOptions options;
    std::string size;
    bool bench = false;
    bool benchPaint = false;
    bool benchTools = false;
    [[nodiscard]] bool measures() const { return bench || benchPaint || benchTools; }
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App& verb = program.addVerb("studio", "Open the desktop studio", [a](Terminal& terminal) {
    readSize(!a->size.empty() ? a->size : a->measures() ? "1920x1080" : "1600x900", a->options);
    a->options.sizeGiven = !a->size.empty() || a->measures();
    a->options.samplesFolder = SWAPLIGHT_SAMPLES_DIR;
    if (a->bench) return bench(a->options, terminal);
    if (a->benchPaint) return benchPainting(a->options, terminal);
    if (a->benchTools) return benchOtherTools(a->options, terminal);
    a->options.stop = &interrupted();
    runStudio(a->options);
    if (interrupted()) return interruptExitCode();
    if (!a->options.screenshot.empty()) terminal.say("wrote {}", a->options.screenshot.string());
    terminal.result("", Json{{"screenshot", a->options.screenshot.string()}});
    return 0;
  });
  verb.add_option("FILE", a->options.file, "A capture, a solved set or a session");
  verb.add_option("--screenshot", a->options.screenshot,
                  "Render the studio's window to an image file; needs no display")
      ->type_name("PNG");
  verb.add_option(
          "--size", a->size,
          "Window size in pixels (default: as it was last, first 1600x900; 1920x1080 for measurements)")
      ->type_name("WxH");
  verb.add_option("--scale", a->options.scale, "Interface scale (default: the desktop's)")
      ->check(NumberRange(0.5, 4.0))
      ->type_name("X");
  const std::map<std::string, Engine> engines{
      {"auto", Engine::Auto}, {"graphics", Engine::Graphics}, {"processor", Engine::Processor}};
  verb.add_option("--engine", a->options.engine,
                  "Render engine: graphics, processor, or auto (the graphics card, if there is one)")
      ->transform(CLI::CheckedTransformer(engines).description(""))
      ->type_name("NAME");
  verb.add_flag(
      "--bench-ui", a->bench,
      "Measure frame times and input-to-picture latency while a slider is dragged over large pictures");
  verb.add_flag("--bench-paint", a->benchPaint,
                "Measure painting: 200 strokes at 3840x2160, from the mouse to the picture, undo, saving");
  verb.add_flag("--bench-tools", a->benchTools,
                "Measure a new light, selections, gradients and other edits at 3840x2160: for how long each "
                "holds up the window");
  verb.add_option("--script", a->options.script, "File of studio commands, one per line")->type_name("FILE");
  verb.add_option("--probe-layout", a->options.layoutProbe,
                  "Write the positions of named widgets to a JSON file, for tests")
      ->type_name("JSON");
  verb.add_option("--frame-seconds", a->options.frameSeconds, "Every frame takes at least as long, for tests")
      ->check(NumberRange(0.0, 10.0))
      ->group("");  // not in the help
}

}  // namespace swaplight

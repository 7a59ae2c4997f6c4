#include "core/set/set_color_space.h"
#include "ui/shell/studio_window.h"

namespace swaplight {
namespace {

constexpr double kZoomStep = 1.25;

}  // namespace

void StudioWindow::addViewActions() {
  const auto free = [this] { return m_session.hasDocument() && !ColorConfig::fromEnvironment(); };
  m_actions.add(
      {"view.color_config", "OpenColorIO configuration \u2026", "",
       "Displays, views and colour spaces from a file, for this session. $OCIO, where it is set, goes "
       "before.",
       [this] { askForColorConfig(); }, free});
  m_actions.add({"view.builtin_colors", "Built-in configuration", "",
                 "The displays and views that need no file.", [this] { useColorConfig({}); },
                 [this, free] { return free() && !m_editor.document().colorConfig.empty(); }});
  addWorkingSpaces();
  const auto shown = [this] { return m_shown.valid; };
  m_actions.add({"view.fit", "Fit", "F", "Show the whole picture.", [this] { m_view.showFit(); }, shown,
                 [this] { return m_shown.valid && m_view.fit; }});
  m_actions.add({"view.one_to_one", "Actual pixels", "1", "A pixel of the picture is a pixel of the screen.",
                 [this] { m_view.showAt(m_shown.window, 1); }, shown,
                 [this] { return !m_view.fit && m_view.zoom == 1; }});
  m_actions.add({"view.zoom_in", "Zoom in", "Ctrl++ Ctrl+=", "Larger, about the middle.",
                 [this] { m_view.showAt(m_shown.window, m_shown.window.zoom * kZoomStep); }, shown});
  m_actions.add({"view.zoom_out", "Zoom out", "Ctrl+-", "Smaller, about the middle.",
                 [this] { m_view.showAt(m_shown.window, m_shown.window.zoom / kZoomStep); }, shown});
  const auto channel = [&](const char* id, const char* name, const char* keys, ViewChannel which) {
    m_actions.add({id, name, keys, "Show this of the colour; again: all of it.",
                   [this, which] {
                     ViewChannel& now = m_view.settings.channel;
                     now = now == which ? ViewChannel::Color : which;
                   },
                   shown, [this, which] { return m_view.settings.channel == which; }});
  };
  channel("channel.all", "All channels", "A", ViewChannel::Color);
  channel("channel.red", "Red", "R", ViewChannel::Red);
  channel("channel.green", "Green", "G", ViewChannel::Green);
  channel("channel.blue", "Blue", "B", ViewChannel::Blue);
  channel("channel.luminance", "Luminance", "L", ViewChannel::Luminance);
  m_actions.add({"view.false_color", "False colour", "C", "Stops from middle grey as colours, with a legend.",
                 [this] { m_view.settings.falseColor = !m_view.settings.falseColor; }, shown,
                 [this] { return m_view.settings.falseColor; }});
  m_actions.add({"view.zebra", "Zebra", "Z",
                 "Stripes over what is too bright or too dark. Right-click the button for the levels.",
                 [this] { m_view.settings.zebra.on = !m_view.settings.zebra.on; }, shown,
                 [this] { return m_view.settings.zebra.on; }});
  m_actions.add({"view.neutral", "Reset exposure and gamma", "Shift+E",
                 "The viewer as the picture is exported.",
                 [this] {
                   m_view.settings.exposureStops = 0;
                   m_view.settings.gamma = 1;
                 },
                 [this, shown] { return shown() && !m_view.settings.neutral(); }});
  m_actions.add({"view.probe", "Probe", "P", "Tell about the place under the mouse, with each light's share.",
                 [this] { m_view.probe = !m_view.probe; }, shown, [this] { return m_view.probe; }});
  m_actions.add({"view.probe_size", "Size of the probe", "Shift+P", "1, 3, 5, 9 or 17 pixels a side.",
                 [this] {
                   int& side = m_view.probeSide;
                   side = side >= 17 ? 1 : side == 1 ? 3 : side == 3 ? 5 : 2 * side - 1;
                   m_view.probe = true;
                 },
                 shown});
}

void StudioWindow::addWorkingSpaces() {
  const auto add = [&](const std::string& space, const std::string& name, const std::string& tip) {
    m_actions.add({"working_space." + (space.empty() ? "own" : space), "Work in " + name, "",
                   tip + " White stays white; only coloured light looks different. Exported EXR are in it, "
                         "unless you choose their primaries.",
                   [this, space, name] {
                     Document next = m_editor.document();
                     next.workingSpace = space;
                     m_editor.edit("Work in " + name, std::move(next));
                   },
                   [this] { return m_session.set() != nullptr; },
                   [this, space] { return m_editor.document().workingSpace == space; }});
  };
  add("", "the photographs' colours", "Lights are multiplied in the primaries of the photographs.");
  add("lin_rec709", setColorSpaceWords("lin_rec709"),
      "Lights are multiplied in the primaries of sRGB and HD monitors, as Blender does.");
  add("acescg", setColorSpaceWords("acescg"),
      "Lights are multiplied in wider primaries, as renderers do in ACES pipelines: pure LED colours have "
      "room.");
}

}  // namespace swaplight

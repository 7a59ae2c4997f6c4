#include "ui/viewer/viewer_actions.h"

#include <algorithm>

#include "core/relight/rig.h"
#include "core/set/set_color_space.h"
#include "core/view/seen_exposure.h"

namespace swaplight {
namespace {

constexpr double kZoomStep = 1.25;

/// Of the relit picture; nothing where it is black.
std::optional<float> relitStopsToSee(const ViewerContext& studio) {
  const OpenSet& set = *studio.set();
  const Rig& rig = studio.document().rig;
  return stopsToSee(set.pictures().layers(
      {}, rigFactors(*studio.colors.config(), rig, set.solved().colorSpace()), rig.ambient));
}

void useColorConfig(ViewerContext& studio, const std::filesystem::path& file) {
  Document next = studio.document();
  next.colorConfig = file;
  const std::optional<ColorGrade> grade = next.display.grade;
  next.display = studio.session.openingViewIn(file);  // another configuration has other names
  next.display.grade = grade;
  studio.editor.edit("Colour configuration", std::move(next));
}

void askForColorConfig(ViewerContext& studio, FileChooser& chooser) {
  chooser.ask({"An OpenColorIO configuration for this session",
               "Use",
               {".ocio"},
               false,
               "",
               studio.document().colorConfig.parent_path(),
               [&studio](const std::filesystem::path& file) {
                 useColorConfig(studio, std::filesystem::absolute(file));
               }});
}

void addWorkingSpaces(ActionTable& actions, ViewerContext& studio) {
  const auto add = [&](const std::string& space, const std::string& name, const std::string& tip) {
    actions.add({"working_space." + (space.empty() ? "own" : space), "Work in " + name, "",
                 tip + " White stays white; only coloured light changes. EXR exports use it unless you "
                       "choose other primaries.",
                 [&studio, space, name] {
                   Document next = studio.document();
                   next.workingSpace = space;
                   studio.editor.edit("Work in " + name, std::move(next));
                 },
                 [&studio] { return studio.set() != nullptr; },
                 [&studio, space] { return studio.document().workingSpace == space; }});
  };
  add("", "the photographs' primaries", "Lights are mixed in the primaries of the photographs.");
  add("lin_rec709", setColorSpaceWords("lin_rec709"),
      "Lights are mixed in the primaries of sRGB and HD monitors, as in Blender.");
  add("acescg", setColorSpaceWords("acescg"),
      "Lights are multiplied in wider primaries, as renderers do in ACES pipelines: pure LED colours have "
      "room.");
}

}  // namespace

void addViewActions(ActionTable& actions, ViewerContext& studio, FileChooser& chooser) {
  const auto free = [&studio] { return studio.session.hasDocument() && !studio.colors.fromEnvironment(); };
  actions.add({"view.color_config", "OpenColorIO configuration \u2026", "",
               "Load displays, views and colour spaces for this session. $OCIO overrides this if it is set.",
               [&studio, &chooser] { askForColorConfig(studio, chooser); }, free});
  actions.add({"view.builtin_colors", "Built-in configuration", "",
               "Use the displays and views that come with Swaplight.",
               [&studio] { useColorConfig(studio, {}); },
               [&studio, free] { return free() && !studio.document().colorConfig.empty(); }});
  addWorkingSpaces(actions, studio);
  const auto shown = [&studio] { return studio.shown.valid; };
  actions.add({"view.fit", "Fit", "F", "Fit the picture to the viewer.", [&studio] { studio.view.showFit(); },
               shown, [&studio] { return studio.shown.valid && studio.view.fit; }});
  actions.add({"view.one_to_one", "Actual pixels", "1", "100 %: one image pixel per screen pixel.",
               [&studio] { studio.view.showAt(studio.shown.window, 1); }, shown,
               [&studio] { return !studio.view.fit && studio.view.zoom == 1; }});
  actions.add({"view.zoom_in", "Zoom in", "Ctrl++ Ctrl+=", "Zoom in about the centre.",
               [&studio] { studio.view.showAt(studio.shown.window, studio.shown.window.zoom * kZoomStep); },
               shown});
  actions.add({"view.zoom_out", "Zoom out", "Ctrl+-", "Zoom out about the centre.",
               [&studio] { studio.view.showAt(studio.shown.window, studio.shown.window.zoom / kZoomStep); },
               shown});
  const auto channel = [&](const char* id, const char* name, const char* keys, ViewChannel which,
                           const char* tip) {
    actions.add({id, name, keys, tip,
                 [&studio, which] {
                   ViewChannel& now = studio.view.settings.channel;
                   now = now == which ? ViewChannel::Color : which;
                 },
                 shown, [&studio, which] { return studio.view.settings.channel == which; }});
  };
  channel("channel.all", "All channels", "A", ViewChannel::Color, "View all channels.");
  channel("channel.red", "Red", "R", ViewChannel::Red, "View red only. Press again for all channels.");
  channel("channel.green", "Green", "G", ViewChannel::Green,
          "View green only. Press again for all channels.");
  channel("channel.blue", "Blue", "B", ViewChannel::Blue, "View blue only. Press again for all channels.");
  channel("channel.luminance", "Luminance", "L", ViewChannel::Luminance,
          "View luminance only. Press again for colour.");
  actions.add({"view.false_color", "False colour", "C",
               "Exposure as colours, in stops from middle grey, with a legend.",
               [&studio] { studio.view.settings.falseColor = !studio.view.settings.falseColor; }, shown,
               [&studio] { return studio.view.settings.falseColor; }});
  actions.add({"view.zebra", "Zebra", "Z",
               "Stripes over highlights and shadows beyond set levels. Right-click the button to set them.",
               [&studio] { studio.view.settings.zebra.on = !studio.view.settings.zebra.on; }, shown,
               [&studio] { return studio.view.settings.zebra.on; }});
  actions.add({"view.pools", "Light pools", "",
               "Where each light gathers on the set: the middle and the breadth of its pools, how far they "
               "stand out in stops, how many lamps they tell of; an arrow where a lamp's light goes on "
               "outside the picture.",
               [&studio] { studio.view.pools = !studio.view.pools; }, shown,
               [&studio] { return studio.view.pools; }});
  actions.add(
      {"view.expose", "Expose to see", "Ctrl+Shift+E",
       "Viewer exposure so that the brightest parts of the picture are bright: a dark set is seen, and "
       "exports stay as they are.",
       [&studio] {
         if (const auto stops = relitStopsToSee(studio))
           studio.view.settings.exposureStops = std::clamp(*stops, -20.0F, 20.0F);
       },
       shown});
  actions.add({"view.neutral", "Reset exposure and gamma", "Shift+E",
               "Viewer exposure and gamma off: matches the export.",
               [&studio] {
                 studio.view.settings.exposureStops = 0;
                 studio.view.settings.gamma = 1;
               },
               [&studio, shown] { return shown() && !studio.view.settings.neutral(); }});
  actions.add({"view.probe", "Probe", "P",
               "Pixel probe: values and each light's contribution under the pointer.",
               [&studio] { studio.view.probe = !studio.view.probe; }, shown,
               [&studio] { return studio.view.probe; }});
  actions.add({"view.probe_size", "Probe size", "Shift+P", "Average over 1, 3, 5, 9 or 17 pixels square.",
               [&studio] {
                 int& side = studio.view.probeSide;
                 side = side >= 17 ? 1 : side == 1 ? 3 : side == 3 ? 5 : 2 * side - 1;
                 studio.view.probe = true;
               },
               shown});
}

}  // namespace swaplight

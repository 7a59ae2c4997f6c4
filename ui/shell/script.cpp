#include "ui/shell/script.h"

#include <imgui.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "core/base/error.h"
#include "core/capture/no_such_light.h"
#include "core/file/atomic_file.h"
#include "core/relight/setting.h"
#include "ui/control/light_edit.h"
#include "ui/desk/studio_command.h"
#include "ui/kit/layout_probe.h"

namespace swaplight {
namespace {

constexpr int kDragSteps = 8;
constexpr int kSettleFrames = 3;  // Dear ImGui's windows take their size in the second frame

size_t lightIndex(const ViewerContext& studio, const std::string& name) {
  std::vector<std::string> names;
  for (const LightSetting& light : studio.document().rig.lights) names.push_back(light.light);
  return placeOfLight(names, name, "");
}

}  // namespace

Script::Script(const std::filesystem::path& file,
               std::function<void(const std::filesystem::path&)> screenshot)
    : m_name(file.string()), m_screenshot(std::move(screenshot)) {
  for (ScriptLine& line : scriptLines(readFile(file, 1 << 20))) m_lines.push_back(std::move(line));
}

void Script::step(StudioWindow& studio) {
  while (!done()) {
    if (m_frames > 0) {
      --m_frames;
      return;
    }
    if (studio.busy()) return;
    if (!m_mouse.empty()) {
      const MouseState mouse = m_mouse.front();
      m_mouse.pop_front();
      studio.window().pretendMouse(mouse.x, mouse.y, mouse.left, mouse.right);
      if (m_mouse.empty()) m_frames = kSettleFrames;
      return;
    }
    if (m_lines.empty()) return;
    const ScriptLine line = m_lines.front();
    m_lines.pop_front();
    try {
      if (!run(studio, line)) return;
    } catch (const InputError& error) {
      throw InputError("{}, line {}: {}", m_name, line.number, error.what());
    }
  }
}

bool Script::runMouse(const ScriptLine& line) {
  const std::string& command = line.command;
  const bool drags = command == "drag";
  if (!drags && command != "hover" && command != "click" && command != "menu") return false;
  const auto [item, places] = scriptPlaces(line);
  const auto rect = itemRect(item);
  if (!rect) throw InputError("{}: \"{}\" is not visible", command, item);
  const auto at = [&](float x, float y, bool left, bool right) {
    return MouseState{rect->x0 + x * (rect->x1 - rect->x0 - 1), rect->y0 + y * (rect->y1 - rect->y0 - 1),
                      left, right};
  };
  const bool right = command == "menu";
  m_mouse.push_back(at(places[0], places[1], false, false));
  m_mouse.push_back(m_mouse.back());
  if (command != "hover") m_mouse.push_back(at(places[0], places[1], !right, right));
  for (int step = 1; drags && step <= kDragSteps; ++step) {
    const float part = static_cast<float>(step) / kDragSteps;
    m_mouse.push_back(at(places[0] + part * (places[2] - places[0]),
                         places[1] + part * (places[3] - places[1]), true, false));
  }
  MouseState released = m_mouse.back();
  released.left = released.right = false;
  m_mouse.push_back(released);
  return true;
}

bool Script::run(StudioWindow& studio, const ScriptLine& line) {
  const auto& [number, command, argument] = line;
  ViewerContext& context = studio.context();
  if (command == "open") {
    studio.open(argument);
  } else if (command == "bring_in") {
    studio.bringIn(argument);
  } else if (command == "wait") {
    m_frames = kSettleFrames;
  } else if (command == "frames") {
    m_frames = scriptCount(line);
  } else if (command == "action") {
    if (!context.actions.run(argument)) throw InputError("there is no action \"{}\" to run now", argument);
  } else if (command == "select") {
    context.view.selectedLight = static_cast<int>(lightIndex(context, argument));
  } else if (command == "light") {
    const size_t space = argument.find(' ');
    const size_t index = lightIndex(context, argument.substr(0, space));
    const std::string text = space == std::string::npos ? "" : argument.substr(space + 1);
    Rig rig = context.document().rig;
    applySetting(rig.lights[index], text);
    editRig(context, argument, rig);
  } else if (command == "command") {
    runStudioCommand(studio.lights(), studio.cues(), argument);
  } else if (command == "save") {
    context.session.saveAs(argument);
  } else if (command == "export") {
    studio.exportFrame(argument);
  } else if (command == "screenshot") {
    m_screenshot(argument);
  } else if (command == "sleep") {
    std::this_thread::sleep_for(std::chrono::duration<double>(scriptSeconds(line)));
    return false;
  } else if (command == "say") {
    std::cerr << argument << std::endl;  // at once: somebody may be waiting for it
  } else if (command == "quit") {
    m_lines.clear();
    studio.quit();
  } else if (command == "type") {
    for (const char character : argument)
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(character));
    m_frames = kSettleFrames;
  } else if (runMouse(line)) {
    return false;
  } else {
    throw InputError("there is no command \"{}\"", command);
  }
  return m_frames == 0;
}

}  // namespace swaplight

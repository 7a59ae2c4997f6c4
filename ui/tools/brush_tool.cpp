#include "ui/tools/brush_tool.h"

#include <algorithm>
#include <cmath>

#include "core/edit/guide/edge_guide.h"
#include "core/edit/mask/selection.h"
#include "ui/control/light_edit.h"
#include "ui/kit/light_words.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/tools/new_light.h"
#include "ui/tools/pointer.h"

namespace swaplight {
namespace {

constexpr float kFirstRadius = 0.06F;  // of the picture's height
constexpr float kLeastRadius = 1, kMostRadius = 2000;
constexpr float kLeastStrokeStep = 0.5F;  // pixels of the picture between two points of a stroke
constexpr double kWheelStep = 1.12;

const Painting* paintingOf(const Edit& edit) {
  if (edit.mask.empty()) return nullptr;
  const auto* paint = std::get_if<PaintShape>(&edit.mask.front().shape);
  return paint ? paint->painting.get() : nullptr;
}

bool isFor(const Edit& edit, const std::string& light) {
  return edit.lights == std::vector<std::string>{light};
}

/// Whether two edits are restricted alike, whatever is painted in them.
bool sameLimits(const Edit& a, const Edit& b) {
  return std::equal(a.mask.begin() + 1, a.mask.end(), b.mask.begin() + 1, b.mask.end());
}

/// Whether a stroke can go into an edit that is there.
bool takesStroke(const Edit& edit, const Edit& wanted) {
  return paintingOf(edit) && edit.on && sameLimits(edit, wanted) && edit.lights == wanted.lights &&
         edit.energy == wanted.energy && edit.operation == wanted.operation;
}

/// Where the stroke goes: an edit of the list, or behind its end where a new one is needed; -1 where there is
/// nothing to erase.
int placeOfStroke(const EditingContext& studio, const Edit& wanted) {
  const EditsState& state = studio.editing;
  const auto& edits = studio.document().edits.edits;
  const int count = static_cast<int>(edits.size());
  const Edit* chosen =
      state.chosen >= 0 && state.chosen < count ? edits[static_cast<size_t>(state.chosen)].get() : nullptr;
  if (!state.brush.erase) {
    if (chosen) return takesStroke(*chosen, wanted) ? state.chosen : count;
    return count > 0 && takesStroke(*edits.back(), wanted) ? count - 1 : count;
  }
  // Within a selection only what was painted within the same one can be taken off.
  const auto erasable = [&](const Edit& edit) {
    return paintingOf(edit) && (studio.document().selection.empty() || sameLimits(edit, wanted));
  };
  if (chosen && erasable(*chosen)) return state.chosen;
  for (int i = count - 1; i >= 0; --i)
    if (erasable(*edits[static_cast<size_t>(i)]) &&
        isFor(*edits[static_cast<size_t>(i)], wanted.lights.front()))
      return i;
  return -1;
}

Stroke strokeOf(const EditingContext& studio) {
  const BrushState& brush = studio.editing.brush;
  Stroke stroke;
  stroke.radius = brushRadius(studio);
  stroke.hardness = brush.hardness;
  stroke.flow = brush.flow;
  stroke.opacity = brush.opacity;
  stroke.erase = brush.erase;
  stroke.edges = brush.edges;
  return stroke;
}

/// The painting with the guide of the set that is open: painted again where it had another, as from a file.
Painting guided(EditingContext& studio, const Painting& painting) {
  const std::shared_ptr<const SolvedSet>& set = studio.set()->original;
  std::shared_ptr<const EdgeGuide>& guide = studio.editing.brush.guide;
  if (!guide || !guide->isOf(*set)) guide = std::make_shared<const EdgeGuide>(set);
  return painting.guide() == guide ? painting : painting.guidedBy(guide);
}

void showStroke(EditingContext& studio) {
  const BrushState::Going& going = *studio.editing.brush.going;
  Edit edit = going.base;
  edit.mask.front().shape = PaintShape{std::make_shared<const Painting>(going.painting)};
  Document next = going.before;
  if (going.edit < next.edits.edits.size())
    next.edits.replace(going.edit, std::move(edit));
  else
    next.edits.append(std::move(edit));
  studio.editor.preview((studio.editing.brush.erase ? "Erase: " : "Paint: ") + going.base.name,
                        std::move(next));
}

/// Paint on a light that gives nothing now is kept, and shows later.
void sayWhatHides(EditingContext& studio) {
  const Rig& rig = studio.document().rig;
  const std::string words = unseenEditWords(rig, {rig.lights[shownLight(studio)].light}, "strokes");
  if (!words.empty()) studio.messages.info(words);
}

void beginStroke(EditingContext& studio, const StrokePoint& at) {
  BrushState& brush = studio.editing.brush;
  Edit wanted = brushEdit(studio);
  wanted.mask = maskWithin({{PaintShape{}, false}}, studio.document().selection);
  const int place = placeOfStroke(studio, wanted);
  if (place < 0) {
    studio.messages.info(studio.document().selection.empty()
                             ? "There is no paint on this light to erase."
                             : "Nothing was painted inside this selection. Ctrl+D clears it.");
    return;
  }
  sayWhatHides(studio);
  const ViewPictures& pictures = studio.set()->pictures();
  BrushState::Going going;
  going.before = studio.document();
  going.edit = static_cast<size_t>(place);
  if (going.edit < going.before.edits.edits.size()) {
    going.base = *going.before.edits.edits[going.edit];
    going.painting = *paintingOf(going.base);
  } else {
    going.base = wanted;
    going.painting = Painting(pictures.width(), pictures.height());
  }
  Stroke stroke = strokeOf(studio);
  if (stroke.edges || going.painting.followsEdges()) going.painting = guided(studio, going.painting);
  if (ImGui::GetIO().KeyShift && brush.last) stroke.points.push_back(*brush.last);
  stroke.points.push_back(at);
  going.painting.begin(std::move(stroke));
  brush.going = std::move(going);
  if (studio.editing.chosen != place) studio.editing.open = false;
  studio.editing.chosen = place;
  showStroke(studio);
}

void continueStroke(EditingContext& studio, const StrokePoint& at) {
  BrushState::Going& going = *studio.editing.brush.going;
  const StrokePoint& from = going.painting.strokes().back()->points.back();
  if (std::hypot(at.x - from.x, at.y - from.y) < kLeastStrokeStep) return;
  going.painting.add(at);
  showStroke(studio);
}

void endStroke(BrushState& brush) {
  brush.last = brush.going->painting.strokes().back()->points.back();
  brush.going.reset();
}

}  // namespace

float brushRadius(const EditingContext& studio) {
  const float chosen = studio.editing.brush.radius;
  return chosen > 0 ? chosen : kFirstRadius * static_cast<float>(studio.set()->pictures().height());
}

void setBrushRadius(EditingContext& studio, float radius) {
  studio.editing.brush.radius = std::clamp(radius, kLeastRadius, kMostRadius);
}

void addPaintedLight(EditingContext& studio) {
  Document next = studio.document();
  const std::string name = addNewLight(studio, "painted", next);
  studio.editing.brush.mode = BrushState::Mode::Add;
  studio.editing.brush.energy = EnergyMode::Add;
  studio.editing.brush.light = 1;  // as much as all others together: to be seen on a dark wall, too
  studio.editing.brush.erase = false;
  studio.tool = &kBrush;
  studio.editor.edit("New light: " + name, std::move(next));
}

Edit brushEdit(const EditingContext& studio) {
  const BrushState& brush = studio.editing.brush;
  const LightSetting& light = studio.document().rig.lights[shownLight(studio)];
  Edit edit;
  edit.lights = {light.light};
  edit.energy = brush.energy;
  switch (brush.mode) {
    case BrushState::Mode::Add:
      edit.name = "more " + light.title();
      edit.operation = GainOperation{1, brush.light};
      break;
    case BrushState::Mode::Remove:
      edit.name = "less " + light.title();
      edit.operation = FillOperation{0};
      break;
    case BrushState::Mode::Soften:
      edit.name = "softer " + light.title();
      edit.operation = BlurOperation{brush.softness};
      break;
    case BrushState::Mode::SetTo:
      edit.name = light.title() + " set";
      edit.operation = FillOperation{brush.level};
      break;
  }
  return edit;
}

namespace {

bool wantsBrush(const EditingContext& studio, const ToolInput& input) {
  return studio.editing.brush.going || (studio.tool == &kBrush && !input.alt && !input.moves);
}

bool handleBrush(EditingContext& studio, const ToolInput& input) {
  const ImGuiIO& io = ImGui::GetIO();
  BrushState& brush = studio.editing.brush;
  if (input.hovered && io.KeyCtrl && io.MouseWheel != 0)
    setBrushRadius(studio, brushRadius(studio) * static_cast<float>(std::pow(kWheelStep, io.MouseWheel)));
  // A gesture that was taken back in its middle has ended.
  if (brush.going && !studio.editor.inGesture()) brush.going.reset();
  const auto [x, y] = pointAtMouse(input.window, input.origin);
  const StrokePoint at{x, y, 1};
  if (input.hovered && !brush.going && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    beginStroke(studio, at);
  } else if (brush.going && io.MouseDown[ImGuiMouseButton_Left]) {
    continueStroke(studio, at);
  } else if (brush.going) {
    continueStroke(studio, at);
    endStroke(brush);
  }
  if (input.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  return true;
}

void drawBrushRing(EditingContext& studio, const ViewWindow& window, ImVec2 origin) {
  if (studio.tool != &kBrush || !studio.shown.hovered) return;
  const BrushState& brush = studio.editing.brush;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto ring = [&](float radius, float strength) {
    const float alpha = 90 + 150 * strength;
    draw->AddCircle(mouse, radius, IM_COL32(0, 0, 0, static_cast<int>(0.7F * alpha)), 0, px(3));
    draw->AddCircle(mouse, radius,
                    brush.erase ? IM_COL32(240, 160, 64, static_cast<int>(alpha))
                                : IM_COL32(255, 255, 255, static_cast<int>(alpha)),
                    0, px(1.2F));
  };
  const float radius = brushRadius(studio) * static_cast<float>(window.zoom);
  ring(std::max(radius, px(2)), 1);
  const float half = brush.hardness + 0.5F * (1 - brush.hardness);  // the smooth fall is half way there
  if (half * radius > px(4)) ring(half * radius, 0.2F);
  if (brush.going || !brush.last || !ImGui::GetIO().KeyShift) {
    draw->AddCircleFilled(mouse, px(1.5F), kText);
    return;
  }
  const ImVec2 from = onScreen(window, origin, brush.last->x, brush.last->y);
  draw->AddLine(from, mouse, IM_COL32(0, 0, 0, 150), px(3));
  draw->AddLine(from, mouse, kText, px(1));
}

}  // namespace

const PictureTool kBrushTool = {{&kBrush}, wantsBrush, handleBrush, drawBrushRing, PictureTool::kOwnCursor,
                                true};

}  // namespace swaplight

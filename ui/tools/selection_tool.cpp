#include "ui/tools/selection_tool.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/edit/mask/mask_outline.h"
#include "ui/control/light_edit.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/tools/pointer.h"

namespace swaplight {
namespace {

using Kind = SelectionState::Kind;

constexpr float kLeastLassoStep = 1.5F;  // pixels of the screen between two points of a lasso
constexpr float kLeastLassoWidth = 3;    // pixels of the screen: less is a line, not an area
constexpr float kLeastSelection = 3;     // pixels of the screen: less is a click
constexpr float kLeastEllipse = 0.5F;    // of an ellipse, pixels of the picture
constexpr float kDash = 5;               // pixels of the screen at scale 1
constexpr int kMarchSteps = 6;           // until a dash is where the next of its colour was
constexpr size_t kMostPoints = 30000;    // of an outline: more is noise
constexpr ImU32 kDark = IM_COL32(0, 0, 0, 220), kBright = IM_COL32(255, 255, 255, 235);

SelectHow howFromKeys() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyShift && io.KeyAlt) return SelectHow::Intersect;
  if (io.KeyShift) return SelectHow::Add;
  return io.KeyAlt ? SelectHow::Subtract : SelectHow::Replace;
}

/// What the points of a gesture enclose.
MaskShape drawnShape(Kind kind, const std::vector<Point>& points) {
  if (kind == Kind::Lasso) return {PolygonShape{points, 0}, false};
  const Point &a = points.front(), &b = points.back();
  const ShapeBox box{std::min(a[0], b[0]), std::min(a[1], b[1]), std::max(a[0], b[0]), std::max(a[1], b[1])};
  if (kind == Kind::Rectangle) {
    RectangleShape rectangle;
    rectangle.fit(box);
    return {rectangle, false};
  }
  EllipseShape ellipse;
  ellipse.fit(box);
  ellipse.radiusX = std::max(ellipse.radiusX, kLeastEllipse);
  ellipse.radiusY = std::max(ellipse.radiusY, kLeastEllipse);
  return {ellipse, false};
}

/// The shape that a click selects.
MaskShape clickedShape(const EditingContext& studio, const Point& at) {
  const SelectionState& state = studio.editing.selection;
  const auto x = static_cast<int>(std::floor(at[0])), y = static_cast<int>(std::floor(at[1]));
  if (state.kind == Kind::Similar)
    return {SimilarShape{state.by, x, y, state.tolerance, state.connected}, false};
  return {ShadowShape{studio.document().rig.lights[shownLight(studio)].light, true, x, y}, false};
}

void addPart(EditingContext& studio, MaskShape part, SelectHow how) {
  constexpr const char* kSteps[] = {"Select", "Add to selection", "Subtract from selection",
                                    "Intersect with selection"};
  changeSelection(studio, kSteps[static_cast<size_t>(how)],
                  selectionWith(studio.document().selection, std::move(part), how));
}

void click(EditingContext& studio, const Point& at, SelectHow how) {
  const ViewPictures& pictures = studio.set()->pictures();
  if (at[0] < 0 || at[1] < 0 || at[0] >= static_cast<float>(pictures.width()) ||
      at[1] >= static_cast<float>(pictures.height()))
    return;
  MaskShape part = clickedShape(studio, at);
  try {
    // A click into no shadow is told at once, and selects nothing.
    if (studio.editing.selection.kind == Kind::Similar || studio.edits.raster(part))
      addPart(studio, std::move(part), how);
    else
      studio.messages.info("Still finding the shadows. Click again in a moment.");
  } catch (const InputError&) {
    studio.messages.info("There is no shadow of " + studio.document().rig.lights[shownLight(studio)].title() +
                         " here. To use another light, select it in the mixer.");
  }
}

void finish(EditingContext& studio, const ViewWindow& window) {
  SelectionState& state = studio.editing.selection;
  const SelectionState::Going going = *std::exchange(state.going, std::nullopt);
  const Point& first = going.points.front();
  float far = 0;
  for (const Point& p : going.points)
    far = std::max({far, std::abs(p[0] - first[0]), std::abs(p[1] - first[1])});
  const auto zoom = static_cast<float>(window.zoom);
  const bool drawn = far * zoom >= kLeastSelection;
  if (drawn && state.kind == Kind::Lasso && PolygonShape{going.points, 0}.breadth() * zoom < kLeastLassoWidth)
    studio.messages.info("This lasso encloses nothing. Draw around what is to be selected.");
  else if (drawn)
    addPart(studio, drawnShape(state.kind, going.points), going.how);
  else if (going.how == SelectHow::Replace && !studio.document().selection.empty())
    changeSelection(studio, "Deselect", {});
}

/// Makes the outline of what is selected, where that is not the one that is there.
void follow(EditingContext& studio) {
  SelectionState& state = studio.editing.selection;
  const Mask& selection = studio.document().selection;
  if (state.outlineKnown && state.outlined == selection) return;
  state.outlineKnown = false;
  if (selection.empty()) {
    state.outline.clear();
    state.raster.reset();
  } else {
    try {
      const auto raster = studio.edits.raster(selection.front());
      if (!raster) return;  // as soon as there is room for edits, or the shadows are there
      state.raster = raster;
      state.outline = maskOutline(*raster);
    } catch (const InputError& error) {
      studio.messages.error(error.what());
      state.outline.clear();
    }
  }
  state.outlined = selection;
  state.outlineKnown = true;
}

/// How far the dashes have marched, as a part of a bright and a dark one: in steps, so that frames between
/// two steps are alike.
float marched() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  const auto step = std::chrono::duration_cast<std::chrono::milliseconds>(now) / kMarchStep % kMarchSteps;
  return static_cast<float>(step) / static_cast<float>(kMarchSteps);
}

/// A closed or open line in picture space as marching dashes of two colours: to be seen on bright and dark.
void drawDashes(const std::vector<Point>& line, bool closed, const ViewWindow& window, ImVec2 origin) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 low = draw->GetClipRectMin(), high = draw->GetClipRectMax();
  const float dash = px(kDash), thick = std::max(1.0F, px(1.2F));
  const auto at = [&](const Point& p) { return onScreen(window, origin, p[0], p[1]); };
  float along = 2 * dash * (1 - marched());
  for (size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const ImVec2 a = at(line[i]), b = at(line[(i + 1) % line.size()]);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const bool seen = std::max(a.x, b.x) >= low.x && std::min(a.x, b.x) <= high.x &&
                      std::max(a.y, b.y) >= low.y && std::min(a.y, b.y) <= high.y;
    for (float done = 0; seen && done < length;) {
      const float into = std::fmod(along + done, 2 * dash);
      const float here = std::min(length - done, (into < dash ? dash : 2 * dash) - into + 0.01F);
      const auto point = [&](float t) {
        return ImVec2(a.x + (b.x - a.x) * t / length, a.y + (b.y - a.y) * t / length);
      };
      draw->AddLine(point(done), point(done + here), into < dash ? kBright : kDark, thick);
      done += here;
    }
    along += length;
  }
}

std::vector<Point> ellipseLine(const Point& a, const Point& b) {
  constexpr int kSteps = 96;
  std::vector<Point> line;
  for (int i = 0; i < kSteps; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSteps;
    line.push_back({(a[0] + b[0]) / 2 + (b[0] - a[0]) / 2 * std::cos(angle),
                    (a[1] + b[1]) / 2 + (b[1] - a[1]) / 2 * std::sin(angle)});
  }
  return line;
}

std::vector<Point> goingLine(const SelectionState& state) {
  const std::vector<Point>& points = state.going->points;
  const Point& a = points.front();
  const Point& b = points.back();
  if (state.kind == Kind::Rectangle) return {a, {b[0], a[1]}, b, {a[0], b[1]}};
  return state.kind == Kind::Ellipse ? ellipseLine(a, b) : points;
}

}  // namespace

void changeSelection(EditingContext& studio, const std::string& step, Mask selection) {
  Document next = studio.document();
  next.selection = std::move(selection);
  studio.editor.edit(step, std::move(next));
}

void selectShadows(EditingContext& studio, const std::string& light) {
  addPart(studio, {ShadowShape{light, false, 0, 0}, false}, howFromKeys());
}

namespace {

bool wantsSelection(const EditingContext& studio, const ToolInput& input) {
  return studio.editing.selection.going ||
         (studio.tool == &kSelect && !input.moves && !studio.editing.dragging());
}

bool handleSelection(EditingContext& studio, const ToolInput& input) {
  const ViewWindow& window = input.window;
  SelectionState& state = studio.editing.selection;
  const Point at = pointAtMouse(window, input.origin);
  const bool clicks = state.kind == Kind::Similar || state.kind == Kind::Shadow;
  if (input.hovered && !state.going && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    if (clicks)
      click(studio, at, howFromKeys());
    else
      state.going = SelectionState::Going{howFromKeys(), {at}};
  } else if (state.going) {
    const Point& last = state.going->points.back();
    const float moved = std::hypot(at[0] - last[0], at[1] - last[1]) * static_cast<float>(window.zoom);
    if (moved >= kLeastLassoStep) state.going->points.push_back(at);
    if (!ImGui::GetIO().MouseDown[ImGuiMouseButton_Left]) finish(studio, window);
  }
  if (input.hovered) ImGui::SetMouseCursor(clicks ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_Arrow);
  return true;
}

void drawSelection(EditingContext& studio, const ViewWindow& window, ImVec2 origin) {
  follow(studio);
  SelectionState& state = studio.editing.selection;
  const Mask& selection = studio.document().selection;
  state.marching = !selection.empty() || state.going;
  size_t points = 0;
  for (const auto& line : state.outline) {
    points += line.size();
    if (points > kMostPoints) break;
    drawDashes(line, true, window, origin);
  }
  if (!selection.empty() && selection.front().invert) {
    const auto width = static_cast<float>(studio.set()->pictures().width());
    const auto height = static_cast<float>(studio.set()->pictures().height());
    drawDashes({{0, 0}, {width, 0}, {width, height}, {0, height}}, true, window, origin);
  }
  if (state.going) drawDashes(goingLine(state), state.kind != Kind::Lasso, window, origin);
}

}  // namespace

const PictureTool kSelectionTool = {{&kSelect}, wantsSelection, handleSelection, drawSelection};

}  // namespace swaplight

#include "ui/bench/bench_tools.h"

#include <algorithm>
#include <functional>

#include "core/base/json.h"
#include "core/edit/mask/drag_shape.h"
#include "core/edit/mask/selection.h"
#include "ui/bench/bench_stage.h"
#include "ui/control/look_edit.h"
#include "ui/tools/brush_tool.h"
#include "ui/tools/selection_tool.h"

namespace swaplight {
namespace {

constexpr int kWidth = 3840, kHeight = 2160;
constexpr int kMoves = 24;       // of the mouse, a drag
constexpr int kQuietFrames = 4;  // in which nothing changed: all is shown

/// What one thing takes.
class Stopwatch {
 public:
  Stopwatch(BenchStage& stage, Json& results) : m_stage(stage), m_results(results) {}

  void time(const char* what, const std::function<void(ViewerContext&)>& begin) {
    const auto start = BenchClock::now();
    begin(m_stage.studio().context());
    double longest = frame(start), until = longest;
    const EditController& edits = m_stage.studio().context().edits;
    for (int quiet = 0; quiet < kQuietFrames;) {
      const uint64_t before = edits.revision();
      longest = std::max(longest, frame(BenchClock::now()));
      const bool changed = m_stage.studio().busy() || edits.revision() != before;
      quiet = changed ? 0 : quiet + 1;
      if (changed) until = milliseconds(BenchClock::now() - start);
    }
    m_results.push_back({{"what", what}, {"longest_frame_ms", longest}, {"until_shown_ms", until}});
  }

  /// A shape dragged over the picture.
  void drag(const char* what, const Stencil& stencil) {
    Edit edit = brushEdit(m_stage.studio().context());
    const MaskShape shape = draggedShape(stencil, {400, 900}, {1800, 1300}, false);
    edit.mask = {shape};
    drag(what, edit, [&](Edit& moved, int move) {
      moved.mask.front() = movedShape(shape, 20.F * static_cast<float>(move), 7);
    });
  }

  /// An edit changed by `to` with each move of the mouse, from 1 to kMoves; the drag is a gesture.
  void drag(const char* what, Edit edit, const std::function<void(Edit&, int move)>& to) {
    ViewerContext& context = m_stage.studio().context();
    Document begun = context.document();
    begun.edits.append(edit);
    context.editor.edit(what, begun);
    settle();
    std::vector<double> frames;
    for (int move = 1; move <= kMoves; ++move) {
      const auto start = BenchClock::now();
      to(edit, move);
      Document next = begun;
      next.edits.replace(next.edits.edits.size() - 1, edit);
      context.editor.preview(what, std::move(next));
      frames.push_back(frame(start));
    }
    const Json all = statisticsOf(frames);
    const auto released = BenchClock::now();
    settle();
    m_results.push_back({{"what", what},
                         {"median_frame_ms", all["median"]},
                         {"longest_frame_ms", all["worst"]},
                         {"until_shown_ms", milliseconds(BenchClock::now() - released)}});
    context.editor.undo();
    context.editor.undo();
    settle();
  }

  [[nodiscard]] const LightsContext& lights() const { return m_stage.studio().lights(); }

  void settle() {
    const EditController& edits = m_stage.studio().context().edits;
    for (int quiet = 0; quiet < kQuietFrames;) {
      const uint64_t before = edits.revision();
      m_stage.drawFrame();
      quiet = m_stage.studio().busy() || edits.revision() != before ? 0 : quiet + 1;
    }
  }

 private:
  double frame(BenchClock::time_point since) {
    m_stage.drawFrame();
    return milliseconds(BenchClock::now() - since);
  }

  BenchStage& m_stage;
  Json& m_results;
};

Mask alike(SimilarShape::By by) {
  return selectionWith({}, {SimilarShape{by, kWidth / 2, kHeight / 3, 0.1F, true}, false},
                       SelectHow::Replace);
}

void addEverywhere(ViewerContext& context, const char* name, const Operation& operation) {
  Document next = context.document();
  Edit edit = brushEdit(context);
  edit.operation = operation;
  next.edits.append(std::move(edit));
  context.editor.edit(name, std::move(next));
}

void timeViews(Stopwatch& watch) {
  using Kind = ViewSubject::Kind;
  const auto look = [&](const char* what, Kind kind) {
    watch.time(what, [&](ViewerContext& context) { context.view.subject = {kind, 0}; });
  };
  look("beta shown", Kind::Beta);
  look("reflectance shown", Kind::Reflectance);
  look("residual shown", Kind::Residual);
  look("relit again", Kind::Relit);
  const auto open = [&](const char* what, bool PanelLayout::*panel) {
    watch.time(what, [&](ViewerContext& context) { context.layout.*panel = true; });
  };
  open("key, fill and back shown", &PanelLayout::threePoint);
  watch.time("a look of ten applied",
             [&](ViewerContext&) { applyPreset(watch.lights(), presetLooks().front()); });
  open("the gallery opened", &PanelLayout::gallery);
  open("the scopes opened", &PanelLayout::scopes);
}

void timeSelections(Stopwatch& watch) {
  watch.time("what is alike in colour selected", [](ViewerContext& context) {
    changeSelection(context, "Select", alike(SimilarShape::By::Color));
  });
  watch.time("its edge softened", [](ViewerContext& context) {
    changeSelection(context, "Soften", featheredSelection(context.document().selection, 80));
  });
  watch.time("what is alike in shares selected", [](ViewerContext& context) {
    changeSelection(context, "Select", alike(SimilarShape::By::Share));
  });
  watch.time("an edit inside of it", [](ViewerContext& context) {
    Document next = context.document();
    Edit edit = brushEdit(context);
    edit.mask = maskWithin({}, next.selection);
    next.edits.append(std::move(edit));
    context.editor.edit("Edit", std::move(next));
  });
  watch.time("nothing selected",
             [](ViewerContext& context) { changeSelection(context, "Select nothing", {}); });
}

template <typename Operation>
void dragLamp(Stopwatch& watch, const char* what, const std::string& light, float Operation::*value,
              float neutral, float step) {
  Edit edit;
  edit.name = what;
  edit.lights = {light};
  edit.energy = EnergyMode::Add;
  Operation operation;
  operation.*value = neutral;
  edit.operation = operation;
  watch.drag(what, edit, [&](Edit& moved, int move) {
    operation.*value = neutral + step * static_cast<float>(move);
    moved.operation = operation;
  });
}

void timeLamps(Stopwatch& watch, const std::string& light) {
  dragLamp(watch, "a lamp moved", light, &MoveOperation::right, 0, .01F);
  dragLamp(watch, "a lamp turned", light, &TurnOperation::pan, 0, 1);
  dragLamp(watch, "a lamp's beam narrowed", light, &SpreadOperation::width, 1, -.02F);
  dragLamp(watch, "a lamp made larger", light, &SizeOperation::times, 1, .1F);
}

}  // namespace

Json benchTools(const StudioOptions& options) {
  BenchStage stage(options);
  Json result = stage.circumstances();
  Json steps = Json::array();
  Stopwatch watch(stage, steps);
  stage.openAsItIs();
  watch.settle();
  timeLamps(watch, stage.small().capture.lights.front().name);
  stage.openLarge(kWidth, kHeight);
  watch.settle();
  const auto run = [&](const char* what, const char* action) {
    watch.time(what, [&](ViewerContext& context) { context.actions.run(action); });
  };
  run("the brush taken", "brush.take");
  run("a new light", "brush.new_light");
  run("the new light undone", "edit.undo");
  timeSelections(watch);
  Stencil stencil;
  stencil.shape = LinearGradientShape::info.name;
  watch.drag("a gradient dragged", stencil);
  stencil.shape = RadialGradientShape::info.name;
  watch.drag("a radial gradient dragged", stencil);
  stencil.shape = TextShape::info.name;
  watch.drag("text dragged", stencil);
  watch.time("a blur over all of it",
             [](ViewerContext& context) { addEverywhere(context, "Blur", BlurOperation{64}); });
  watch.time("a curve over all of it", [](ViewerContext& context) {
    addEverywhere(context, "Curve", CurveOperation{{{0, 0}, {0.5F, 0.3F}, {1, 1}}});
    context.editing.chosen = static_cast<int>(context.document().edits.edits.size()) - 1;
    context.editing.open = true;
  });
  timeViews(watch);
  result["steps"] = std::move(steps);
  return result;
}

}  // namespace swaplight

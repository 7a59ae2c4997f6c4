#include "ui/desk/cue_track.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/cue/cue_span.h"
#include "core/cue/cue_timeline.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kRuler = 18;                 // height
constexpr float kBlock = 40;                 // height
constexpr float kKeySide = 7;                // half of it
constexpr float kSpare = 1.05F;              // of the show: room to drag the last key
constexpr double kCoarse = .1, kFine = .01;  // seconds that a drag is rounded to; fine with Shift
constexpr ImU32 kSlope = IM_COL32(96, 152, 224, 120), kStanding = IM_COL32(96, 152, 224, 70);

/// How long a cue that waits for GO is drawn; the export's own hold is another matter.
double drawnHold() {
  return CueTiming{}.holdSeconds;
}

/// Seconds across the panel.
struct Axis {
  ImVec2 low, high;
  double seconds;

  [[nodiscard]] float x(double time) const {
    return low.x + static_cast<float>(time / seconds) * (high.x - low.x);
  }
  [[nodiscard]] double time(float at) const {
    return static_cast<double>((at - low.x) / (high.x - low.x)) * seconds;
  }
};

/// 0.1, 0.2, 0.5, 1 ... so that marks are not closer than a number is wide.
double tickOf(const Axis& axis) {
  const double least = axis.seconds * static_cast<double>(px(44) / (axis.high.x - axis.low.x));
  const double ten = std::pow(10, std::floor(std::log10(std::max(least, 1e-3))));
  for (const double of : {1.0, 2.0, 5.0})
    if (of * ten >= least) return of * ten;
  return 10 * ten;
}

void drawRuler(const Axis& axis) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double tick = tickOf(axis);
  for (int i = 0; i * tick < axis.seconds; ++i) {
    const float x = axis.x(i * tick);
    list->AddLine(ImVec2(x, axis.low.y + px(kRuler - 4)), ImVec2(x, axis.low.y + px(kRuler)), kFaint);
    const std::string words = fmt::format("{:g}{}", i * tick, i == 0 ? " s" : "");
    list->AddText(fonts().small, fonts().small->FontSize, ImVec2(x + px(2), axis.low.y), kFaint,
                  words.c_str());
  }
}

void drawBlock(const Axis& axis, const CueSpan& span, bool stands) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float top = axis.low.y + px(kRuler), bottom = top + px(kBlock);
  const float begin = axis.x(span.begins), stand = axis.x(span.stands), end = axis.x(span.ends);
  list->AddTriangleFilled(ImVec2(begin, bottom), ImVec2(stand, top), ImVec2(stand, bottom), kSlope);
  list->AddRectFilled(ImVec2(stand, top), ImVec2(end, bottom), stands ? kSlope : kStanding);
  list->AddLine(ImVec2(begin, bottom), ImVec2(stand, top), kAccent, px(1.5F));
  list->AddLine(ImVec2(stand, top), ImVec2(end, top), kAccent, px(1.5F));
  if (span.waits)  // a broken edge: nobody knows how long
    for (float y = top; y < bottom; y += px(8))
      list->AddLine(ImVec2(end, y), ImVec2(end, std::min(y + px(4), bottom)), kText, px(1.5F));
  list->PushClipRect(ImVec2(stand, top), ImVec2(std::max(end, stand), bottom), true);
  list->AddText(ImVec2(stand + px(6), top + px(4)), kText, cueNumberText(span.number).c_str());
  if (span.waits)
    list->AddText(fonts().small, fonts().small->FontSize, ImVec2(stand + px(6), top + px(22)), kFaint, "GO");
  list->PopClipRect();
}

/// A diamond to be dragged. True while it is held; then `time` is where.
bool key(const Axis& axis, const char* id, double at, float height, double* time) {
  const ImVec2 middle(axis.x(at), height);
  const float side = px(kKeySide);
  ImGui::SetCursorScreenPos(ImVec2(middle.x - side, middle.y - side));
  ImGui::InvisibleButton(id, ImVec2(2 * side, 2 * side));
  const bool held = ImGui::IsItemActive();
  const bool lit = held || ImGui::IsItemHovered();
  if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float r = px(lit ? 6.F : 5.F);
  list->AddNgonFilled(middle, r, held ? kAccent : IM_COL32(214, 214, 214, 255), 4);
  list->AddNgon(middle, r, IM_COL32(0, 0, 0, 200), 4, px(1));
  *time = axis.time(ImGui::GetIO().MousePos.x);
  return held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, px(2));
}

/// Where the show is, in seconds; nothing before the first GO.
std::optional<double> playHead(const std::vector<CueSpan>& spans, const CuePlayer& cues) {
  const auto now = std::find_if(spans.begin(), spans.end(),
                                [&](const CueSpan& span) { return cues.current() == span.number; });
  if (now == spans.end()) return std::nullopt;
  if (cues.fading()) return now->begins + static_cast<double>(cues.amount()) * (now->stands - now->begins);
  return cues.waiting() ? now->ends - static_cast<double>(cues.waitSeconds()) : now->stands;
}

}  // namespace

void CueTrack::draw(const LightsContext& studio, CuePlayer& cues) {
  const CueList list = studio.document().cues;  // a key may change it
  if (list.empty()) return;
  const std::vector<CueSpan> spans = cueSpans(list, drawnHold());
  if (!m_dragging) m_seconds = std::max(1.0, spans.back().ends * static_cast<double>(kSpare));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Axis axis{ImVec2(at.x + px(8), at.y),
                  ImVec2(at.x + ImGui::GetContentRegionAvail().x - px(8), at.y + px(kHeight)), m_seconds};
  drawRuler(axis);
  const float top = axis.low.y + px(kRuler), bottom = top + px(kBlock);
  for (const CueSpan& span : spans) drawBlock(axis, span, cues.current() == span.number);
  bool dragging = false;
  CueList next = list;
  std::string step;
  for (size_t i = 1; i < spans.size(); ++i) {
    const std::string number = cueNumberText(spans[i].number);
    const double grain = ImGui::GetIO().KeyShift ? kFine : kCoarse;
    double time = 0;
    ImGui::PushID(spans[i].number);
    if (key(axis, "##begin", spans[i].begins, bottom, &time)) {
      next = withCueBegin(list, spans[i].number, time, drawnHold(), grain);
      step = "Cue " + number + ": begin";
    }
    dragging |= ImGui::IsItemActive();
    markItem({"cue.", number, ".begin"});
    tooltip(fmt::format("Cue {} begins at {:.2f} s: drag to change how long the cue before stands{}. "
                        "Shift drags finely.",
                        number, spans[i].begins,
                        spans[i - 1].waits ? ", which then follows by itself instead of waiting for GO" : "")
                .c_str());
    if (key(axis, "##stand", spans[i].stands, top, &time)) {
      next = withCueStand(list, spans[i].number, time, drawnHold(), grain);
      step = "Cue " + number + ": fade";
    }
    dragging |= ImGui::IsItemActive();
    markItem({"cue.", number, ".stand"});
    tooltip(fmt::format("Cue {} stands at {:.2f} s: drag to change its fade. Shift drags finely.", number,
                        spans[i].stands)
                .c_str());
    ImGui::PopID();
  }
  m_dragging = dragging;
  if (const auto head = playHead(spans, cues))
    ImGui::GetWindowDrawList()->AddLine(ImVec2(axis.x(*head), axis.low.y),
                                        ImVec2(axis.x(*head), bottom + px(4)), kSolo, px(1.5F));
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + px(kHeight)));
  if (!step.empty() && next != list) {
    Document document = studio.document();
    document.cues = std::move(next);
    studio.editor.preview(step, std::move(document));
  }
}

}  // namespace swaplight

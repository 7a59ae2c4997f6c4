#include "ui/viewer/subject_menu.h"

#include <imgui.h>

#include <initializer_list>
#include <string>

#include "core/view/subject_image.h"
#include "ui/control/viewer_request.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

using Kind = ViewSubject::Kind;

/// The menu of one side.
class SubjectMenu {
 public:
  SubjectMenu(ViewerContext& studio, bool sideB)
      : m_studio(studio),
        m_set(studio.set()),
        m_subject(sideB ? studio.view.compare.subject : studio.view.subject) {}

  void line(const ViewSubject& subject, const char* tip = nullptr) const {
    const std::string words = subjectWords(m_studio, subject);
    if (ImGui::MenuItem(words.c_str(), nullptr, m_subject == subject)) m_subject = subject;
    markItem({"subject.", words});
    if (tip) tooltip(tip);
  }
  /// A line for each light that the set has of this.
  void eachLight(Kind kind, const char* tip = nullptr) const {
    const SolvedSet& of = kind == Kind::Visibility ? *m_set->original : m_set->solved();
    for (int light = 0; light < of.lightCount(); ++light) line({kind, light}, tip);
  }
  template <typename Lines>
  static void list(const char* name, const char* tip, const Lines& lines) {
    const bool open = ImGui::BeginMenu(name);
    markItem({"subject.", name});
    tooltip(tip);
    if (!open) return;
    lines();
    ImGui::EndMenu();
  }
  void ofLights() const {
    if (!m_set->solved().highlights.empty())
      list("Highlights", "What shines of each light, and the light without it.", [&] {
        eachLight(Kind::Highlight);
        ImGui::Separator();
        eachLight(Kind::Diffuse);
      });
    list("Beta maps", "Each light's share of every pixel, at unit white.", [&] { eachLight(Kind::Beta); });
    list("Visibility", "How much of each light a place sees: its shadows.",
         [&] { eachLight(Kind::Visibility); });
    list("Illumination", "The light on the set as if everything were painted one grey.", [&] {
      line({Kind::Lighting, 0},
           "The light on the set as you have set it, as if everything were painted one grey.");
      eachLight(Kind::Illumination,
                "This light on the set at unit white, without texture, as if everything were painted one "
                "grey. Large "
                "surfaces of another grey may still show.");
    });
  }
  void ofTheSolve() const {
    line({Kind::Reflectance, 0});
    list("Diagnostics", "How well the photographs fit, and how far each pixel can be trusted.", [&] {
      for (const Kind kind : {Kind::Residual, Kind::Sigma, Kind::Flags}) line({kind, 0});
    });
  }
  void photographs() const {
    for (int shot = 0; shot < m_set->solved().capture.shotCount(); ++shot) line({Kind::Photograph, shot});
  }

 private:
  ViewerContext& m_studio;
  const OpenSet* m_set;
  ViewSubject& m_subject;
};

/// The frame of B has a lighting of its own.
void frameLinesOfB(ViewerContext& studio) {
  CompareState& compare = studio.view.compare;
  const bool relit = compare.subject.kind == Kind::Relit;
  if (ImGui::MenuItem("Unit white", nullptr, relit && !compare.rig)) {
    compare.subject = {};
    compare.rig.reset();
  }
  markItem("subject_b.white");
  if (ImGui::MenuItem("Current lighting", nullptr, relit && compare.rig.has_value()))
    studio.actions.run("compare.keep");
  markItem("subject_b.now");
  tooltip("Stores the current lighting as B, to compare your changes with.");
}

}  // namespace

void drawSubjectMenu(ViewerContext& studio, bool sideB) {
  if (!studio.set()) return;
  const SubjectMenu menu(studio, sideB);
  if (sideB)
    frameLinesOfB(studio);
  else
    menu.line({});
  ImGui::Separator();
  menu.photographs();
  ImGui::Separator();
  menu.eachLight(Kind::Contribution);
  ImGui::Separator();
  menu.ofLights();
  menu.ofTheSolve();
}

}  // namespace swaplight

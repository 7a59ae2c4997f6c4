#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/edit/apply/edited_set.h"
#include "core/session/document_editor.h"
#include "render/viewport_renderer.h"
#include "ui/control/beta_reader.h"
#include "ui/control/found_shadows.h"
#include "ui/control/session_controller.h"
#include "ui/control/subject_pictures.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"
#include "ui/pictures/live_set.h"

namespace swaplight {

/// Sees to it that the studio shows the set with the document's edits. What is seen is computed at once, the
/// rest a little in each frame; what takes long (room for the edited set, finding shadows, drawing
/// selections) goes on in threads, and the picture follows when it is there. Until then it may lack lights
/// that the rig has, or have one more.
class EditController {
 public:
  /// What it follows, and what it tells. All outlive it.
  struct Parts {
    const DocumentEditor& editor;
    SessionController& session;
    SubjectPictures& subjects;
    ViewportRenderer& renderer;
    Messages& messages;
  };
  EditController(const Parts& parts, std::function<void()> wake)
      : m_parts(parts), m_wake(std::move(wake)), m_files(m_wake) {}

  /// To be called at the beginning of each frame: turns to the set that is open, takes what threads have
  /// made.
  void beginFrame();
  /// To be called in each frame when nothing more is edited in it, before the picture is drawn. `visible`:
  /// the part of it that is seen.
  void show(const PixelRect& visible);
  /// Makes room for edits before the first one is there, so that a stroke need not wait.
  void prepare();

  /// A light's shadows, of the set as solved; begins to look for them where nobody has yet: nullptr until
  /// they are there. For what the document says of them, or still for what it said before.
  std::shared_ptr<const LightShadows> shadows(const std::string& light);
  /// A shape of a mask as pixels; nullptr while there is no room for edits, the shadows are being looked
  /// for or the shape is being drawn, and for shapes that are formulas. Throws InputError as MaskContext
  /// does.
  std::shared_ptr<const MaskRaster> raster(const MaskShape& shape);
  /// An edit of the document as it runs; nullptr until it does. For the interface's thread.
  [[nodiscard]] std::shared_ptr<const PreparedEdit> prepared(const Edit& edit) const {
    return m_room.edited ? m_room.edited->prepared(&edit) : nullptr;
  }
  /// The mean colour, as shown at unit white, of what a mask lets through; 1 while it is being drawn.
  [[nodiscard]] Rgb surfaceColor(const Mask& mask);
  /// Whether shadows() are for what the document says of them.
  [[nodiscard]] bool shadowsCurrent() const;
  [[nodiscard]] bool findingShadows() const { return m_finding.running(); }
  [[nodiscard]] float findingFraction() const { return m_finding.fraction(); }
  /// What of the document keeps an edit from placing its lamps, in words; nothing where all is told. A set is
  /// open.
  [[nodiscard]] std::optional<std::string> whyNotPlaced(const Edit& edit) const;
  /// A lamp that edits have added, to which none of them gives light: none is on, or it has no place yet.
  [[nodiscard]] bool isUnlit(const std::string& light) const;
  /// How surfaces are turned is being found, for the document's edits that go by it.
  [[nodiscard]] bool findingSurfaces() const { return m_surfacing.running(); }
  /// Stops looking for shadows until somebody asks again.
  void stopFindingShadows();
  [[nodiscard]] bool stoppedFindingShadows() const { return m_stopped && !m_finding.running(); }
  void findShadowsAgain() { m_stopped = false; }
  /// The beta maps that edits take from files.
  [[nodiscard]] BetaReader& files() { return m_files; }
  [[nodiscard]] const BetaReader& files() const { return m_files; }
  /// Reads the files of the document's edits again: somebody has changed them.
  void readFilesAgain();
  /// Something goes on after which the picture changes.
  [[nodiscard]] bool busy() const {
    return m_making.running() || m_finding.running() || m_surfacing.running() || m_drawing.running() ||
           m_files.reading();
  }
  /// Counts up whenever pixels have changed.
  [[nodiscard]] uint64_t revision() const { return m_revision; }

 private:
  /// An edited set, and what others see of it.
  struct Room {
    std::shared_ptr<EditedSet> edited;
    std::shared_ptr<LiveSet> live;  ///< of its result
  };
  struct FoundOf {
    std::shared_ptr<const SolvedSet> set;
    ShadowOptions options;
    ShadowsByLight found;
  };

  /// What surfaces are found by.
  struct SurfacesFor {
    LampPlaces places;
    ShadowOptions shadows;
    bool operator==(const SurfacesFor&) const = default;
  };
  struct SurfacesOf {
    std::shared_ptr<const SolvedSet> set;
    SurfacesFor by;
    FoundSurfaces::Surfaces found;
  };

  void follow();
  void takeJobs();
  void takeDrawn();
  void keepDrawn(std::shared_ptr<const MaskRaster> raster);
  /// The shape that was being drawn cannot be.
  void failDrawn();
  /// Of more than a few those that the stack does not need: all that it needs have to be there at once.
  void dropDrawn(const EditStack& stack);
  [[nodiscard]] static Room makeRoom(std::shared_ptr<const SolvedSet> set,
                                     std::shared_ptr<FoundShadows> found,
                                     std::shared_ptr<FoundSurfaces> surfaces);
  void adopt(Room room);
  /// Looks for shadows where somebody needs them and there are none for what the document says now.
  void seekShadows();
  /// Looks for how surfaces are turned, where an edit of the document goes by it and enough is told.
  void seekSurfaces();
  /// Whether the edit can place its lamps by the surfaces that were found.
  [[nodiscard]] bool isPlaced(const Edit& edit) const;
  /// What of the document can be shown now.
  [[nodiscard]] EditStack usable(const EditStack& wanted);
  /// Whether the shape is drawn, or is drawn at once where it is asked for; else begins to draw it.
  bool isDrawn(const MaskShape& shape);
  /// Whether all that the stack needs is drawn and read; else begins to.
  bool isReady(const EditStack& stack);
  void setStack(const EditStack& stack);
  /// As much of the stack as can be applied.
  void applyStack(const EditStack& stack);
  /// Whether it could be applied.
  bool tryStack(const EditStack& stack);
  void update(const PixelRect& visible);
  void refresh(LiveSet::Writing& writing, const std::vector<PixelRect>& changed, const LightIndices& lights);

  /// A selection that was drawn in a thread.
  struct Drawn {
    MaskShape shape;
    std::shared_ptr<const MaskRaster> raster;  ///< nullptr: it cannot be drawn
  };

  Parts m_parts;
  std::function<void()> m_wake;
  std::shared_ptr<const SolvedSet> m_set;  ///< as solved
  Room m_room;
  EditStack m_wanted;  ///< the document's when it was looked at last
  bool m_followed = false;
  std::shared_ptr<FoundShadows> m_found = std::make_shared<FoundShadows>();  ///< of m_set
  ShadowOptions m_foundFor;                                                  ///< what they were found for
  ShadowOptions m_findingFor;                                                ///< what they are looked for
  std::shared_ptr<FoundSurfaces> m_surfaces = std::make_shared<FoundSurfaces>();  ///< of m_set
  SurfacesFor m_surfacesBy, m_surfacingBy;             ///< what they were, are found by
  bool m_needsShadows = false;                         ///< somebody has asked for them
  bool m_stopped = false;                              ///< the person has stopped the search
  bool m_filesStale = false;                           ///< files of edits have to be read again
  std::string m_complaint;                             ///< about the edits, said already
  std::vector<std::shared_ptr<const Edit>> m_refused;  ///< those that could not be applied last time
  uint64_t m_revision = 0;
  int m_part = 0;             ///< of the picture that is computed next
  std::deque<Drawn> m_drawn;  ///< the last ones, and what is needed: kept until somebody uses them
  MaskShape m_drawingShape;
  bool m_drawingStale = false;  ///< the set or its shadows have changed since
  Job<std::shared_ptr<const MaskRaster>> m_drawing;
  Job<Room> m_making;
  Job<FoundOf> m_finding;
  Job<SurfacesOf> m_surfacing;
  BetaReader m_files;
};

}  // namespace swaplight

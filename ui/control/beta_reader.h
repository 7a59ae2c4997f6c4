#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/edit/apply/prepared_edit.h"
#include "core/edit/stack/beta_files.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"

namespace swaplight {

/// Reads the beta maps that edits take from files, in a thread: those of the document's edits, and one that a
/// person has chosen, which becomes an edit only if it is right.
class BetaReader {
 public:
  explicit BetaReader(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// Reads what the edit would take from its file; then calls `then`, or says what is wrong with it.
  void choose(const Edit& edit, const EditedLights& lights, std::function<void()> then);
  /// Takes what was read. To be called in each frame.
  void update(Messages& messages);
  /// Whether `files` know what an edit of the document asks for; else begins to read it.
  bool isRead(const BetaRequest& request, BetaFiles& files);
  /// `files` have taken what they need.
  void release() { m_kept.clear(); }
  /// Another set is open.
  void forget();

  [[nodiscard]] bool reading() const { return m_job.running(); }
  /// A person waits for it, and can stop it.
  [[nodiscard]] bool choosing() const { return m_chosen.has_value(); }
  [[nodiscard]] float fraction() const { return m_job.fraction(); }
  /// The one that was chosen does not become an edit, even where it has been read by now.
  void stop() {
    m_job.cancel();
    m_chosen.reset();
  }

 private:
  using Maps = std::shared_ptr<const BetaMaps>;
  struct Kept {
    BetaRequest request;
    Maps maps;            ///< nullptr: they cannot be read
    std::string refusal;  ///< why
  };
  struct Chosen {
    Edit edit;
    EditedLights lights;
    std::function<void()> then;
  };
  void start(const BetaRequest& request);
  void keep(Maps maps, const std::string& refusal);

  std::function<void()> m_wake;
  std::vector<Kept> m_kept;  ///< until somebody holds them
  BetaRequest m_request;     ///< what is read now
  std::optional<Chosen> m_chosen;
  Job<Maps> m_job;
};

}  // namespace swaplight

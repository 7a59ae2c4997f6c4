#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/edit/apply/gel_mixing.h"
#include "core/edit/apply/lamp_edit.h"
#include "core/edit/apply/shadow_change.h"
#include "core/edit/mask/prepared_mask.h"
#include "core/edit/placing/placed_change.h"
#include "core/edit/stack/beta_files.h"
#include "core/edit/stack/edit.h"

namespace swaplight {

/// The set that edits act on, by names and size.
struct EditedLights {
  std::vector<std::string> names;  ///< the set's lights, then the new ones
  int width = 0;
  int height = 0;
  LampPlaces places = {};  ///< where lamps of the set's lights stood
};

/// An edit ready to run: names are indices, masks and pictures are drawn, curves are tables.
struct PreparedEdit {
  std::shared_ptr<const Edit> edit;
  std::vector<int> lights;  ///< those chosen, ascending
  std::shared_ptr<const PreparedMask> mask;
  std::vector<float> table;              ///< what the operation tabulates
  std::shared_ptr<const BetaMaps> beta;  ///< of the chosen lights, for BetaMapOperation
  std::vector<ShadowChange> shadows;     ///< one a chosen light, for ShadowOperation
  std::vector<LampEdit> lamps;           ///< one a chosen light, for edits of lamps
  std::vector<PlacedChange> placed;      ///< one a chosen light, for PlaceOperation
  GelMixing gel;                         ///< for UnknownGelOperation

  /// Does it do anything?
  [[nodiscard]] bool isActive() const { return edit->on && edit->opacity > 0; }
  /// How many pixels around it a pixel looks; 0 where the edit is not active.
  [[nodiscard]] int reach() const;
};

/// Which maps an edit takes from a file; nothing where it takes none. Throws InputError for an unknown light.
[[nodiscard]] std::optional<BetaRequest> betaRequest(const Edit& edit, const EditedLights& lights);
/// Whether such maps suit the edit. Throws InputError as checkProportions does.
void checkBeta(const Edit& edit, const EditedLights& lights, const BetaMaps& beta);

/// `earlier`, if there is one, is what the edit was before: what has not changed is taken from it. Throws
/// InputError: an unknown light (the known ones listed), a picture that does not fit, a curve that is none.
[[nodiscard]] PreparedEdit prepareEdit(std::shared_ptr<const Edit> edit, const EditedLights& lights,
                                       MaskContext& context, BetaFiles& files,
                                       const PreparedEdit* earlier = nullptr);

}  // namespace swaplight

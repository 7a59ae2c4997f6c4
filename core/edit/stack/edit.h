#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/edit/mask/mask.h"
#include "core/edit/operations/operations.h"
#include "core/normals/lamp_place.h"
#include "core/shadow/result/shadow_options.h"

namespace swaplight {

/// What happens to the other lights.
enum class EnergyMode {
  Redistribute,  ///< light is moved: what one light gets the others lose; the sum at unit white stays
  Add,           ///< light is added, or taken away; the others stay
};

/// One step of the stack. Immutable once it is in a stack.
struct Edit {
  std::string name;
  bool on = true;
  float opacity = 1;                             ///< 0..1
  std::vector<std::string> lights;               ///< names; empty: all
  EnergyMode energy = EnergyMode::Redistribute;  ///< of edits that act on beta
  Operation operation;
  Mask mask;
  bool operator==(const Edit&) const = default;
};

/// The edits in order, first applied first, and lights that the edits add to the set (they start without
/// light). A value: copies share what they have in common, so that keeping one is undo.
struct EditStack {
  std::vector<std::shared_ptr<const Edit>> edits;
  std::vector<std::string> newLights;
  int width = 0, height = 0;  ///< of the picture that the masks are for: see fitEdits; 0: nobody has said
  /// Where a light's shadows begin (ShadowOptions::thresholds); a light that is not named finds it by itself.
  std::map<std::string, float> shadowThresholds;
  /// What is said of single places of a light's shadows (ShadowOptions::marks).
  ShadowMarksByLight shadowMarks;
  /// Where the lamps of the set's lights stood: what edits need that go by how surfaces are turned.
  LampPlaces lampPlaces;

  void append(Edit edit) { edits.push_back(std::make_shared<const Edit>(std::move(edit))); }
  void replace(size_t index, Edit edit) { edits[index] = std::make_shared<const Edit>(std::move(edit)); }
  /// Compares what the edits say.
  bool operator==(const EditStack& other) const;
};

/// Bytes that the stack holds and `before` does not share: what it costs to keep both.
[[nodiscard]] size_t editBytes(const EditStack& stack, const EditStack& before);

[[nodiscard]] Json jsonFromEditStack(const EditStack& stack);
/// `width` and `height` of the picture that the masks are for. `warnings`, if there are any: says in them
/// which keys of the stack and its edits are unknown. Throws InputError that says where.
[[nodiscard]] EditStack editStackFromJson(const Json& json, int width, int height,
                                          const std::string& where = "edits",
                                          std::vector<std::string>* warnings = nullptr);
/// The stack with every file that it names by another name.
[[nodiscard]] EditStack withFiles(const EditStack& stack,
                                  const std::function<std::string(const std::string&)>& rename);
/// Every file that the stack names: pictures, beta maps.
[[nodiscard]] std::vector<std::filesystem::path> filesOfEdits(const EditStack& stack);
/// The stack for a picture of this size: strokes are painted again where it is another.
[[nodiscard]] EditStack fitEdits(const EditStack& stack, int width, int height);
/// What the stack says of how shadows are to be found.
[[nodiscard]] ShadowOptions shadowOptionsOf(const EditStack& stack);
/// Whether something in it needs the lights' shadows.
[[nodiscard]] bool usesShadows(const Edit& edit);
[[nodiscard]] bool usesShadows(const Mask& mask);
/// Whether it needs to know how surfaces are turned (and so the lights' shadows).
[[nodiscard]] bool usesSurfaces(const Edit& edit);

}  // namespace swaplight

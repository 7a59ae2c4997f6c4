#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/color/rgb.h"
#include "core/edit/mask/mask.h"

namespace swaplight {

// What an edit does to beta, the proportion of a light. Beta is measured in the set as solved: 1 is all of
// the all-white picture at that pixel.

/// beta = value. 0 clears.
struct FillOperation {
  float value = 1;
  bool operator==(const FillOperation&) const = default;
};
/// beta = gain * beta + offset.
struct GainOperation {
  float gain = 1;
  float offset = 0;
  bool operator==(const GainOperation&) const = default;
};
/// beta = curve(beta): monotone cubic pieces through the points (Fritsch and Carlson 1980), constant beyond
/// them. x ascending within 0..1, y in 0..4.
struct CurveOperation {
  std::vector<std::array<float, 2>> points = {{0, 0}, {1, 1}};
  bool operator==(const CurveOperation&) const = default;
};
/// beta = 1 - beta. With exactly two lights chosen: they change places.
struct InvertOperation {
  bool operator==(const InvertOperation&) const = default;
};
/// beta blurred by a Gaussian of sigma = radius / 2; pixels without light do not take part.
struct BlurOperation {
  int radius = 8;  ///< pixels, 1..256
  bool operator==(const BlurOperation&) const = default;
};
/// beta + amount * (beta - blurred beta).
struct SharpenOperation {
  int radius = 8;
  float amount = 1;
  bool operator==(const SharpenOperation&) const = default;
};
/// beta = the file's: channel `channel` of an EXR or PNG of the picture's size (a beta map edited elsewhere).
struct PictureOperation {
  std::string file;
  std::string channel;  ///< empty: beta.<light>, or else the first
  bool operator==(const PictureOperation&) const = default;
};
/// The light's detected shadows. `amount` 0..1 goes from nothing to everything.
struct ShadowOperation {
  enum class Kind {
    Lighten,  ///< fills the shadow with what the light would give there; amount 1 removes it
    Deepen,   ///< takes away what is left in it
    Soften,   ///< widens the penumbra by `radius`
    Sharpen,  ///< makes the penumbra a hard edge
    Recolor,  ///< fills with `color` times what the light would give
  };
  Kind kind = Kind::Lighten;
  float amount = 1;
  int radius = 12;
  Rgb color{1, 1, 1};
  bool operator==(const ShadowOperation&) const = default;
};

using Operation = std::variant<FillOperation, GainOperation, CurveOperation, InvertOperation, BlurOperation,
                               SharpenOperation, PictureOperation, ShadowOperation>;

/// What happens to the other lights.
enum class Meaning {
  Share,  ///< light is moved: what one light gets the others lose; the all-white picture stays
  Add,    ///< light is added, or taken away; the others stay
};

/// One step of the stack. Immutable once it is in a stack.
struct Edit {
  std::string name;
  bool on = true;
  float opacity = 1;                 ///< 0..1
  std::vector<std::string> lights;   ///< names; empty: all
  Meaning meaning = Meaning::Share;  ///< shadow operations always add
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

  void append(Edit edit) { edits.push_back(std::make_shared<const Edit>(std::move(edit))); }
  void replace(size_t index, Edit edit) { edits[index] = std::make_shared<const Edit>(std::move(edit)); }
  /// Compares what the edits say.
  bool operator==(const EditStack& other) const;
};

/// Bytes that the stack holds and `before` does not share: what it costs to keep both.
[[nodiscard]] size_t editBytes(const EditStack& stack, const EditStack& before);

/// fill, gain, curve, invert, blur, sharpen, picture, shadow: as in JSON.
[[nodiscard]] std::string operationName(const Operation& operation);

[[nodiscard]] Json jsonFromEditStack(const EditStack& stack);
/// `width` and `height` of the picture that the masks are for. Throws InputError that says where.
[[nodiscard]] EditStack editStackFromJson(const Json& json, int width, int height,
                                          const std::string& where = "edits");
/// The stack with every file that it names by another name.
[[nodiscard]] EditStack withFiles(const EditStack& stack,
                                  const std::function<std::string(const std::string&)>& rename);
/// The stack for a picture of this size: strokes are painted again where it is another.
[[nodiscard]] EditStack fitEdits(const EditStack& stack, int width, int height);
/// Whether something in it needs the lights' shadows.
[[nodiscard]] bool usesShadows(const Edit& edit);
[[nodiscard]] bool usesShadows(const Mask& mask);

}  // namespace swaplight

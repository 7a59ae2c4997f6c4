#include <algorithm>

#include "core/edit/stack/edit.h"

namespace swaplight {
namespace {

const Painting* paintingOf(const Edit& edit) {
  for (const MaskShape& shape : edit.mask)
    if (const auto* paint = std::get_if<PaintShape>(&shape.shape)) return paint->painting.get();
  return nullptr;
}

size_t paintingBytes(const Painting& painting, const Painting* before) {
  size_t bytes = painting.mask().bytesBeyond(before ? before->mask() : MaskRaster());
  for (size_t i = 0; i < painting.strokes().size(); ++i) {
    const auto& stroke = painting.strokes()[i];
    bytes += sizeof(stroke);
    const bool shared = before && i < before->strokes().size() && before->strokes()[i] == stroke;
    if (!shared) bytes += sizeof(Stroke) + stroke->points.size() * sizeof(StrokePoint);
  }
  return bytes;
}

}  // namespace

bool EditStack::operator==(const EditStack& other) const {
  return newLights == other.newLights && shadowThresholds == other.shadowThresholds &&
         shadowMarks == other.shadowMarks && lampPlaces == other.lampPlaces &&
         std::equal(edits.begin(), edits.end(), other.edits.begin(), other.edits.end(),
                    [](const auto& a, const auto& b) { return a == b || *a == *b; });
}

size_t editBytes(const EditStack& stack, const EditStack& before) {
  size_t bytes = 0;
  for (size_t i = 0; i < stack.edits.size(); ++i) {
    const auto& edit = stack.edits[i];
    bytes += sizeof(edit);
    if (std::find(before.edits.begin(), before.edits.end(), edit) != before.edits.end()) continue;
    bytes += sizeof(Edit) + edit->name.size() + edit->mask.size() * sizeof(MaskShape);
    // What a changed edit was before stands in the same place.
    const Painting* painting = paintingOf(*edit);
    const Painting* earlier = i < before.edits.size() ? paintingOf(*before.edits[i]) : nullptr;
    if (painting) bytes += paintingBytes(*painting, earlier);
  }
  for (const auto& [light, marks] : stack.shadowMarks) bytes += marks.size() * sizeof(ShadowMark);
  return bytes + stack.lampPlaces.size() * sizeof(LampPlace);
}

EditStack withFiles(const EditStack& stack, const std::function<std::string(const std::string&)>& rename) {
  EditStack renamed = stack;
  const auto change = [&](std::string& file) {
    if (!file.empty()) file = rename(file);
  };
  for (auto& kept : renamed.edits) {
    Edit edit = *kept;
    const auto changeFile = [&](auto& named) {
      if constexpr (requires { named.file; }) change(named.file);
    };
    std::visit(changeFile, edit.operation);
    for (MaskShape& shape : edit.mask) std::visit(changeFile, shape.shape);
    if (!(edit == *kept)) kept = std::make_shared<const Edit>(std::move(edit));
  }
  return renamed;
}

std::vector<std::filesystem::path> filesOfEdits(const EditStack& stack) {
  std::vector<std::filesystem::path> files;
  static_cast<void>(withFiles(stack, [&](const std::string& file) {
    files.emplace_back(file);
    return file;
  }));
  return files;
}

EditStack fitEdits(const EditStack& stack, int width, int height) {
  EditStack fitted = stack;
  fitted.width = width;
  fitted.height = height;
  for (auto& kept : fitted.edits) {
    const Painting* painting = paintingOf(*kept);
    if (!painting || (painting->mask().width() == width && painting->mask().height() == height)) continue;
    Edit edit = *kept;
    for (MaskShape& shape : edit.mask)
      if (auto* paint = std::get_if<PaintShape>(&shape.shape)) {
        Painting again(width, height);
        for (const auto& stroke : paint->painting->strokes()) again.begin(*stroke);
        paint->painting = std::make_shared<const Painting>(std::move(again));
      }
    kept = std::make_shared<const Edit>(std::move(edit));
  }
  return fitted;
}

ShadowOptions shadowOptionsOf(const EditStack& stack) {
  ShadowOptions options;
  options.thresholds = stack.shadowThresholds;
  options.marks = stack.shadowMarks;
  return options;
}

bool usesShadows(const Mask& mask) {
  return std::any_of(mask.begin(), mask.end(), [](const MaskShape& shape) {
    const auto* selection = std::get_if<SelectionShape>(&shape.shape);
    if (!selection) return std::holds_alternative<ShadowShape>(shape.shape);
    return std::any_of(selection->parts->begin(), selection->parts->end(),
                       [](const SelectionPart& part) { return usesShadows(Mask{part.shape}); });
  });
}

bool usesShadows(const Edit& edit) {
  return usesShadows(edit.operation) || usesShadows(edit.mask);
}

bool usesSurfaces(const Edit& edit) {
  return std::holds_alternative<PlaceOperation>(edit.operation);
}

}  // namespace swaplight

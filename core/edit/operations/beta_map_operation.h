#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/beta_row.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// beta = the file's: channel `channel` of an EXR or PNG of the picture's size (a beta map edited elsewhere).
struct BetaMapOperation {
  std::string file;
  std::string channel;  ///< empty: beta.<light>, or else the first
  bool operator==(const BetaMapOperation&) const = default;

  static constexpr OperationInfo info{"picture", "Beta map",
                                      "The light's beta map from a file, edited in another program.", false};
  static constexpr auto fields() {
    return std::tuple{plainField("file", &BetaMapOperation::file, "File"),
                      plainField("channel", &BetaMapOperation::channel)};
  }
  [[nodiscard]] std::string summary() const { return std::filesystem::path(file).filename().string(); }

  void targetRow(const BetaRow& row, float* target) const { std::copy_n(row.map, row.beta.size(), target); }
};

}  // namespace swaplight

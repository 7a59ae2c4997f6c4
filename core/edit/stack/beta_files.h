#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/edit/stack/beta_file.h"
#include "core/edit/stack/edit.h"

namespace swaplight {

/// Maps of lights that an edit takes from a file, of a picture of this size.
struct BetaRequest {
  BetaMapOperation picture;
  std::vector<std::string> lights;
  int width = 0, height = 0;
  bool operator==(const BetaRequest&) const = default;
};

/// Reads them. Throws as readBetaMaps does.
[[nodiscard]] std::shared_ptr<const BetaMaps> readBeta(const BetaRequest& request,
                                                       const Progress& progress = {});

/// The beta maps that edits take from files: read once as long as somebody holds them. Not for use by several
/// threads at once.
class BetaFiles {
 public:
  /// Reads what is not known yet. Throws InputError as readBetaMaps does.
  std::shared_ptr<const BetaMaps> maps(const BetaRequest& request);
  /// Whether maps() needs not read.
  [[nodiscard]] bool known(const BetaRequest& request) const;
  /// What was read elsewhere; or, without maps, the words with which maps() is to refuse.
  void keep(const BetaRequest& request, const std::shared_ptr<const BetaMaps>& maps,
            const std::string& refusal = {});
  /// Files may have changed: all are read again when they are asked for.
  void forget() { m_read.clear(); }

 private:
  struct Read {
    BetaRequest request;
    std::weak_ptr<const BetaMaps> maps;
    std::string refusal;
  };
  std::vector<Read> m_read;
};

}  // namespace swaplight

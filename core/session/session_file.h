#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/kept_json.h"
#include "core/session/document.h"

namespace swaplight {

/// The newest version of a session file that this program knows.
inline constexpr int kSessionVersion = 1;

/// A session file, `NAME.swaplight` (docs/formats.md): the document, and what travels with it.
struct Session {
  Document document;
  KeptJson studio;  ///< where the person was looking: the studio's own, not undone
  int version = kSessionVersion;
  KeptJson unknown;                   ///< what we did not understand, kept for the next write
  std::vector<std::string> warnings;  ///< in words: a newer version, unknown keys
};

/// Reads a session. A newer version is said in a warning and loses nothing when it is written again. Throws
/// InputError: not there, not JSON (line and column), not a session, a value that cannot be.
[[nodiscard]] Session readSession(const std::filesystem::path& file);

/// Writes to a temporary name, then renames. Paths become relative to the file's folder. Throws InputError
/// where it cannot be written.
void writeSession(const Session& session, const std::filesystem::path& file);

/// `folder` is what paths are relative to; an empty one leaves them absolute.
[[nodiscard]] Json jsonFromSession(const Session& session, const std::filesystem::path& folder);
/// `name` stands for the file in messages.
[[nodiscard]] Session sessionFromJson(const Json& json, const std::filesystem::path& folder,
                                      const std::string& name);

/// True for a file that calls itself a session by its extension.
[[nodiscard]] bool isSessionFile(const std::filesystem::path& file);

}  // namespace swaplight

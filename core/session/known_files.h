#pragma once

#include <filesystem>

namespace swaplight {

/// The session files that this process has read or written, each as it then was on the disk: so that the
/// second of two studios on one session does not silently undo what the first has saved, nor what an editor
/// has changed. May be used from several threads.

/// Remembers how the file is now; readSession and writeSession do.
void rememberFile(const std::filesystem::path& file);

/// Throws InputError where the file is another than the one remembered. It is then remembered as it is:
/// whoever tries again has been told. Files that are not known, or are gone, may be written.
void checkUnchanged(const std::filesystem::path& file);

}  // namespace swaplight

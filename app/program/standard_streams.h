#pragma once

#include <string_view>

namespace swaplight {

/// Makes sure that descriptors 0, 1 and 2 are there, so that no file that is opened later becomes standard
/// error and is written over by messages. A stream that was closed stays one that nothing can be written to.
void openStandardStreams();

/// A file that grows beyond `ulimit -f`, a reader that has gone: said by the call that failed, no signal.
void ignoreWriteSignals();

/// Keeps what libraries print (libpng, LibRaw) off standard error: what matters of it is said in our line.
/// From here on only sayOnStandardError is heard.
void silenceLibraries();

/// Where sayOnStandardError writes to.
[[nodiscard]] int standardError();

/// Writes to standard error. Words that cannot be said (no room, nobody reads) are not said: never throws.
void sayOnStandardError(std::string_view words) noexcept;

}  // namespace swaplight

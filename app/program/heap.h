#pragma once

namespace swaplight {

/// Lets the heap keep what was freed, about 256 MiB of the main thread's and one block of 64 MiB of each
/// other thread's, instead of handing every picture back to the system at once and asking for it again: pages
/// that come new cost more than filling them. Pictures above 32 MiB go back as before. Does nothing where the
/// C library is not GNU's.
void keepFreedMemory();

}  // namespace swaplight

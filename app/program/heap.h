#pragma once

namespace swaplight {

/// Lets the heap keep what was freed, up to 256 MiB, instead of handing every picture back to the system at
/// once and asking for it again: a page that comes new costs as much as filling it ten times. Pictures above
/// 32 MiB go back as before. Does nothing where the C library is not GNU's.
void keepFreedMemory();

}  // namespace swaplight

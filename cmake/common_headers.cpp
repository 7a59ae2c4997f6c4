// Nothing: the target is its precompiled headers (CommonHeaders.cmake).

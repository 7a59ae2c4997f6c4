// Only under the sanitizers: what the graphics driver leaks is not ours. The driver's library is unloaded
// before leaks are looked for, which would leave its leaks without a name to tell them by, so it stays
// loaded.
#ifdef SWAPLIGHT_SANITIZE

extern "C" int dlclose(void* /*library*/);
extern "C" int dlclose(void* /*library*/) {
  return 0;
}

extern "C" const char* __lsan_default_suppressions();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:_dri.so\nleak:libGLX_mesa\nleak:libEGL_mesa\n";
}

#endif

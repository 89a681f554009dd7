// Embree builds hierarchies with TBB's worker threads. Debian's libraries of both are not instrumented, so
// the thread sanitizer does not see how they synchronise, neither inside them nor around what they call of
// ours.
extern "C" __attribute__((visibility("default"))) const char* __tsan_default_suppressions() {
  return "race:libembree3.so\n"
         "race:libembree4.so\n"
         "race:libtbb.so\n";
}

// So that the stacks of what happened long ago are known, by which the above are recognised.
extern "C" __attribute__((visibility("default"))) const char* __tsan_default_options() {
  return "history_size=7";
}

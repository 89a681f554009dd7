// Debian's libraries are not instrumented, so the thread sanitizer does not see how they synchronise, neither
// inside them nor around what they call of ours: Embree builds hierarchies with TBB's worker threads,
// umockdev serves its devices from GLib's. Nor does it look at locks that are taken within a poll, and the
// mock bus' own poll takes some.
extern "C" __attribute__((visibility("default"))) const char* __tsan_default_suppressions() {
  return "race:libembree3.so\n"
         "race:libembree4.so\n"
         "race:libtbb.so\n"
         "race:libglib-2.0.so\n"
         "race:libudev.so\n"
         "race:libumockdev.so\n"
         "race:palpate::test::MockBus::before_poll\n";
}

// So that the stacks of what happened long ago are known, by which the above are recognised.
extern "C" __attribute__((visibility("default"))) const char* __tsan_default_options() {
  return "history_size=7";
}

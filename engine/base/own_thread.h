#pragma once

namespace palpate {

// Begins a thread of the library: gives it a name for those who look, at most 15 letters, and leaves signals
// to the program's own threads, but for those that a thread brings upon itself.
void begin_own_thread(const char* name);

}  // namespace palpate

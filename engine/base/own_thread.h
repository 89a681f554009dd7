#pragma once

namespace palpate {

// Begins a thread of the library: gives it a name for those who look, at most 15 letters, and leaves signals
// to the program's own threads, but for those that a thread brings upon itself.
void begin_own_thread(const char* name);

// The scheduling priority of this thread, 1 to 99, before all that has none. The system may refuse.
void ask_for_priority(int priority);

}  // namespace palpate

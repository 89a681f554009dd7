#include "engine/base/own_thread.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include <initializer_list>

namespace palpate {

void begin_own_thread(const char* name) {
  pthread_setname_np(pthread_self(), name);
  sigset_t left_to_others;
  sigfillset(&left_to_others);
  for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP}) sigdelset(&left_to_others, own);
  pthread_sigmask(SIG_BLOCK, &left_to_others, nullptr);
}

void ask_for_priority(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

}  // namespace palpate

#include "tests/fault/journey.h"

namespace palpate::test {
namespace {

// What a lack of memory may be called: a thread that cannot be had is one, too.
bool tells_of_memory(plp_result result) {
  return result == PLP_ERROR_OUT_OF_MEMORY || result == PLP_ERROR_LIMIT;
}

}  // namespace

void Journey::note_failure(const char* name, plp_result result) {
  const std::string sentence = plp_last_error();
  failed_call_ = name;
  const bool was_refused = FailingAllocation::failed();
  FailingAllocation::pass();
  if (!was_refused || !tells_of_memory(result) || sentence.empty() || sentence.find('\n') != sentence.npos)
    complain(std::string(name) + ": " + plp_result_string(result) + ": " + sentence);
}

}  // namespace palpate::test

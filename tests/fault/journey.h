#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "palpate/palpate.h"
#include "tests/fault/failing_allocation.h"

namespace palpate::test {

// A way through the C interface on which something is refused. A call that fails for it is made once more,
// and must then succeed as if nothing had happened: after an error nothing has changed. All but the calls is
// spared.
class Journey {
 public:
  template <class Call>
  void operator()(const char* name, Call&& call) {
    if (try_once(name, call)) return;
    if (call() < 0) complain(std::string(name) + " fails once more: " + plp_last_error());
  }

  // A call that has an effect even if it fails, as its documentation says.
  template <class Call>
  bool try_once(const char* name, Call&& call) {
    const plp_result result = exposed(call);
    if (result < 0) note_failure(name, result);
    return result >= 0;
  }

  // What it comes to, which must not depend on what was refused.
  void keep(const void* data, std::size_t size) { kept_.append(static_cast<const char*>(data), size); }
  template <class T>
  void keep(const T& value) {
    keep(&value, sizeof value);
  }

  // What comes is another story.
  void ends_otherwise() { ends_otherwise_ = true; }
  bool is_comparable() const { return !ends_otherwise_; }

  void complain(const std::string& about) { complaints_ += about + "\n"; }

  const std::string& kept() const { return kept_; }
  const std::string& complaints() const { return complaints_; }
  const char* failed_call() const { return failed_call_; }  // "" if none failed

 private:
  template <class Call>
  static plp_result exposed(Call&& call) {
    const Exposed exposed;
    return call();
  }
  void note_failure(const char* name, plp_result result);

  const Spared spared_;
  std::string kept_;
  std::string complaints_;
  const char* failed_call_ = "";
  bool ends_otherwise_ = false;
};

}  // namespace palpate::test

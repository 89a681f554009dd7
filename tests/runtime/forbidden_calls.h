#pragma once

namespace palpate::test {

// While one lives, its thread must not allocate, lock, wait, or read or write files: the program says what it
// did and aborts. A program that links forbidden_calls.cpp has these functions of the C library replaced.
class ForbiddenCalls {
 public:
  ForbiddenCalls();
  ~ForbiddenCalls();
  ForbiddenCalls(const ForbiddenCalls&) = delete;
  ForbiddenCalls& operator=(const ForbiddenCalls&) = delete;
};

}  // namespace palpate::test

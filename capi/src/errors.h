#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "engine/base/result.h"
#include "palpate/palpate.h"

namespace palpate::capi {

// Why a call is refused; thrown and caught inside the border only.
struct Refusal {
  Error error;
};

[[noreturn]] inline void refuse(ErrorCode code, std::string sentence) {
  throw Refusal{{code, std::move(sentence)}};
}

// Refuses the argument called `name`.
[[noreturn]] inline void refuse_argument(const char* name, const char* predicate) {
  refuse(ErrorCode::kInvalidArgument, std::string(name) + predicate);
}

// Refuses with PLP_ERROR_INVALID_ARGUMENT. Sentences that need composing are composed by the caller after the
// test.
inline void require(bool condition, const char* sentence) {
  if (!condition) refuse(ErrorCode::kInvalidArgument, sentence);
}

template <class T>
T value_or_refuse(Result<T> result) {
  if (!result) throw Refusal{result.error()};
  return std::move(result.value());
}

// Keeps `sentence` for plp_last_error() on this thread, cut if it is very long. Never allocates.
plp_result fail(ErrorCode code, const char* sentence) noexcept;
const char* last_error() noexcept;

// Runs the body of an exported function, so that no exception crosses the border.
template <class Body>
plp_result guarded(Body&& body) noexcept {
  try {
    body();
    return PLP_OK;
  } catch (const Refusal& refusal) {
    return fail(refusal.error.code, refusal.error.message.c_str());
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kOutOfMemory, "out of memory");
  } catch (const std::length_error&) {
    return fail(ErrorCode::kOutOfMemory, "out of memory: an array would be longer than any can be");
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again)
      return fail(ErrorCode::kInternal, error.what());
    return fail(ErrorCode::kLimit, "the system allows no more threads");
  } catch (const std::exception& exception) {
    return fail(ErrorCode::kInternal, exception.what());
  } catch (...) {
    return fail(ErrorCode::kInternal, "an exception of unknown type");
  }
}

}  // namespace palpate::capi

#pragma once

#include <string>
#include <utility>
#include <variant>

namespace palpate {

// What went wrong, as a caller may act on it; capi maps each to its PLP_ERROR code.
enum class ErrorCode {
  kInvalidArgument,
  kInvalidHandle,
  kOutOfMemory,
  kFileNotFound,
  kFileRead,
  kBadFormat,
  kUnsupported,
  kNoTriangles,
  kNonFinite,
  kLimit,
  kUnsafePath,
  kWrongState,
  kDevice,
  kFileWrite,
  kInternal,
};

struct Error {
  ErrorCode code;
  std::string message;  // one sentence that names the file and the place
};

// A value or the reason why there is none.
template <class T>
class Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() { return std::get<0>(state_); }
  const T& value() const { return std::get<0>(state_); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

// The Result of work that yields nothing but success.
struct Done {};
using Status = Result<Done>;

}  // namespace palpate

#include "capi/src/errors.h"

#include <array>
#include <cstdio>

namespace palpate::capi {
namespace {

constexpr std::size_t kLongestSentence = 1024;

thread_local std::array<char, kLongestSentence> last_sentence{};

plp_result result_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kInvalidArgument:
      return PLP_ERROR_INVALID_ARGUMENT;
    case ErrorCode::kInvalidHandle:
      return PLP_ERROR_INVALID_HANDLE;
    case ErrorCode::kOutOfMemory:
      return PLP_ERROR_OUT_OF_MEMORY;
    case ErrorCode::kFileNotFound:
      return PLP_ERROR_FILE_NOT_FOUND;
    case ErrorCode::kFileRead:
      return PLP_ERROR_FILE_READ;
    case ErrorCode::kBadFormat:
      return PLP_ERROR_BAD_FORMAT;
    case ErrorCode::kUnsupported:
      return PLP_ERROR_UNSUPPORTED;
    case ErrorCode::kNoTriangles:
      return PLP_ERROR_NO_TRIANGLES;
    case ErrorCode::kNonFinite:
      return PLP_ERROR_NON_FINITE;
    case ErrorCode::kLimit:
      return PLP_ERROR_LIMIT;
    case ErrorCode::kUnsafePath:
      return PLP_ERROR_UNSAFE_PATH;
    case ErrorCode::kWrongState:
      return PLP_ERROR_WRONG_STATE;
    case ErrorCode::kDevice:
      return PLP_ERROR_DEVICE;
    case ErrorCode::kFileWrite:
      return PLP_ERROR_FILE_WRITE;
    case ErrorCode::kInternal:
      break;
  }
  return PLP_ERROR_INTERNAL;
}

}  // namespace

plp_result fail(ErrorCode code, const char* sentence) noexcept {
  std::snprintf(last_sentence.data(), last_sentence.size(), "%s", sentence);
  return result_of(code);
}

const char* last_error() noexcept {
  return last_sentence.data();
}

}  // namespace palpate::capi

const char* plp_last_error(void) {
  return palpate::capi::last_error();
}

const char* plp_result_string(plp_result result) {
  switch (result) {
    case PLP_OK:
      return "PLP_OK";
    case PLP_ERROR_INVALID_ARGUMENT:
      return "PLP_ERROR_INVALID_ARGUMENT";
    case PLP_ERROR_INVALID_HANDLE:
      return "PLP_ERROR_INVALID_HANDLE";
    case PLP_ERROR_OUT_OF_MEMORY:
      return "PLP_ERROR_OUT_OF_MEMORY";
    case PLP_ERROR_FILE_NOT_FOUND:
      return "PLP_ERROR_FILE_NOT_FOUND";
    case PLP_ERROR_FILE_READ:
      return "PLP_ERROR_FILE_READ";
    case PLP_ERROR_BAD_FORMAT:
      return "PLP_ERROR_BAD_FORMAT";
    case PLP_ERROR_UNSUPPORTED:
      return "PLP_ERROR_UNSUPPORTED";
    case PLP_ERROR_NO_TRIANGLES:
      return "PLP_ERROR_NO_TRIANGLES";
    case PLP_ERROR_NON_FINITE:
      return "PLP_ERROR_NON_FINITE";
    case PLP_ERROR_LIMIT:
      return "PLP_ERROR_LIMIT";
    case PLP_ERROR_UNSAFE_PATH:
      return "PLP_ERROR_UNSAFE_PATH";
    case PLP_ERROR_WRONG_STATE:
      return "PLP_ERROR_WRONG_STATE";
    case PLP_ERROR_DEVICE:
      return "PLP_ERROR_DEVICE";
    case PLP_ERROR_FILE_WRITE:
      return "PLP_ERROR_FILE_WRITE";
    case PLP_ERROR_INTERNAL:
      return "PLP_ERROR_INTERNAL";
  }
  return "unknown result";
}

#include "capi/src/errors.h"

#include <cstring>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace palpate::capi {
namespace {

TEST(Errors, EveryReasonHasItsCode) {
  const std::pair<ErrorCode, plp_result> codes[] = {
      {ErrorCode::kInvalidArgument, PLP_ERROR_INVALID_ARGUMENT},
      {ErrorCode::kInvalidHandle, PLP_ERROR_INVALID_HANDLE},
      {ErrorCode::kOutOfMemory, PLP_ERROR_OUT_OF_MEMORY},
      {ErrorCode::kFileNotFound, PLP_ERROR_FILE_NOT_FOUND},
      {ErrorCode::kFileRead, PLP_ERROR_FILE_READ},
      {ErrorCode::kBadFormat, PLP_ERROR_BAD_FORMAT},
      {ErrorCode::kUnsupported, PLP_ERROR_UNSUPPORTED},
      {ErrorCode::kNoTriangles, PLP_ERROR_NO_TRIANGLES},
      {ErrorCode::kNonFinite, PLP_ERROR_NON_FINITE},
      {ErrorCode::kLimit, PLP_ERROR_LIMIT},
      {ErrorCode::kUnsafePath, PLP_ERROR_UNSAFE_PATH},
      {ErrorCode::kWrongState, PLP_ERROR_WRONG_STATE},
      {ErrorCode::kInternal, PLP_ERROR_INTERNAL},
  };
  for (const auto& [reason, code] : codes) {
    const ErrorCode refused = reason;  // a lambda may not take a binding along in clang 14
    EXPECT_EQ(guarded([&] { refuse(refused, "why"); }), code);
    EXPECT_STREQ(last_error(), "why");
    EXPECT_EQ(std::strncmp(plp_result_string(code), "PLP_ERROR_", 10), 0) << code;
  }
}

TEST(Errors, NoExceptionPasses) {
  EXPECT_EQ(guarded([] { throw std::bad_alloc(); }), PLP_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(guarded([] { std::vector<int>().reserve(SIZE_MAX); }), PLP_ERROR_OUT_OF_MEMORY);
  EXPECT_EQ(guarded([] { throw std::runtime_error("a defect"); }), PLP_ERROR_INTERNAL);
  EXPECT_STREQ(last_error(), "a defect");
  EXPECT_EQ(guarded([] { throw 42; }), PLP_ERROR_INTERNAL);
  EXPECT_EQ(guarded([] {}), PLP_OK);
}

TEST(Errors, LongSentencesAreCut) {
  guarded([] { refuse(ErrorCode::kInternal, std::string(5000, 'x')); });
  EXPECT_EQ(std::strlen(last_error()), 1023u);
}

TEST(Errors, EachThreadHasItsOwn) {
  guarded([] { refuse(ErrorCode::kInternal, "here"); });
  std::thread([] {
    EXPECT_STREQ(last_error(), "");
    guarded([] { refuse(ErrorCode::kInternal, "there"); });
  }).join();
  EXPECT_STREQ(last_error(), "here");
}

TEST(Errors, UnknownResultHasAName) {
  EXPECT_STREQ(plp_result_string(-12345), "unknown result");
  EXPECT_STREQ(plp_result_string(PLP_OK), "PLP_OK");
}

}  // namespace
}  // namespace palpate::capi

// The vendor's library: absent, wrong, or there, and which devices it is said to have.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "engine/device/openhaptics/openhaptics_backend.h"
#include "engine/device/registry.h"
#include "tests/device/openhaptics/stand_in_library.h"

namespace palpate::test {
namespace {

constexpr const char* kVariable = "PALPATE_OPENHAPTICS_LIBRARY";
constexpr const char* kAbsent = "/nonexistent/libHD.so";

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// A variable of the environment for the length of a test.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* const name_;
};

Error error_of(const std::string& name) {
  const auto opened = OpenHapticsBackend().open(name);
  return opened ? Error{ErrorCode::kInternal, "it was opened"} : opened.error();
}

TEST(OpenHapticsLibrary, ThatIsAbsentIsListedWithAdvice) {
  const Variable library(kVariable, kAbsent);
  const auto listed = OpenHapticsBackend().enumerate();
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].identity.uri, "openhaptics:Default Device");
  EXPECT_EQ(listed[0].condition, DeviceCondition::kNoLibrary);
  for (const char* part :
       {"libHD.so not found", "install OpenHaptics 3.4", kVariable,
        "/nonexistent/libHD.so: cannot open shared object file: No such file or directory"})
    EXPECT_TRUE(contains(listed[0].advice, part)) << listed[0].advice;
  EXPECT_LT(listed[0].advice.size(), 512u);
}

TEST(OpenHapticsLibrary, ThatIsAbsentIsAnErrorOfOpening) {
  const Variable library(kVariable, kAbsent);
  const Error error = error_of("Default Device");
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  EXPECT_TRUE(contains(error.message, kAbsent)) << error.message;
  const auto unknown = DeviceRegistry::standard().open("usb:spoon");
  EXPECT_FALSE(contains(unknown.error().message, "openhaptics")) << "there is no such device to open";
}

// With none named, all names of the library are tried and all complaints told.
TEST(OpenHapticsLibrary, IsTriedUnderSeveralNames) {
  unsetenv(kVariable);
  const auto listed = OpenHapticsBackend().enumerate();
  ASSERT_FALSE(listed.empty());
  if (listed[0].condition != DeviceCondition::kNoLibrary) GTEST_SKIP() << "OpenHaptics is installed here";
  for (const char* name : {"libHD.so.3.4: ", "libHD.so.3.4.0: ", "libHD.so: ", "libHD.so.3.0: "})
    EXPECT_TRUE(contains(listed[0].advice, name)) << listed[0].advice;
  EXPECT_LT(listed[0].advice.size(), 512u);
}

TEST(OpenHapticsLibrary, ThatLacksAFunctionIsTheWrongOne) {
  const Variable library(kVariable, PALPATE_STAND_IN_WITHOUT_A_FUNCTION);
  const auto listed = OpenHapticsBackend().enumerate();
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].condition, DeviceCondition::kWrongLibrary);
  EXPECT_TRUE(contains(listed[0].advice, "hdUnschedule")) << listed[0].advice;
  EXPECT_EQ(error_of("Default Device").message, listed[0].advice);
}

TEST(OpenHapticsLibrary, IsTakenUpWhenItIsThereAtLast) {
  const StandInLibrary stand_in;
  {
    const Variable library(kVariable, kAbsent);
    EXPECT_EQ(error_of("Default Device").code, ErrorCode::kDevice);
  }
  const Variable library(kVariable, PALPATE_STAND_IN);
  EXPECT_TRUE(OpenHapticsBackend().open("Default Device"));
  EXPECT_TRUE(OpenHapticsBackend().open("")) << "the library's own default";
  EXPECT_EQ(OpenHapticsBackend().enumerate()[0].condition, DeviceCondition::kReady);
}

TEST(OpenHapticsLibrary, ListsTheDevicesThatAreSetUp) {
  const auto home = std::filesystem::temp_directory_path() / "palpate_openhaptics_test";
  std::filesystem::create_directories(home / "config");
  for (const char* file : {"Right.config", "Left.config", "notes.txt"})
    std::ofstream(home / "config" / file) << "x";
  const Variable variable("GTDD_HOME", home.string()), library(kVariable, PALPATE_STAND_IN);
  const auto listed = OpenHapticsBackend().enumerate();
  std::filesystem::remove_all(home);
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[0].identity.uri, "openhaptics:Left");
  EXPECT_EQ(listed[1].identity.uri, "openhaptics:Right");
  EXPECT_EQ(OpenHapticsBackend().enumerate().size(), 1u) << "a folder that is not there lists the default";
}

TEST(OpenHapticsLibrary, AnUnknownParameterIsRefused) {
  for (const char* name : {"Default Device?speed=9", "Default Device?library=", "?library"})
    EXPECT_EQ(error_of(name).code, ErrorCode::kInvalidArgument) << name;
}

TEST(OpenHapticsDevices, ThatCannotBeOpenedSayWhy) {
  StandInLibrary library;
  Error error = error_of(StandInLibrary::in_library("Third"));
  EXPECT_EQ(error.code, ErrorCode::kDevice);
  for (const char* part : {"\"openhaptics:Third\"", "stand-in error", "0x0302", "internal 7", "cable"})
    EXPECT_TRUE(contains(error.message, part)) << error.message;
  library.plant([](StandInFaults& faults) { faults.opening_error = 0x0303; });
  EXPECT_TRUE(contains(error_of(StandInLibrary::in_library("Default Device")).message, "pair it"));
  library.plant([](StandInFaults& faults) { faults.opening_error = 0; });
  const auto opened = OpenHapticsBackend().open(StandInLibrary::in_library("Default Device"));
  ASSERT_TRUE(opened) << opened.error().message;
  error = error_of(StandInLibrary::in_library("Default Device"));
  EXPECT_TRUE(contains(error.message, "it is open already")) << error.message;
  library.tick(5);
  EXPECT_EQ(library.record().missed_frames, 0u) << "the one that is open goes on";
}

}  // namespace
}  // namespace palpate::test

// A file may hold anything: an error that names the byte, or what is sound, never a crash.
#include <cmath>
#include <cstdio>
#include <set>

#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

constexpr std::uint64_t kSteps = 24;

// A trace with all kinds of records.
class HostileTrace : public testing::Test {
 protected:
  HostileTrace() {
    TraceFile file;
    const TestModel model(box(0.5f, 0.5f, 0.5f));
    TestScene scene(0.2);
    scene.add(model.handle, PLP_BODY_STATIC, at(0, 0, 0));
    const plp_body tool = scene.add(model.handle, PLP_BODY_TOOL, at(1.1, 0, 0));
    EXPECT_EQ(plp_scene_record(scene.handle, file.path()), PLP_OK) << plp_last_error();
    plp_body guest = 0;
    for (std::uint64_t i = 0; i < kSteps; ++i) {
      const plp_pose pose = at(1.1, 0.01 * static_cast<double>(i), 0.0);
      EXPECT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      if (i % 8 == 2) guest = scene.add(model.handle, PLP_BODY_MOVING, at(0, 3, 0));
      if (i % 8 == 5) {
        EXPECT_EQ(plp_scene_remove_body(scene.handle, guest), PLP_OK);
      }
      if (i % 6 == 3) {
        EXPECT_EQ(plp_scene_set_stiffness(scene.handle, 10.0 * static_cast<double>(i)), PLP_OK);
      }
      scene.step();
    }
    EXPECT_EQ(stop_recording(scene.handle).ticks, kSteps);
    whole_ = file.bytes();
    for (std::size_t at = block_begin_; at < whole_.size(); at += 8 + size_at(at)) borders_.insert(at);
    EXPECT_EQ(*borders_.rbegin() + 8 + 16, whole_.size());
  }

  std::uint32_t size_at(std::size_t block) const {
    std::uint32_t size;
    std::memcpy(&size, whole_.data() + block + 4, sizeof size);
    return size;
  }

  // How many ticks could be read; -1 for an error, which names file and byte.
  int open(const std::string& bytes, plp_trace_info* told = nullptr) {
    file_.write(bytes);
    plp_trace trace = nullptr;
    const plp_result result = plp_trace_open(file_.path(), &trace);
    if (result != PLP_OK) {
      EXPECT_TRUE(result == PLP_ERROR_BAD_FORMAT || result == PLP_ERROR_UNSUPPORTED) << plp_last_error();
      EXPECT_EQ(std::string(plp_last_error()).rfind(std::string(file_.path()) + ": byte ", 0), 0u)
          << plp_last_error();
      EXPECT_EQ(trace, nullptr);
      return -1;
    }
    plp_trace_info info;
    plp_trace_info_init(&info, sizeof info);
    EXPECT_EQ(plp_trace_get_info(trace, &info), PLP_OK);
    if (told) *told = info;
    const int read = read_all(trace, info);
    EXPECT_EQ(plp_trace_release(trace), PLP_OK);
    return read;
  }

  // What is read is sound: numbers are numbers, and arrays are as long as they say.
  static int read_all(plp_trace trace, const plp_trace_info& info) {
    int read = 0;
    for (std::uint64_t i = 0; i < info.ticks; ++i) {
      plp_trace_tick tick;
      plp_trace_tick_init(&tick, sizeof tick);
      if (plp_trace_read(trace, i, &tick) != PLP_OK) continue;
      ++read;
      plp_contacts contacts;
      plp_contacts_init(&contacts, sizeof contacts);
      EXPECT_EQ(plp_trace_get_contacts(trace, &contacts), PLP_OK);
      for (std::size_t k = 0; k < contacts.lmd_count; ++k) {
        EXPECT_TRUE(std::isfinite(contacts.lmds[k].distance));
        EXPECT_LE(contacts.lmds[k].feature_a, PLP_FEATURE_VERTEX);
      }
      for (const double force : contacts.wrench.force) EXPECT_TRUE(std::isfinite(force));
      for (std::size_t k = 0; k < tick.move_count; ++k)
        EXPECT_TRUE(std::isfinite(tick.moves[k].pose.position[0]));
    }
    plp_trace_tick tick;
    plp_trace_tick_init(&tick, sizeof tick);
    EXPECT_EQ(plp_trace_read(trace, info.ticks, &tick), PLP_ERROR_INVALID_ARGUMENT);
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    EXPECT_EQ(plp_trace_get_options(trace, &options), PLP_OK);
    plp_scene scene = nullptr;
    EXPECT_EQ(plp_scene_create(&options, &scene), PLP_OK) << plp_last_error();
    EXPECT_EQ(plp_scene_release(scene), PLP_OK);
    for (std::uint64_t i = 0; i < info.bodies; ++i) {
      plp_trace_body body;
      plp_trace_body_init(&body, sizeof body);
      EXPECT_EQ(plp_trace_get_body(trace, i, &body), PLP_OK);
      EXPECT_LE(std::strlen(body.model_name), 255u);
    }
    return read;
  }

  template <class Number>
  std::string with(std::size_t offset, Number number) const {
    std::string bytes = whole_;
    std::memcpy(bytes.data() + offset, &number, sizeof number);
    return bytes;
  }

  static constexpr std::size_t kVersion = 8, kSizes = 12, kHeader = 40, kTick = 320;
  const std::size_t block_begin_ = kHeader + 100;
  TraceFile file_;
  std::string whole_;
  std::set<std::size_t> borders_;  // where blocks begin
};

TEST_F(HostileTrace, TheWholeOneIsSound) {
  plp_trace_info info;
  EXPECT_EQ(open(whole_, &info), static_cast<int>(kSteps));
  EXPECT_EQ(info.complete, 1);
  EXPECT_EQ(info.bytes, whole_.size());
}

TEST_F(HostileTrace, CutOffAtABorderIsReadAsFar) {
  std::uint64_t before = 0;
  for (const std::size_t border : borders_) {
    plp_trace_info info;
    ASSERT_GE(open(whole_.substr(0, border), &info), 0) << border;
    EXPECT_EQ(info.complete, 0);
    EXPECT_EQ(info.bytes, border);
    EXPECT_GE(info.ticks, before);
    before = info.ticks;
  }
  EXPECT_EQ(before, kSteps);
}

TEST_F(HostileTrace, CutOffAnywhereIsReadAsFar) {
  const std::uint32_t seed = 17;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    const std::size_t length = random() % whole_.size();
    SCOPED_TRACE(length);
    if (length < block_begin_) {
      EXPECT_EQ(open(whole_.substr(0, length)), -1);
      continue;
    }
    plp_trace_info info;
    ASSERT_GE(open(whole_.substr(0, length), &info), 0);
    EXPECT_EQ(info.complete, 0);
    EXPECT_EQ(info.bytes, *std::prev(borders_.upper_bound(length)));
  }
}

TEST_F(HostileTrace, AnotherVersionOrOtherSizesAreRefused) {
  EXPECT_EQ(open(with(0, 'X')), -1);
  EXPECT_EQ(open(with(kVersion, std::uint32_t{2})), -1);
  EXPECT_NE(std::string(plp_last_error()).find("version 2"), std::string::npos) << plp_last_error();
  for (std::size_t size = kSizes; size < kHeader; size += 4) EXPECT_EQ(open(with(size, UINT32_MAX)), -1);
  EXPECT_EQ(open(""), -1);
  EXPECT_EQ(open("t,px,py,pz,qx,qy,qz,qw\n"), -1);
  EXPECT_EQ(open(whole_ + "x"), -1);
}

TEST_F(HostileTrace, CountsThatCannotBeAreRefused) {
  for (const std::size_t border : borders_) {
    EXPECT_LE(open(with(border + 4, UINT32_MAX)), static_cast<int>(kSteps)) << "a block's size";
    if (whole_.compare(border, 4, "TICK") != 0) continue;
    for (std::size_t count = 0; count < 4; ++count) {
      const std::size_t at = border + 8 + kTick - 16 + 4 * count;
      EXPECT_EQ(open(with(at, UINT32_MAX)), -1) << "count " << count;
      EXPECT_EQ(open(with(at, 0x10000000u)), -1) << "count " << count;
    }
  }
  EXPECT_EQ(open(with(whole_.size() - 16, std::uint64_t{1} << 60)), -1) << "2^60 ticks";
}

TEST_F(HostileTrace, MutatedBytesNeverCrash) {
  const std::uint32_t seed = 99;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  const unsigned char extremes[] = {0x00, 0x01, 0x7f, 0x80, 0xff};
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    std::string bytes = whole_;
    for (std::uint32_t k = 1 + random() % 4; k > 0; --k) {
      const std::uint32_t choice = random();
      bytes[random() % bytes.size()] = static_cast<char>(choice % 2 ? extremes[choice / 2 % 5] : choice >> 8);
    }
    refused += open(bytes) < 0;
    if (HasFatalFailure()) return;
  }
  std::printf("%d of 500 were refused\n", refused);
  EXPECT_GT(refused, 50);
}

TEST_F(HostileTrace, WhatIsNoFileIsRefused) {
  plp_trace trace = nullptr;
  EXPECT_EQ(plp_trace_open("/nowhere/at/all", &trace), PLP_ERROR_FILE_NOT_FOUND);
  EXPECT_EQ(plp_trace_open("/", &trace), PLP_ERROR_FILE_READ);
  EXPECT_EQ(plp_trace_open("/dev/zero", &trace), PLP_ERROR_FILE_READ);
  EXPECT_EQ(plp_trace_open("", &trace), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_open(nullptr, &trace), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_open(file_.path(), nullptr), PLP_ERROR_INVALID_ARGUMENT);
}

TEST_F(HostileTrace, HandlesAndStructsAreChecked) {
  file_.write(whole_);
  const TestTrace trace(file_);
  plp_contacts contacts;
  plp_contacts_init(&contacts, sizeof contacts);
  EXPECT_EQ(plp_trace_get_contacts(trace.handle, &contacts), PLP_ERROR_WRONG_STATE);
  plp_trace_tick tick{};
  EXPECT_EQ(plp_trace_read(trace.handle, 0, &tick), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_read(nullptr, 0, &tick), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_trace_get_body(trace.handle, 99, nullptr), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_place(trace.handle, 0, 1, nullptr, 1), PLP_ERROR_INVALID_HANDLE);
  TestScene scene(0.1);
  EXPECT_EQ(plp_trace_place(trace.handle, 0, trace.body(0).body, scene.handle, 1), PLP_ERROR_INVALID_HANDLE);
  EXPECT_EQ(plp_trace_place(trace.handle, 0, 12345, scene.handle, 1), PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_place(trace.handle, kSteps, trace.body(0).body, scene.handle, 1),
            PLP_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(plp_trace_release(nullptr), PLP_OK);
}

}  // namespace
}  // namespace palpate::test

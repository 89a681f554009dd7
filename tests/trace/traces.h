#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/capi/shapes.h"

namespace palpate::test {

// A path that no other test uses; the file is removed afterwards.
class TraceFile {
 public:
  TraceFile() {
    static int count = 0;
    path_ = (std::filesystem::temp_directory_path() /
             ("palpate_trace_" + std::to_string(::getpid()) + "_" + std::to_string(count++)))
                .string();
  }
  ~TraceFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;

  const char* path() const { return path_.c_str(); }

  std::string bytes() const {
    std::ifstream stream(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  void write(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

 private:
  std::string path_;
};

// Owns an open trace.
class TestTrace {
 public:
  explicit TestTrace(const TraceFile& file) {
    EXPECT_EQ(plp_trace_open(file.path(), &handle), PLP_OK) << plp_last_error();
  }
  ~TestTrace() { plp_trace_release(handle); }
  TestTrace(const TestTrace&) = delete;
  TestTrace& operator=(const TestTrace&) = delete;

  plp_trace_info info() const {
    plp_trace_info info;
    plp_trace_info_init(&info, sizeof info);
    EXPECT_EQ(plp_trace_get_info(handle, &info), PLP_OK) << plp_last_error();
    return info;
  }
  plp_scene_options options() const {
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    EXPECT_EQ(plp_trace_get_options(handle, &options), PLP_OK) << plp_last_error();
    return options;
  }
  plp_trace_body body(std::uint64_t index) const {
    plp_trace_body body;
    plp_trace_body_init(&body, sizeof body);
    EXPECT_EQ(plp_trace_get_body(handle, index, &body), PLP_OK) << plp_last_error();
    return body;
  }
  plp_trace_tick read(std::uint64_t index) const {
    plp_trace_tick tick;
    plp_trace_tick_init(&tick, sizeof tick);
    EXPECT_EQ(plp_trace_read(handle, index, &tick), PLP_OK) << plp_last_error();
    return tick;
  }
  plp_contacts contacts() const {
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    EXPECT_EQ(plp_trace_get_contacts(handle, &contacts), PLP_OK) << plp_last_error();
    return contacts;
  }

  plp_trace handle = nullptr;
};

inline plp_recording stop_recording(plp_scene scene) {
  plp_recording recording;
  plp_recording_init(&recording, sizeof recording);
  EXPECT_EQ(plp_scene_stop_recording(scene, &recording), PLP_OK) << plp_last_error();
  return recording;
}

// While one lives, no file of this process grows beyond `bytes`.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

// All of an outcome that does not depend on time, as bytes.
inline std::string bits_of(const plp_contacts& contacts) {
  std::string bits;
  const auto add = [&](const void* data, std::size_t size) {
    bits.append(static_cast<const char*>(data), size);
  };
  add(&contacts.wrench, sizeof contacts.wrench);
  add(&contacts.min_distance, sizeof contacts.min_distance);
  add(&contacts.status, sizeof contacts.status);
  add(&contacts.overlap, sizeof contacts.overlap);
  add(&contacts.set_count, sizeof contacts.set_count);
  plp_work work = contacts.work;
  work.global_us = 0.0;
  add(&work, sizeof work);
  for (std::size_t i = 0; i < contacts.lmd_count; ++i) add(&contacts.lmds[i], sizeof(plp_lmd));
  return bits;
}

// A tool that wanders about the origin within `reach`, turning.
class Wander {
 public:
  Wander(double reach, std::uint32_t seed) : reach_(reach), random_(seed) {}

  plp_pose next() {
    std::uniform_real_distribution<double> step(-0.06, 0.06);
    plp_pose pose;
    for (int i = 0; i < 3; ++i) {
      at_[i] = std::clamp(at_[i] + step(random_), -1.0, 1.0);
      pose.position[i] = reach_ * at_[i];
    }
    for (int i = 0; i < 4; ++i) pose.orientation[i] = turn_[i] += 0.3 * step(random_);
    return pose;
  }

 private:
  double reach_;
  std::mt19937 random_;
  double at_[3] = {0.9, 0.1, 0.2};
  double turn_[4] = {0.1, 0.2, 0.3, 1.0};
};

}  // namespace palpate::test

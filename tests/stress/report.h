#pragma once

#include <string>
#include <vector>

#include "tests/stress/force_stress.h"
#include "tests/stress/hand_stress.h"
#include "tests/stress/search_stress.h"
#include "tests/stress/triangle_stress.h"

namespace palpate::stress {

// All that cases of one family gave.
struct FamilyReport {
  std::string family;
  SearchOutcome search;
  TriangleOutcome triangles;
  ForceOutcome force;
  std::vector<std::string> wrong;  // cases with faults, in words

  void add(const FamilyReport& other);
  int faults() const;
};

// Bars that every family must pass.
inline constexpr double kLargestError = 1e-6;  // of a distance, relative to the size of its features
inline constexpr double kLargestJump = 1e-4;   // of a force, in k·c

// Runs a case by its number; the seed names the run.
void run_case(const Family& family, std::uint64_t seed, int number, FamilyReport& report);

// Tables in Markdown.
std::string search_table(const std::vector<FamilyReport>& reports);
std::string triangle_table(const std::vector<FamilyReport>& reports);

struct HandReport {
  std::string scene;
  HandOutcome outcome;
};
std::string hand_table(const std::vector<HandReport>& reports);

}  // namespace palpate::stress

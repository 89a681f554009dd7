#pragma once

#include <chrono>
#include <fstream>
#include <string>

#include "tests/bench/machine.h"
#include "tests/bench/series.h"

namespace palpate::bench {

// What a series measures.
struct Measure {
  std::string bench;
  std::string scene;
  std::string method;
  std::string returns;     // what the method gives: one minimum, a complete set, …
  std::string parameters;  // key=value, separated by blanks
  std::string quantity;
  std::string unit;
};

// The one CSV that all results go to; times also appear on the screen.
class Table {
 public:
  // Throws std::runtime_error if the file cannot be written.
  Table(const std::string& path, std::string commit);

  // A series without values leaves no row.
  void add(const Measure& measure, const Series& series);

  // One line on the screen about what comes next.
  void say(const std::string& text) const;

 private:
  std::ofstream file_;
  Machine machine_ = this_machine();
  std::string commit_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace palpate::bench

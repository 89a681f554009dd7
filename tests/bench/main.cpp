// Measures Palpate and its peers. Every result goes to one CSV.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "tests/bench/benches.h"

namespace palpate::bench {
namespace {

struct Bench {
  const char* name;
  void (*run)(const Effort&, Table&);
};

constexpr Bench kBenches[] = {{"kernels", bench_kernels},
                              {"build", bench_build},
                              {"pairs", bench_pairs},
                              {"growth", bench_growth},
                              {"bodies", bench_bodies}};

struct Arguments {
  std::string out = "bench.csv";
  std::string commit = "unknown";
  std::string only;
  Effort effort;
};

Arguments arguments_of(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string option = values[i];
    const auto value = [&] {
      if (i + 1 == count) throw std::runtime_error(option + " needs a value");
      return std::string(values[++i]);
    };
    if (option == "--quick") {
      arguments.effort.quick = true;
    } else if (option == "--long") {
      arguments.effort.largest = true;
    } else if (option == "--out") {
      arguments.out = value();
    } else if (option == "--commit") {
      arguments.commit = value();
    } else if (option == "--only") {
      arguments.only = value();
    } else {
      throw std::runtime_error("unknown option " + option);
    }
  }
  return arguments;
}

void run(const Arguments& arguments) {
  Table table(arguments.out, arguments.commit);
  bool found = false;
  for (const Bench& bench : kBenches) {
    if (!arguments.only.empty() && arguments.only != bench.name) continue;
    found = true;
    bench.run(arguments.effort, table);
  }
  if (!found)
    throw std::runtime_error("--only " + arguments.only + ": it is kernels, build, pairs, growth or bodies");
  table.say("written to " + arguments.out);
}

}  // namespace
}  // namespace palpate::bench

int main(int count, char** values) {
  try {
    palpate::bench::run(palpate::bench::arguments_of(count, values));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "palpate-bench: %s\n", error.what());
    return 1;
  }
}

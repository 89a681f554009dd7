// palpate-soak: scenes that touch for an hour, or as long as wanted.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "tests/soak/soak.h"

namespace palpate::test {
namespace {

constexpr double kMiB = 1024.0 * 1024.0;
constexpr double kFlat = 4.0;  // MiB

void show(const SoakProgress& progress) {
  std::printf("%7.0f s  %12llu ticks  %8.1f MiB\n", progress.seconds,
              static_cast<unsigned long long>(progress.ticks),
              static_cast<double>(progress.resident_bytes) / kMiB);
  std::fflush(stdout);
}

int judge(const SoakOutcome& outcome) {
  for (const std::string& name : outcome.wrong) std::printf("not as a fresh scene: %s\n", name.c_str());
  const double grown = static_cast<double>(outcome.most_resident_bytes - outcome.warm.resident_bytes) / kMiB;
  const bool touched = outcome.touching_ticks > outcome.end.ticks / 2;
  const bool good = outcome.wrong.empty() && grown <= kFlat && touched;
  std::printf(
      "%s: %llu ticks in %.0f s, %.0f %% of them in contact; memory grew by %.1f MiB; %zu forces are not "
      "those of a "
      "fresh scene\n",
      good ? "passed" : "FAILED", static_cast<unsigned long long>(outcome.end.ticks), outcome.end.seconds,
      100.0 * static_cast<double>(outcome.touching_ticks) / static_cast<double>(outcome.end.ticks), grown,
      outcome.wrong.size());
  return good ? 0 : 1;
}

int run(int argc, char** argv) {
  SoakOptions options;
  options.pairs = {{"crankshaft_45k", "gear_6k"},
                   {"spring_23k", "teapot_5600", 0.3},
                   {"organic_97k", "organic_2200", 0.4},
                   {"helicopter_113k", "gear_6k", 0.5}};
  double minutes = 60.0;
  CLI::App app(
      "Steps scenes in contact for a long time: memory must stay flat, and forces what they are afresh");
  app.name("palpate-soak");
  app.add_option("--minutes", minutes, "how long")->capture_default_str()->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads, "at once")->capture_default_str()->check(CLI::Range(1, 64));
  app.add_option("--seed", options.seed, "of the ways")->capture_default_str();
  try {
    app.parse(argc, argv);
    options.seconds = 60.0 * minutes;
    return judge(soak(options, show));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "palpate-soak: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace palpate::test

int main(int argc, char** argv) {
  return palpate::test::run(argc, argv);
}

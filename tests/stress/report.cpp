#include "tests/stress/report.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace palpate::stress {
namespace {

std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

std::string text(const char* format, ...) {
  char line[512];
  va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  return line;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

std::vector<double> errors_of(const SearchOutcome& search) {
  std::vector<double> errors;
  for (const Verdict* verdict : {&search.global, &search.certified, &search.descent})
    errors.insert(errors.end(), verdict->errors.begin(), verdict->errors.end());
  return errors;
}

std::string share_of(long count, long pairs) {
  if (pairs == 0) return "–";
  return count == 0 ? "0" : text("%.2g %%", 100.0 * static_cast<double>(count) / static_cast<double>(pairs));
}

// Of what must not be, by search from scratch, certified and by descent.
int not_numbers(const FamilyReport& report) {
  return report.search.global.not_numbers + report.search.certified.not_numbers +
         report.search.descent.not_numbers + report.force.not_numbers;
}

std::string in_words(const FamilyReport& one, std::uint64_t seed, int number) {
  std::string words = text("seed %llu case %d", static_cast<unsigned long long>(seed), number);
  for (const Verdict* verdict : {&one.search.global, &one.search.certified, &one.search.descent})
    if (!verdict->first.empty()) words += "; " + verdict->first;
  if (one.force.largest_jump > kLargestJump) words += text("; force jump %.2g", one.force.largest_jump);
  return words;
}

}  // namespace

int FamilyReport::faults() const {
  const auto largest = [](const std::vector<double>& errors) {
    return errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end());
  };
  return search.faults() + force.faults() + (largest(errors_of(search)) > kLargestError) +
         (force.largest_jump > kLargestJump) +
         static_cast<int>(triangles.palpate.wrong + triangles.palpate.false_contacts +
                          triangles.palpate.false_gaps + triangles.unsafe_bounds);
}

void FamilyReport::add(const FamilyReport& other) {
  search.add(other.search);
  triangles.add(other.triangles);
  force.add(other.force);
  wrong.insert(wrong.end(), other.wrong.begin(), other.wrong.end());
}

void run_case(const Family& family, std::uint64_t seed, int number, FamilyReport& report) {
  report.family = family.name;
  FamilyReport one;
  Random random(seed * 1'000'003u + static_cast<std::uint64_t>(number));
  const Case c = family.make(random);
  one.search = stress_search(c, random);
  one.triangles = stress_triangles(c, random);
  one.force = stress_force(c, random);
  if (one.faults() > 0) one.wrong.push_back(in_words(one, seed, number));
  report.add(one);
}

std::string search_table(const std::vector<FamilyReport>& reports) {
  std::string table =
      "| family | cases | minima | undecided | missed | spurious | NaN | distance error: p50 | p99 | max | "
      "most steps | endless | force jump | unsteady "
      "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const FamilyReport& report : reports) {
    const SearchOutcome& search = report.search;
    const std::vector<double> errors = errors_of(search);
    table += text("| %s | %d | %d | %d | %d | %d | %d | %.1g | %.1g | %.1g | %d | %d | %.1g | %d |\n",
                  report.family.c_str(), search.cases, search.global.certain, search.global.undecided,
                  search.global.missed + search.certified.missed + search.global.wrong_overlap +
                      search.certified.wrong_overlap,
                  search.global.spurious + search.certified.spurious + search.descent.spurious,
                  not_numbers(report), quantile(errors, 0.5), quantile(errors, 0.99), quantile(errors, 1.0),
                  search.most_steps, search.endless, report.force.largest_jump,
                  report.force.unsteady + report.force.wild);
  }
  return table;
}

std::string triangle_table(const std::vector<FamilyReport>& reports) {
  std::string table =
      "| family | pairs | Palpate: wrong | max error | FCL: wrong | false contact | max error | FCL in "
      "float32: "
      "wrong | false contact |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const FamilyReport& report : reports) {
    const TriangleTally &ours = report.triangles.palpate, &fcl = report.triangles.fcl,
                        &single = report.triangles.fcl_single;
    table += text("| %s | %ld | %s | %.1g | %s | %s | %.1g | %s | %s |\n", report.family.c_str(), ours.pairs,
                  share_of(ours.wrong + ours.false_contacts + ours.false_gaps, ours.pairs).c_str(),
                  quantile(ours.errors, 1.0), share_of(fcl.wrong, fcl.pairs).c_str(),
                  share_of(fcl.false_contacts, fcl.pairs).c_str(), quantile(fcl.errors, 1.0),
                  share_of(single.wrong, single.pairs).c_str(),
                  share_of(single.false_contacts, single.pairs).c_str());
  }
  return table;
}

std::string hand_table(const std::vector<HandReport>& reports) {
  std::string table =
      "| scene | simulated | cycles | active | most energy in a cycle | largest force | 100–500 Hz at rest | "
      "deviation at rest |\n|---|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const HandReport& report : reports) {
    const HandOutcome& outcome = report.outcome;
    table += text("| %s | %.1f min | %d | %d | %+.2g mJ | %.2g N | %.1g N | %.1g N |\n", report.scene.c_str(),
                  outcome.seconds / 60, outcome.cycles, outcome.active, 1e3 * outcome.most_given,
                  outcome.pushed, outcome.buzz, outcome.deviation);
  }
  return table;
}

}  // namespace palpate::stress

#include "tests/bench/table.h"

#include <cstdio>
#include <stdexcept>

namespace palpate::bench {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

Table::Table(const std::string& path, std::string commit) : file_(path), commit_(std::move(commit)) {
  file_.precision(6);
  file_ << "bench,scene,method,quantity,returns,parameters,unit,count,p50,p99,p99.9,max,rms,"
           "processor,compiler,flags,simd,commit\n";
  if (!file_) throw std::runtime_error(path + ": cannot be written");
}

void Table::add(const Measure& m, const Series& series) {
  if (series.count() == 0) return;
  const double p50 = series.percentile(0.5), p99 = series.percentile(0.99), max = series.percentile(1.0);
  file_ << m.bench << ',' << m.scene << ',' << m.method << ',' << m.quantity << ',' << quoted(m.returns)
        << ',' << quoted(m.parameters) << ',' << quoted(m.unit) << ',' << series.count() << ',' << p50 << ','
        << p99 << ',' << series.percentile(0.999) << ',' << max << ',' << series.root_mean_square() << ','
        << quoted(machine_.processor) << ',' << quoted(machine_.compiler) << ',' << quoted(machine_.flags)
        << ',' << machine_.simd << ',' << commit_ << std::endl;
  if (m.unit != "us") return;
  std::printf("  %-24s %-14s %-18s p50 %-10.4g p99 %-10.4g max %-10.4g us\n", m.method.c_str(),
              m.quantity.c_str(), m.bench == "pairs" ? "" : m.parameters.c_str(), p50, p99, max);
  std::fflush(stdout);
}

void Table::say(const std::string& text) const {
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - start_;
  std::printf("[%4.0f s] %s\n", since.count(), text.c_str());
  std::fflush(stdout);
}

}  // namespace palpate::bench

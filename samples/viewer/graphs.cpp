#include "samples/viewer/graphs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <span>
#include <string_view>

#include "samples/cli/failure.h"
#include "samples/cli/percentile.h"
#include "samples/viewer/quantity.h"

namespace palpate::viewer {
namespace {

constexpr int kWidth = 960, kHeight = 560;
constexpr double kPlotWidth = 400.0, kPlotHeight = 170.0;
constexpr const char* kColours[] = {"#2f6db5", "#2d8a57", "#c9722b", "#b8413d"};
constexpr const char* kCaptions[] = {"local update time (fig. 5)", "triangle pairs tested (fig. 6)",
                                     "global search time (fig. 7)", "force on the tool (fig. 8)"};

template <class... Arguments>
std::string text(const char* format, Arguments... arguments) {
  char buffer[512];
  const int length = std::snprintf(buffer, sizeof buffer, format, arguments...);
  return {buffer, static_cast<std::size_t>(length)};
}

double rounded_up(double most) {
  if (!(most > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0})
    if (most <= step * decade) return step * decade;
  return 10.0 * decade;
}

struct Point {
  double seconds;
  double value;
};

// Ticks in which the quantity was not taken, such as those without a search from scratch, are left out.
std::vector<Point> points_of(const Quantity& quantity, const std::vector<cli::Tick>& ticks, bool skip_zero) {
  std::vector<Point> points;
  for (const cli::Tick& tick : ticks) {
    const double value = quantity.of(tick);
    if (!skip_zero || value > 0.0) points.push_back({tick.seconds - ticks.front().seconds, value});
  }
  return points;
}

// The least and the most of each column of a pixel: a long run is drawn by few points and loses no peak.
std::vector<Point> thinned(const std::vector<Point>& points, double seconds) {
  std::vector<Point> kept;
  for (std::size_t begin = 0; begin < points.size();) {
    const auto column = [&](std::size_t i) { return std::floor(points[i].seconds / seconds * kPlotWidth); };
    std::size_t end = begin + 1;
    while (end < points.size() && column(end) == column(begin)) ++end;
    const auto [low, high] =
        std::minmax_element(points.begin() + static_cast<std::ptrdiff_t>(begin),
                            points.begin() + static_cast<std::ptrdiff_t>(end),
                            [](const Point& a, const Point& b) { return a.value < b.value; });
    kept.push_back(*std::min(low, high));
    if (low != high) kept.push_back(*std::max(low, high));
    begin = end;
  }
  return kept;
}

std::string number(double value) {
  return text(value >= 100.0 ? "%.0f" : "%.3g", value);
}

std::vector<double> ascending(const std::vector<Point>& points) {
  std::vector<double> values(points.size());
  std::transform(points.begin(), points.end(), values.begin(),
                 [](const Point& point) { return point.value; });
  std::sort(values.begin(), values.end());
  return values;
}

std::string summary_of(const std::vector<double>& values, const char* unit) {
  if (values.empty()) return "none";
  return "median " + number(cli::percentile(values, 0.5)) + ", p99 " + number(cli::percentile(values, 0.99)) +
         ", most " + number(values.back()) + " " + unit;
}

// How high a graph is. A processor that was away for a while makes a few ticks long beyond all measure: they
// go over the top, and are told in the summary.
double height_of(const std::vector<double>& values, bool are_times) {
  if (values.empty()) return 1.0;
  return rounded_up(are_times ? std::min(values.back(), 2.5 * cli::percentile(values, 0.9)) : values.back());
}

// One graph with its corner at `left` and `top`.
class Graph {
 public:
  Graph(double left, double top, double seconds, double most, std::ostream& out)
      : left_(left), top_(top), seconds_(seconds), most_(most), out_(out) {}

  void frame(const std::string& caption, const std::string& summary) const {
    write_text(left_, top_ - 24.0, "start", 14, "#30363d", caption);
    write_text(left_, top_ - 8.0, "start", 11, "#6a737d", summary);
    for (int i = 0; i <= 2; ++i) {
      const double y = top_ + kPlotHeight * (1.0 - 0.5 * i);
      out_ << text("<path d=\"M%.1f %.1fh%.1f\" stroke=\"#d0d7de\"/>\n", left_, y, kPlotWidth);
      write_text(left_ - 6.0, y + 4.0, "end", 11, "#30363d", number(0.5 * i * most_));
    }
    for (int i = 0; i <= 4; ++i) {
      const double x = left_ + 0.25 * i * kPlotWidth;
      write_text(x, top_ + kPlotHeight + 15.0, "middle", 11, "#30363d", text("%.3g s", 0.25 * i * seconds_));
    }
  }

  void line(const std::vector<Point>& points, const char* colour) const {
    out_ << "<polyline fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"1.1\" points=\"";
    for (const Point& point : points)
      out_ << text("%.1f,%.1f ", left_ + point.seconds / seconds_ * kPlotWidth,
                   top_ + kPlotHeight * (1.0 - std::min(1.0, point.value / most_)));
    out_ << "\"/>\n";
  }

 private:
  void write_text(double x, double y, const char* anchor, int size, const char* colour,
                  const std::string& what) const {
    out_ << text("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%d\" fill=\"%s\">", x, y, anchor,
                 size, colour)
         << what << "</text>\n";
  }

  double left_;
  double top_;
  double seconds_;
  double most_;
  std::ostream& out_;
};

void write_graph(std::size_t i, const std::vector<cli::Tick>& ticks, std::ostream& out) {
  const Quantity& quantity = quantities()[i];
  const bool searches = i == 2;
  const std::vector<Point> points = points_of(quantity, ticks, searches);
  const double seconds = std::max(1e-3, ticks.back().seconds - ticks.front().seconds);
  const std::vector<double> values = ascending(points);
  const bool are_times = quantity.unit == std::string_view("us");
  const std::size_t column = i % 2, row = i / 2;
  const double left = 60.0 + 480.0 * static_cast<double>(column),
               top = 95.0 + 250.0 * static_cast<double>(row);
  const Graph graph(left, top, seconds, height_of(values, are_times), out);
  graph.frame(kCaptions[i], summary_of(values, quantity.unit));
  graph.line(thinned(points, seconds), kColours[i]);
}

std::string escaped(const std::string& plain) {
  std::string safe;
  for (const char c : plain) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

}  // namespace

void write_graphs(const std::string& path, const std::string& title, const std::vector<cli::Tick>& ticks) {
  if (ticks.empty()) throw cli::Failure(path + ": there are no ticks to draw");
  std::ofstream file(path);
  file << text(
              "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"sans-serif\">"
              "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
              kWidth, kHeight)
       << text("<text x=\"%d\" y=\"30\" text-anchor=\"middle\" font-size=\"17\" fill=\"#30363d\">",
               kWidth / 2)
       << escaped(title) << "</text>\n";
  for (std::size_t i = 0; i < kPaperQuantities; ++i) write_graph(i, ticks, file);
  file << "</svg>\n";
  file.close();
  if (!file) throw cli::Failure(path + ": cannot be written");
}

}  // namespace palpate::viewer

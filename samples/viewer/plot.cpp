#include "samples/viewer/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <imgui.h>

namespace palpate::viewer {
namespace {

constexpr double kSeconds = 4.0;  // that a plot is wide

// The least of 1, 2, 5, 10, … that no value exceeds.
double scale_of(double most) {
  if (!(most > 0.0)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {1.0, 2.0, 5.0, 10.0})
    if (most <= step * decade) return step * decade;
  return 10.0 * decade;
}

std::string text_of(double value, const char* unit) {
  char text[48];
  const char* format = std::abs(value) >= 100.0 ? "%.0f %s" : std::abs(value) >= 10.0 ? "%.1f %s" : "%.2f %s";
  std::snprintf(text, sizeof text, value == std::floor(value) ? "%.0f %s" : format, value, unit);
  return text;
}

// The ticks from here on are plotted.
std::size_t first_shown(const History& history) {
  std::size_t first = history.size();
  while (first > 0 && history.newest().seconds - history[first - 1].seconds <= kSeconds) --first;
  return first;
}

std::vector<ImVec2> outline(const Quantity& quantity, const History& history, ImVec2 corner, ImVec2 size,
                            double scale) {
  std::vector<ImVec2> points;
  for (std::size_t i = first_shown(history); i < history.size(); ++i) {
    const double share = 1.0 - (history.newest().seconds - history[i].seconds) / kSeconds;
    const double value = std::min(1.0, quantity.of(history[i]) / scale);
    points.emplace_back(corner.x + static_cast<float>(share) * size.x,
                        corner.y + size.y - static_cast<float>(value) * (size.y - 2.0f));
  }
  return points;
}

// Few ticks exceed it: a single late one must not flatten all others.
double most_of(const Quantity& quantity, const History& history) {
  std::vector<double> values;
  for (std::size_t i = first_shown(history); i < history.size(); ++i)
    values.push_back(quantity.of(history[i]));
  if (values.empty()) return 0.0;
  const auto high = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 997 / 1000);
  std::nth_element(values.begin(), high, values.end());
  return *high;
}

}  // namespace

void draw_plot(const Quantity& quantity, const History& history, float height, unsigned colour) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const double now = history.size() > 0 ? quantity.of(history.newest()) : 0.0;
  const double scale = scale_of(most_of(quantity, history));
  ImGui::TextUnformatted(quantity.name);
  const std::string value = text_of(now, quantity.unit);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopStyleColor();

  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, height);
  const ImVec2 end(corner.x + size.x, corner.y + size.y);
  list->AddRectFilled(corner, end, IM_COL32(14, 17, 21, 255), 3.0f);
  const float middle = corner.y + 0.5f * size.y;
  list->AddLine(ImVec2(corner.x, middle), ImVec2(end.x, middle), IM_COL32(255, 255, 255, 22));
  list->PushClipRect(corner, end, true);
  const std::vector<ImVec2> points = outline(quantity, history, corner, size, scale);
  if (points.size() > 1) list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.3f);
  list->PopClipRect();
  list->AddText(ImVec2(corner.x + 4.0f, corner.y + 1.0f), IM_COL32(160, 168, 178, 255),
                text_of(scale, "").c_str());
  ImGui::Dummy(size);
}

}  // namespace palpate::viewer

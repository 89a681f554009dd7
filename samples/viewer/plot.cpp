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

std::vector<ImVec2> outline(const Quantity& quantity, const History& history, ImVec2 corner, ImVec2 size,
                            double scale) {
  std::vector<ImVec2> points;
  if (history.size() == 0) return points;
  const double end = history.newest().seconds;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double share = 1.0 - (end - history[i].seconds) / kSeconds;
    if (share < 0.0) continue;
    const double value = std::clamp(quantity.of(history[i]) / scale, 0.0, 1.0);
    points.emplace_back(corner.x + static_cast<float>(share) * size.x,
                        corner.y + size.y - static_cast<float>(value) * (size.y - 2.0f));
  }
  return points;
}

double most_of(const Quantity& quantity, const History& history) {
  double most = 0.0;
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history.newest().seconds - history[i].seconds <= kSeconds)
      most = std::max(most, quantity.of(history[i]));
  return most;
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

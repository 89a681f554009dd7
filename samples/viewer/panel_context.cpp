#include "samples/viewer/panel_context.h"

#include <filesystem>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace palpate::viewer {
namespace {

// Of Debian's fonts-dejavu-core; without it Dear ImGui's own font does.
constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float kFontSize = 13.0f;  // pixels

void set_style() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0f;
  style.WindowBorderSize = 0.0f;
  style.FrameRounding = 3.0f;
  style.GrabRounding = 3.0f;
  style.WindowPadding = ImVec2(12.0f, 8.0f);
  style.ItemSpacing = ImVec2(8.0f, 4.0f);
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.085f, 0.098f, 0.118f, 0.93f);
  style.Colors[ImGuiCol_FrameBg] = ImVec4(0.16f, 0.19f, 0.23f, 1.0f);
  style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.35f, 0.62f, 0.90f, 1.0f);
  style.Colors[ImGuiCol_Button] = ImVec4(0.19f, 0.30f, 0.43f, 1.0f);
  style.Colors[ImGuiCol_Separator] = ImVec4(0.25f, 0.28f, 0.32f, 1.0f);
}

}  // namespace

PanelContext::PanelContext() {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is written without being asked for
  if (std::filesystem::exists(kFont)) io.Fonts->AddFontFromFileTTF(kFont, kFontSize);
  set_style();
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

PanelContext::~PanelContext() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

}  // namespace palpate::viewer

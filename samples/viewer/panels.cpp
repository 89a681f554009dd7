#include "samples/viewer/panels.h"

#include <array>
#include <cmath>
#include <cstdio>

#include <imgui.h>

#include "samples/viewer/plot.h"

namespace palpate::viewer {
namespace {

constexpr ImU32 kFaint = IM_COL32(150, 158, 168, 255);
constexpr ImU32 kGood = IM_COL32(120, 210, 130, 255);
constexpr ImU32 kWarning = IM_COL32(245, 190, 80, 255);
constexpr ImU32 kBad = IM_COL32(245, 105, 95, 255);
constexpr ImU32 kPlotColours[] = {IM_COL32(120, 205, 255, 255), IM_COL32(160, 220, 130, 255),
                                  IM_COL32(250, 180, 90, 255),  IM_COL32(70, 165, 255, 255),
                                  IM_COL32(205, 125, 255, 255), IM_COL32(240, 240, 140, 255)};

constexpr const char* kLimiterNames[] = {
    "long tick",   "wrench not finite", "pose not finite", "pose jump",   "servo stale", "pose stale",
    "force clamp", "torque clamp",      "force slew",      "torque slew", "ramp"};

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoTitleBar |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void heading(const char* text) {
  ImGui::Dummy(ImVec2(0.0f, 3.0f));
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
  ImGui::Separator();
}

void coloured(ImU32 colour, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextWrapped("%s", text);
  ImGui::PopStyleColor();
}

// A name to the left and its value to the right.
template <class... Arguments>
void row(const char* name, const char* format, Arguments... arguments) {
  char text[128];
  std::snprintf(text, sizeof text, format, arguments...);
  ImGui::TextUnformatted(name);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(text).x);
  ImGui::TextUnformatted(text);
}

void model_row(const char* role, const ModelFile* file) {
  if (!file) return row(role, "%s", "none yet");
  row(role, "%s", file->name.c_str());
}

void draw_models(const PanelView& view, PanelChoices& choices) {
  heading("MODELS");
  model_row("scene", view.content.scene.get());
  model_row("tool", view.content.tool.get());
  if (view.content.complete())
    row("triangles", "%zu + %zu", view.content.scene->triangle_count(), view.content.tool->triangle_count());
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::InputTextWithHint("##path", "drop a file on the window, or type its path",
                               choices.typed_path.data(), choices.typed_path.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue)) {
    choices.opened = choices.typed_path.data();
    choices.typed_path = {};
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("it becomes the");
  ImGui::SameLine();
  if (ImGui::RadioButton("scene", !choices.drop_is_tool)) choices.drop_is_tool = false;
  ImGui::SameLine();
  if (ImGui::RadioButton("tool", choices.drop_is_tool)) choices.drop_is_tool = true;
}

bool slider(const char* name, double& value, double low, double high, const char* format, double unit) {
  auto shown = static_cast<float>(value / unit);
  ImGui::SetNextItemWidth(148.0f);
  const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
  const bool changed = ImGui::SliderFloat(name, &shown, static_cast<float>(low / unit),
                                          static_cast<float>(high / unit), format, flags);
  if (changed) value = unit * static_cast<double>(shown);
  return changed;
}

// At the left end of the slider there is no cap, and next to it the device's.
void draw_cap(double& cap) {
  constexpr double kNone = -200.0, kDevice = 50.0;
  double shown = cap < 0.0 ? kNone : cap;
  const char* const format = cap < 0.0 ? "none" : cap > 0.0 ? "%.0f N/m" : "the device's";
  if (!slider("cap", shown, kNone, 3000.0, format, 1.0)) return;
  cap = shown < 0.5 * kNone ? -1.0 : shown < kDevice ? 0.0 : shown;
}

void draw_settings(const PanelView& view, Settings& settings) {
  heading("CONTACT");
  const double diagonal = view.content.scene ? view.content.scene->diagonal() : 1.0;
  slider("cutoff", settings.cutoff, 1e-3 * diagonal, 0.06 * diagonal, "%.2f mm", 1e-3);
  slider("stiffness", settings.stiffness, 0.0, 3000.0, "%.0f N/m", 1.0);
  slider("damping", settings.damping, 0.0, 5.0, "%.2f N s/m", 1.0);
  draw_cap(settings.stiffness_cap);
  slider("friction", settings.friction, 0.0, 1.0, "%.2f", 1.0);
  ImGui::SetNextItemWidth(148.0f);
  ImGui::Combo("law", &settings.law, "springs\0smooth\0");
  ImGui::SetNextItemWidth(148.0f);
  ImGui::Combo("mode", &settings.mode, "global\0descent\0certified\0");
}

void draw_safety(const plp_device_state& device) {
  constexpr const char* kNames[] = {"disarmed", "fading in", "armed", "FAULT"};
  constexpr ImU32 kColours[] = {kFaint, kWarning, kGood, kBad};
  const int safety = device.safety & 3;
  ImGui::TextUnformatted("safety");
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(kNames[safety]).x);
  coloured(kColours[safety], kNames[safety]);
  row("gain", "%.2f", device.gain);
  std::string acting;
  for (std::size_t i = 0; i < std::size(kLimiterNames); ++i)
    if (device.limiters >> i & 1) acting += (acting.empty() ? "" : ", ") + std::string(kLimiterNames[i]);
  row("limiters", "%s", acting.empty() ? "none acts" : acting.c_str());
  const Vec3 force = vector_of(device.applied.force), torque = vector_of(device.applied.torque);
  row("to the hand", "%.2f N  %.0f mN m", glm::length(force), 1e3 * glm::length(torque));
}

void draw_device_choice(const PanelView& view, PanelChoices& choices) {
  std::array<plp_device_info, 16> infos;
  for (plp_device_info& info : infos) plp_device_info_init(&info, sizeof info);
  std::size_t count = 0;
  if (plp_device_list(infos.data(), infos.size(), &count) < 0) return;
  const std::string& now = view.content.arguments.device;
  ImGui::SetNextItemWidth(-1.0f);
  if (!ImGui::BeginCombo("##device", now.empty() ? "no device" : now.c_str())) return;
  for (std::size_t i = 0; i < std::min(count, infos.size()); ++i)
    if (ImGui::Selectable(infos[i].uri, now == infos[i].uri)) choices.device = infos[i].uri;
  ImGui::EndCombo();
}

void draw_device(const PanelView& view, PanelChoices& choices) {
  heading("DEVICE");
  draw_device_choice(view, choices);
  const FrameState* state = view.state;
  if (!state || !state->device) return coloured(kFaint, "The tool follows poses, not a device.");
  if (state->simulated) coloured(kWarning, "SIMULATED");
  ImGui::TextWrapped("%s", state->device_info->name);
  draw_safety(*state->device);
}

void draw_motion_choice(PanelChoices& choices) {
  int motion = static_cast<int>(choices.motion);
  ImGui::SetNextItemWidth(148.0f);
  if (!ImGui::Combo("hand", &motion, "keys and mouse\0tap\0press\0slide\0orbit\0")) return;
  choices.motion = static_cast<MotionKind>(motion);
  choices.motion_chosen = true;
}

void button(const char* name, Command command, PanelChoices& choices) {
  if (ImGui::Button(name)) choices.commands.push_back(command);
}

void draw_controls(const FrameState& state, PanelChoices& choices) {
  heading("CONTROL");
  draw_motion_choice(choices);
  button(state.paused ? "Resume" : "Pause", Command::kPause, choices);
  ImGui::SameLine();
  button("Step", Command::kStep, choices);
  ImGui::SameLine();
  button("Reset", Command::kReset, choices);
  if (state.device) {
    ImGui::SameLine();
    button(state.device->safety == PLP_SAFETY_DISARMED ? "Arm" : "Disarm", Command::kArm, choices);
  }
  button("Screenshot", Command::kScreenshot, choices);
  ImGui::SameLine();
  button("CSV", Command::kExport, choices);
  ImGui::SameLine();
  button("Graphs", Command::kGraphs, choices);
  ImGui::SameLine();
  button(state.recording.running ? "Stop###record" : "Record###record", Command::kRecord, choices);
  if (state.recording.running)
    row("recorded", "%llu steps, lost %llu", static_cast<unsigned long long>(state.recording.ticks),
        static_cast<unsigned long long>(state.recording.lost));
}

void draw_left(const PanelView& view, PanelChoices& choices) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
  ImGui::SetNextWindowSize(ImVec2(kLeftPanel, display.y));
  ImGui::Begin("left", nullptr, kFixed);
  draw_models(view, choices);
  draw_device(view, choices);
  if (view.state) {
    draw_settings(view, choices.settings);
    draw_controls(*view.state, choices);
  }
  heading("KEYS");
  coloured(kFaint,
           "W A S D Q E  move the hand\n"
           "Shift and these  turn it\n"
           "left mouse  around   right  shift\n"
           "wheel  nearer   Ctrl  mouse is the hand\n"
           "Space  pause   N  step   R  reset\n"
           "F  screenshot   C  CSV   G  graphs\n"
           "T  record   H  panels   Esc  quit");
  ImGui::End();
}

void draw_servo(const FrameState& state) {
  heading("SERVO");
  const plp_servo_state& servo = state.servo;
  if (!state.runs) {
    row("steps", "%s", state.paused ? "paused" : "by the picture's frames");
  } else {
    row("rate", "%.0f of %.0f Hz", servo.rate, servo.wanted_rate);
    row("a step p50, p99", "%.0f, %.0f us", servo.work_us[0], servo.work_us[1]);
    row("late p99", "%.0f us", servo.lateness_us[1]);
    row("missed, skipped", "%llu, %llu", static_cast<unsigned long long>(servo.missed),
        static_cast<unsigned long long>(servo.skipped));
  }
  row("simulated", "%.2f s", state.seconds);
}

void draw_contacts(const FrameState& state) {
  heading("CONTACTS");
  row("minima", "%zu in %zu points", state.contacts.set_count, state.lmds.size());
  if (std::isfinite(state.contacts.min_distance))
    row("nearest", "%.3f mm", 1e3 * state.contacts.min_distance);
  else
    row("nearest", "%s", "beyond the cutoff");
  row("age", "%llu ticks", static_cast<unsigned long long>(state.contacts.work.age));
  if (state.contacts.overlap) coloured(kWarning, "surfaces overlap");
  if (state.contacts.status & PLP_STATUS_WALL) coloured(kWarning, "walls hold the tool");
  if (state.contacts.status & PLP_STATUS_WAITING) coloured(kWarning, "a body is being made ready");
}

void draw_right(const PanelView& view) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x - kRightPanel, 0.0f));
  ImGui::SetNextWindowSize(ImVec2(kRightPanel, display.y));
  ImGui::Begin("right", nullptr, kFixed);
  draw_servo(*view.state);
  draw_contacts(*view.state);
  heading("THE LAST SECONDS");
  const std::span<const Quantity> plotted = quantities();
  const float text = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  const float room = ImGui::GetContentRegionAvail().y / static_cast<float>(plotted.size()) - text;
  for (std::size_t i = 0; i < plotted.size(); ++i)
    draw_plot(plotted[i], view.history, std::max(24.0f, room), kPlotColours[i]);
  ImGui::End();
}

// One sentence at the bottom of the picture; while models load, in its middle.
void draw_message(const PanelView& view) {
  const bool loads = !view.loading.empty();
  const char* const hint = "Drop a glTF file on this window: first the scene, then the tool.";
  const bool empty = !view.content.complete() && view.message.empty();
  const std::string& text = loads ? view.loading : empty ? std::string(hint) : view.message;
  if (text.empty()) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = display.x - kLeftPanel - (view.state ? kRightPanel : 0.0f) - 40.0f;
  ImGui::SetNextWindowPos(ImVec2(kLeftPanel + 20.0f, display.y - 16.0f), ImGuiCond_Always,
                          ImVec2(0.0f, 1.0f));
  ImGui::SetNextWindowSize(ImVec2(width, 0.0f));
  ImGui::Begin("message", nullptr, kFixed);
  coloured(view.message_is_error && !loads ? kBad : IM_COL32_WHITE, text.c_str());
  if (loads) {
    // How long it takes is not known: a light that goes to and fro says that it goes on.
    const float share = 0.5f - 0.5f * std::cos(3.0f * static_cast<float>(ImGui::GetTime()));
    ImGui::ProgressBar(share, ImVec2(-1.0f, 6.0f), "");
  }
  ImGui::End();
}

}  // namespace

void draw_panels(const PanelView& view, PanelChoices& choices) {
  draw_left(view, choices);
  if (view.state) draw_right(view);
  draw_message(view);
}

}  // namespace palpate::viewer

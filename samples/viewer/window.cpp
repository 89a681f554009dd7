#include "samples/viewer/window.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "samples/cli/failure.h"
#include "samples/viewer/panel_context.h"
#include "samples/viewer/viewer.h"

namespace palpate::viewer {
namespace {

std::string complaint() {
  const char* what = nullptr;
  glfwGetError(&what);
  return what ? what : "no reason is known";
}

class GlfwWindow {
 public:
  GlfwWindow(int width, int height, const std::string& title) {
    if (!glfwInit()) throw cli::Failure("no window can be opened: " + complaint() + "; use --headless");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
      const std::string why = complaint();
      glfwTerminate();
      throw cli::Failure("no window with OpenGL 3.3 can be opened: " + why);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
  }
  ~GlfwWindow() {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  GLFWwindow* get() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

struct KeyCommand {
  int key;
  Command command;
};

constexpr KeyCommand kKeyCommands[] = {
    {GLFW_KEY_SPACE, Command::kPause},  {GLFW_KEY_N, Command::kStep},   {GLFW_KEY_R, Command::kReset},
    {GLFW_KEY_F, Command::kScreenshot}, {GLFW_KEY_C, Command::kExport}, {GLFW_KEY_G, Command::kGraphs},
    {GLFW_KEY_T, Command::kRecord},     {GLFW_KEY_H, Command::kPanels}, {GLFW_KEY_ESCAPE, Command::kQuit}};

// Collects what happens between two frames. Dear ImGui's own callbacks call these first.
class InputCollector {
 public:
  explicit InputCollector(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int) {
      if (action == GLFW_PRESS) of(from).press(key);
    });
    glfwSetScrollCallback(window,
                          [](GLFWwindow* from, double, double notches) { of(from).next_.wheel += notches; });
    glfwSetDropCallback(window, [](GLFWwindow* from, int count, const char** paths) {
      of(from).next_.dropped.insert(of(from).next_.dropped.end(), paths, paths + count);
    });
  }

  Input take() {
    Input input = std::exchange(next_, {});
    take_mouse(input);
    if (!ImGui::GetIO().WantTextInput) take_keys(input);
    return input;
  }

 private:
  static InputCollector& of(GLFWwindow* window) {
    return *static_cast<InputCollector*>(glfwGetWindowUserPointer(window));
  }

  void press(int key) {
    if (ImGui::GetIO().WantTextInput) return;
    for (const KeyCommand& bound : kKeyCommands)
      if (bound.key == key) next_.commands.push_back(bound.command);
  }

  bool down(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }
  bool button(int which) const { return glfwGetMouseButton(window_, which) == GLFW_PRESS; }
  double between(int less, int more) const { return (down(more) ? 1.0 : 0.0) - (down(less) ? 1.0 : 0.0); }

  void take_mouse(Input& input) {
    glm::dvec2 now;
    glfwGetCursorPos(window_, &now.x, &now.y);
    input.mouse = now - std::exchange(cursor_, now);
    if (ImGui::GetIO().WantCaptureMouse) {
      input.wheel = 0.0;
      return;
    }
    const bool left = button(GLFW_MOUSE_BUTTON_LEFT), right = button(GLFW_MOUSE_BUTTON_RIGHT);
    const bool hand = down(GLFW_KEY_LEFT_CONTROL) || down(GLFW_KEY_RIGHT_CONTROL);
    input.orbit = left && !hand;
    input.pan = right && !hand;
    input.lead_turn = right && hand;
    input.lead = hand && !input.lead_turn && (left || input.wheel != 0.0);
    if (input.lead && !left) input.mouse = glm::dvec2(0.0);
  }

  void take_keys(Input& input) const {
    const Vec3 keys(between(GLFW_KEY_A, GLFW_KEY_D), between(GLFW_KEY_Q, GLFW_KEY_E),
                    between(GLFW_KEY_W, GLFW_KEY_S));
    const bool turn = down(GLFW_KEY_LEFT_SHIFT) || down(GLFW_KEY_RIGHT_SHIFT);
    (turn ? input.turn : input.move) = turn ? Vec3(keys.z, keys.x, keys.y) : keys;
  }

  GLFWwindow* window_;
  Input next_;
  glm::dvec2 cursor_{0.0};
};

class GlfwPanels {
 public:
  explicit GlfwPanels(GLFWwindow* window) { ImGui_ImplGlfw_InitForOpenGL(window, true); }
  ~GlfwPanels() { ImGui_ImplGlfw_Shutdown(); }
  GlfwPanels(const GlfwPanels&) = delete;
  GlfwPanels& operator=(const GlfwPanels&) = delete;
};

void draw_frame(GLFWwindow* window, Viewer& viewer) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  if (width == 0 || height == 0) return;  // out of sight
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  viewer.draw(width, height, 0);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  viewer.write_wanted_screenshot(width, height);
  glfwSwapBuffers(window);
}

}  // namespace

void run_window(const Arguments& arguments) {
  constexpr double kLongest = 0.1;  // s that a hand moves on in one frame
  const GlfwWindow window(arguments.width, arguments.height, "Palpate");
  InputCollector collector(window.get());
  const PanelContext context;
  const GlfwPanels panels(window.get());
  Viewer viewer(arguments);
  double before = glfwGetTime();
  while (!glfwWindowShouldClose(window.get()) && !viewer.wants_to_quit()) {
    glfwPollEvents();
    const double now = glfwGetTime();
    viewer.update(collector.take(), std::min(kLongest, now - std::exchange(before, now)));
    draw_frame(window.get(), viewer);
  }
  viewer.end_recording();
  std::cout << viewer.summary() << '\n' << viewer.frames_summary() << '\n';
}

}  // namespace palpate::viewer

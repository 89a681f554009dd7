#include "samples/viewer/film.h"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <thread>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "samples/viewer/headless_context.h"
#include "samples/viewer/headless_framebuffer.h"
#include "samples/viewer/panel_context.h"
#include "samples/viewer/png_file.h"
#include "samples/viewer/viewer.h"

namespace palpate::viewer {
namespace {

constexpr double kFrame = 1.0 / 60.0;  // s
constexpr unsigned kFrames = 250;

class Film {
 public:
  explicit Film(const Arguments& arguments)
      : arguments_(arguments), framebuffer_(arguments.width, arguments.height), viewer_(arguments) {
    viewer_.wait_until_loaded();
  }

  void run() {
    run_once();
    for (unsigned i = 1; i < arguments_.runs; ++i) {
      viewer_.begin_anew();
      run_once();
    }
  }

  void write() {
    if (!arguments_.screenshot.empty()) {
      draw();
      draw();  // panels have their sizes only now
      write_screenshot(arguments_.screenshot, arguments_.width, arguments_.height);
    }
    viewer_.end_recording();
    if (!arguments_.log.empty()) viewer_.write_log(arguments_.log);
    if (!arguments_.graphs.empty()) viewer_.write_graphs(arguments_.graphs);
    std::cout << viewer_.summary() << '\n';
    if (!arguments_.stepped) std::cout << viewer_.frames_summary() << '\n';
    say("screenshot", arguments_.screenshot);
    say("trace", arguments_.record);
    say("force log", arguments_.log);
    say("graphs", arguments_.graphs);
  }

 private:
  void run_once() {
    auto due = std::chrono::steady_clock::now();
    for (unsigned i = 0; goes_on(i); ++i) {
      viewer_.update({}, kFrame);
      if (arguments_.stepped) continue;
      draw();
      due += std::chrono::duration_cast<std::chrono::steady_clock::duration>(
          std::chrono::duration<double>(kFrame));
      std::this_thread::sleep_until(due);
    }
  }

  bool goes_on(unsigned frame) const {
    if (arguments_.frames) return frame < *arguments_.frames;
    const bool ends_by_itself = arguments_.replay && arguments_.device.empty();
    return ends_by_itself ? !viewer_.finished() : frame < kFrames;
  }

  void draw() {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(arguments_.width), static_cast<float>(arguments_.height));
    io.DeltaTime = static_cast<float>(kFrame);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    viewer_.draw(arguments_.width, arguments_.height, framebuffer_.name());
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glFinish();
  }

  static void say(const char* what, const std::string& path) {
    if (!path.empty()) std::cout << what << ": " << std::filesystem::absolute(path).string() << '\n';
  }

  Arguments arguments_;
  HeadlessContext context_;
  HeadlessFramebuffer framebuffer_;
  PanelContext panels_;
  Viewer viewer_;
};

}  // namespace

void run_film(const Arguments& arguments) {
  Film film(arguments);
  film.run();
  film.write();
}

}  // namespace palpate::viewer

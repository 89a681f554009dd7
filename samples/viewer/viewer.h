#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "samples/viewer/input.h"
#include "samples/viewer/loading.h"
#include "samples/viewer/panels.h"
#include "samples/viewer/picture.h"
#include "samples/viewer/session.h"

namespace palpate::viewer {

// The whole of it between a surface to draw on and the library. Needs a current OpenGL context and one of
// Dear ImGui.
class Viewer {
 public:
  explicit Viewer(const Arguments& arguments);

  // Throws cli::Failure, for programs without a window.
  void wait_until_loaded();
  // The same once more: a tick's times are the least of all runs.
  void begin_anew();
  bool finished() const { return session_ && session_->finished(); }

  // What a person did goes in, and time goes by.
  void update(const Input& input, double seconds);

  // Draws the scene; panels are left to Dear ImGui's draw data.
  void draw(int width, int height, GLuint framebuffer);

  // After Dear ImGui has drawn on the bound framebuffer, too.
  void write_wanted_screenshot(int width, int height);

  void end_recording();  // if there is one
  void write_log(const std::string& path) const;
  void write_graphs(const std::string& path) const;
  std::string summary() const;  // of what has been felt
  std::string frames_summary() const;
  bool wants_to_quit() const { return quit_; }

 private:
  void load(const Arguments& arguments);
  void take_up(Content content);
  void look_at_all();
  void begin_session();
  void reset();
  void poll_loading();
  void take_input(const Input& input, double seconds);
  void lead_hand(const Input& input, double seconds);
  void take_dropped(const std::string& path);
  void take_choices();
  void change_device(const std::string& uri);
  void execute(Command command);
  void execute_on_session(Command command);
  void record_or_stop();
  std::vector<cli::Tick> ticks() const;
  void attempt(const std::function<void()>& what);  // tells why it fails
  void tell(std::string message, bool is_error = false);

  Arguments arguments_;
  std::shared_ptr<const Content> content_;
  std::unique_ptr<Loading> loading_;  // null: nothing is being loaded
  std::unique_ptr<Session> session_;  // null: nothing runs
  Picture picture_;
  Camera camera_;
  PanelChoices choices_;
  std::vector<std::string> pending_;  // dropped paths that wait for what is being loaded
  std::string record_;                // a file for the trace of the first session; empty: none
  bool panels_ = true;
  bool quit_ = false;
  bool screenshot_ = false;
  std::vector<cli::Tick> least_;  // the ticks of the runs before, with their least times
  std::uint64_t frames_ = 0;
  std::uint64_t frames_while_loading_ = 0;
  std::string message_;
  bool message_is_error_ = false;
};

}  // namespace palpate::viewer

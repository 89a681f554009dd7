#include "samples/viewer/viewer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <utility>

#include <imgui.h>

#include "samples/viewer/graphs.h"
#include "samples/viewer/png_file.h"

namespace palpate::viewer {
namespace {

constexpr std::size_t kRemembered = 60'000;  // ticks: a minute
constexpr const char* kScreenshot = "palpate-viewer.png";
constexpr const char* kLog = "palpate-viewer.csv";
constexpr const char* kGraphs = "palpate-viewer.svg";
constexpr const char* kTrace = "palpate-viewer.plptrace";

std::string or_else(const std::string& given, const char* otherwise) {
  return given.empty() ? otherwise : given;
}

std::size_t remembered(const Arguments& arguments, const Content& content) {
  if (!arguments.headless) return kRemembered;
  const std::size_t ticks = std::size_t{arguments.frames.value_or(1)} * arguments.ticks_per_frame;
  const cli::Motion* replay = content.arguments.replay.get();
  return std::max({ticks, replay ? replay->poses().size() : 0, kRemembered});
}

}  // namespace

Viewer::Viewer(const Arguments& arguments)
    : arguments_(arguments), content_(std::make_shared<Content>()), record_(arguments.record) {
  choices_.motion = arguments.motion;
  choices_.drop_is_tool = !arguments.scene.empty();
  load(arguments);
}

void Viewer::wait_until_loaded() {
  Content content = loading_->wait();
  loading_.reset();
  take_up(std::move(content));
}

void Viewer::begin_anew() {
  least_ = ticks();
  reset();
}

void Viewer::update(const Input& input, double seconds) {
  // What fails keeps nothing else from being done, least of all what a person asks for.
  attempt([&] { poll_loading(); });
  attempt([&] { take_input(input, seconds); });
  attempt([&] {
    if (!session_) return;
    session_->advance();
    choices_.settings = session_->rig().settings();  // which a trace may have changed
  });
}

void Viewer::draw(int width, int height, GLuint framebuffer) {
  ++frames_;
  frames_while_loading_ += loading_ ? 1 : 0;
  std::optional<FrameState> state;
  if (session_) state = session_->state();
  picture_.draw(*content_, camera_, state ? &*state : nullptr, width, height, framebuffer);
  if (!panels_) return;
  const std::string loading = loading_ ? loading_->stage() : "";
  const History none(1);
  draw_panels({*content_, state ? &*state : nullptr, session_ ? session_->history() : none, loading, message_,
               message_is_error_},
              choices_);
}

void Viewer::write_wanted_screenshot(int width, int height) {
  if (!std::exchange(screenshot_, false)) return;
  const std::string path = or_else(arguments_.screenshot, kScreenshot);
  write_screenshot(path, width, height);
  tell("Wrote " + path);
}

void Viewer::write_log(const std::string& path) const {
  std::ofstream file(path);
  if (file) cli::write_csv(ticks(), file);
  file.close();
  if (!file) throw cli::Failure(path + ": cannot be written");
}

void Viewer::write_graphs(const std::string& path) const {
  constexpr const char* kModes[] = {"global", "descent", "certified"};
  constexpr const char* kLaws[] = {"springs", "smooth"};
  const Settings& settings = session_->rig().settings();
  std::array<char, 128> how{};
  std::snprintf(how.data(), how.size(), ": %s, %s, cutoff %.2g mm, %g N/m", kModes[settings.mode],
                kLaws[settings.law], 1e3 * settings.cutoff, settings.stiffness);
  viewer::write_graphs(path, content_->scene->name + " and " + content_->tool->name + how.data(), ticks());
}

std::string Viewer::frames_summary() const {
  return std::to_string(frames_) + " frames were drawn, " + std::to_string(frames_while_loading_) +
         " of them while models were loaded";
}

std::string Viewer::summary() const {
  if (!session_ || session_->history().size() == 0) return "Nothing was felt";
  const cli::RunSummary run = cli::summary_of(ticks());
  std::array<char, 256> text{};
  std::snprintf(
      text.data(), text.size(),
      "%zu ticks, %zu of them in contact, %zu overlapping, at most %zu local minimum distances; a tick took "
      "p50 %.1f, p99 %.1f us",
      run.ticks, run.ticks_in_contact, run.ticks_overlapping, run.most_lmds, run.local_us_p50,
      run.local_us_p99);
  std::string all = text.data();
  const plp_servo_state servo = session_->rig().servo();
  if (servo.ticks == 0) return all;
  std::snprintf(
      text.data(), text.size(),
      "\nthe servo ran %llu steps at %.1f a second beside the pictures, %llu of them too long, %llu left "
      "out; a step took p50 %.1f, p99 %.1f us",
      static_cast<unsigned long long>(servo.ticks), servo.rate, static_cast<unsigned long long>(servo.missed),
      static_cast<unsigned long long>(servo.skipped), servo.work_us[0], servo.work_us[1]);
  return all + text.data();
}

void Viewer::load(const Arguments& arguments) {
  arguments_ = arguments;
  loading_ = std::make_unique<Loading>(arguments, *content_);
  tell("");
}

void Viewer::poll_loading() {
  if (!loading_) return;
  try {
    std::optional<Content> content = loading_->finished();
    if (!content) return;
    loading_.reset();
    take_up(std::move(*content));
  } catch (const cli::Failure&) {
    // What was there before stays.
    loading_.reset();
    const Arguments& before = content_->arguments;
    arguments_.scene = before.scene;
    arguments_.tool = before.tool;
    arguments_.tool_scale = before.tool_scale;
    choices_.drop_is_tool = content_->scene != nullptr;
    throw;
  }
}

void Viewer::take_up(Content content) {
  session_.reset();
  arguments_ = content.arguments;
  content_ = std::make_shared<const Content>(std::move(content));
  picture_.show(*content_);
  look_at_all();
  choices_.settings = arguments_.settings;
  choices_.motion = arguments_.motion;
  if (content_->complete()) begin_session();
}

void Viewer::look_at_all() {
  if (!content_->scene) {
    if (content_->tool)
      camera_.look_at(content_->tool->centre(), 0.5 * content_->tool->diagonal(), arguments_.up);
    return;
  }
  const Vec3 scene = content_->scene->centre();
  const double radius = 0.5 * content_->scene->diagonal();
  if (!content_->complete()) return camera_.look_at(scene, radius, arguments_.up);
  // The ball around the balls of both, half way between their middles as far as they differ in size.
  const Vec3 tool = content_->place.contact * content_->tool->centre();
  const double apart = glm::length(tool - scene), other = 0.5 * content_->tool->diagonal();
  const double reach = std::max(0.0, apart + other - radius);
  const Vec3 towards = apart > 0.0 ? (tool - scene) / apart : Vec3(0.0);
  camera_.look_at(scene + 0.5 * reach * towards, 1.03 * (radius + 0.5 * reach), arguments_.up);
}

void Viewer::begin_session() {
  session_.reset();  // gives its device back first
  // What is begun anew later would overwrite the trace.
  const std::string record = std::exchange(record_, "");
  session_ = std::make_unique<Session>(content_, remembered(arguments_, *content_), record);
  session_->rig().apply(choices_.settings);
}

void Viewer::reset() {
  choices_.motion = arguments_.motion;
  if (arguments_.replay) choices_.settings = content_->arguments.settings;
  begin_session();
}

void Viewer::take_input(const Input& input, double seconds) {
  pending_.insert(pending_.end(), input.dropped.begin(), input.dropped.end());
  if (!choices_.opened.empty()) pending_.push_back(std::exchange(choices_.opened, ""));
  // One after the other, so that each finds what those before it became.
  if (!loading_ && !pending_.empty()) {
    const std::string path = pending_.front();
    pending_.erase(pending_.begin());
    take_dropped(path);
  }
  if (input.orbit) camera_.orbit(input.mouse);
  if (input.pan) camera_.pan(input.mouse, arguments_.height);
  if (!input.lead) camera_.zoom(input.wheel);
  if (session_ && !session_->paused() && !session_->hand().scripted()) lead_hand(input, seconds);
  take_choices();
  for (const Command command : input.commands) execute(command);
}

void Viewer::lead_hand(const Input& input, double seconds) {
  constexpr double kSpeed = 0.25;     // scene diagonals a second
  constexpr double kTurning = 0.9;    // rad/s
  constexpr double kRadians = 0.006;  // a pixel
  const auto in_scene = [&](const Vec3& v) {
    return v.x * camera_.right() + v.y * camera_.above() + v.z * camera_.towards();
  };
  Vec3 move = kSpeed * content_->scene->diagonal() * seconds * input.move;
  Vec3 turn = kTurning * seconds * input.turn;
  const double pixel = camera_.pixel(arguments_.height);
  if (input.lead) move += pixel * Vec3(input.mouse.x, -input.mouse.y, -8.0 * input.wheel);
  if (input.lead_turn) turn += kRadians * Vec3(input.mouse.y, input.mouse.x, 0.0);
  if (move == Vec3(0.0) && turn == Vec3(0.0)) return;
  session_->hand().move(in_scene(move), in_scene(turn), seconds);
}

void Viewer::take_dropped(const std::string& path) {
  Arguments arguments = arguments_;
  (choices_.drop_is_tool ? arguments.tool : arguments.scene) = path;
  if (choices_.drop_is_tool) arguments.tool_scale = 1.0;
  // What was chosen for other models does not fit these.
  arguments.settings.cutoff = 0.0;
  arguments.pose.reset();
  arguments.replay.reset();
  arguments.motion = MotionKind::kHold;
  choices_.drop_is_tool = true;
  load(arguments);
}

void Viewer::take_choices() {
  if (!choices_.device.empty() && !loading_) change_device(std::exchange(choices_.device, ""));
  if (!session_) return choices_.commands.clear();
  session_->rig().apply(choices_.settings);
  if (std::exchange(choices_.motion_chosen, false)) session_->hand().begin(choices_.motion);
  for (const Command command : std::exchange(choices_.commands, {})) execute(command);
}

void Viewer::change_device(const std::string& uri) {
  session_.reset();  // gives the one that it has back
  Arguments arguments = content_->arguments;
  arguments.device = uri;
  arguments.stepped = arguments.headless;
  arguments.settings = choices_.settings;
  load(arguments);
}

void Viewer::execute(Command command) {
  if (command == Command::kQuit) quit_ = true;
  if (command == Command::kPanels) panels_ = !panels_;
  if (command == Command::kScreenshot) screenshot_ = true;
  if (session_) execute_on_session(command);
}

void Viewer::execute_on_session(Command command) {
  const std::string log = or_else(arguments_.log, kLog), graphs = or_else(arguments_.graphs, kGraphs);
  switch (command) {
    case Command::kPause:
      return session_->pause(!session_->paused());
    case Command::kStep:
      session_->pause(true);
      return session_->step();
    case Command::kReset:
      return reset();
    case Command::kArm:
      if (session_->rig().has_device())
        session_->rig().arm(session_->rig().device_state().safety == PLP_SAFETY_DISARMED);
      return;
    case Command::kExport:
      write_log(log);
      return tell("Wrote " + log);
    case Command::kGraphs:
      write_graphs(graphs);
      return tell("Wrote " + graphs);
    case Command::kRecord:
      return record_or_stop();
    case Command::kScreenshot:
    case Command::kPanels:
    case Command::kQuit:
      return;
  }
}

void Viewer::record_or_stop() {
  if (session_->rig().recording().running) return end_recording();
  const std::string path = or_else(arguments_.record, kTrace);
  session_->rig().record(path);
  tell("Recording into " + path);
}

void Viewer::end_recording() {
  if (!session_ || !session_->rig().recording().running) return;
  const plp_recording recording = session_->rig().stop_recording();
  tell("Recorded " + std::to_string(recording.ticks) + " steps, lost " + std::to_string(recording.lost));
}

std::vector<cli::Tick> Viewer::ticks() const {
  std::vector<cli::Tick> ticks;
  const History& history = session_->history();
  for (std::size_t i = 0; i < history.size(); ++i) ticks.push_back(history[i]);
  for (std::size_t i = 0; i < std::min(ticks.size(), least_.size()); ++i) {
    ticks[i].local_us = std::min(ticks[i].local_us, least_[i].local_us);
    ticks[i].work.global_us = std::min(ticks[i].work.global_us, least_[i].work.global_us);
  }
  return ticks;
}

void Viewer::attempt(const std::function<void()>& what) {
  try {
    what();
  } catch (const cli::Failure& failure) {
    if (arguments_.headless) throw;
    tell(failure.what(), true);
  }
}

void Viewer::tell(std::string message, bool is_error) {
  // Once: what fails in every frame fails sixty times a second.
  if (is_error && message != message_) std::cerr << "palpate-viewer: " << message << '\n';
  message_ = std::move(message);
  message_is_error_ = is_error;
}

}  // namespace palpate::viewer

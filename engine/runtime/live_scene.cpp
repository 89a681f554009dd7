#include "engine/runtime/live_scene.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>
#include <utility>

#include "engine/runtime/scene_commands.h"
#include "engine/runtime/trace_records.h"

namespace palpate {
namespace {

// So that no flood of changes makes a tick late: the rest waits for the next.
constexpr std::size_t kMostCommandsATick = 256;

// Pairs are made ready so long before they can be within the cutoff, in seconds, and always this much farther
// out, relative to it.
constexpr double kReadyAhead = 0.1;
constexpr double kReadyReach = 2.0;

// The servo lets a device go in its next tick, after which anybody may have it. One that does not tick is not
// waited for any longer than this.
constexpr std::chrono::milliseconds kLongestWait{100};
constexpr std::chrono::microseconds kLookAgain{50};

void wait_for(const Flag& done) {
  const auto end = std::chrono::steady_clock::now() + kLongestWait;
  while (!done.raised() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kLookAgain);
}

void destroy_all(Letter* letter) {
  while (letter) delete std::exchange(letter, letter->next());
}

}  // namespace

LiveScene::LiveScene(const SceneOptions& options) : options_(options), scene_(options) {}

LiveScene::~LiveScene() {
  go_still();
  Recording outcome;
  static_cast<void>(stop_recording(outcome));
}

Result<BodyId> LiveScene::add(BodyOptions options) {
  const std::lock_guard lock(mutex_);
  const bool is_tool = options.kind == BodyKind::kTool;
  if (is_tool && tool_ != 0) return Error{ErrorCode::kInvalidArgument, "the scene has a tool already"};
  const BodyId id = ids_.take();
  if (id == 0) return Error{ErrorCode::kLimit, "the scene is full"};
  try {
    place(id, std::move(options));
  } catch (...) {
    ids_.give_back(id);
    throw;
  }
  if (is_tool) tool_ = id;
  return id;
}

void LiveScene::place(BodyId id, BodyOptions options) {
  if (slot_of(id) >= records_.size()) records_.resize(slot_of(id) + 1);
  auto record = std::make_unique<BodyRecord>(id);
  record->kind = options.kind;
  record->model = options.model;
  record->pose = options.pose;
  record->as_added = options;
  if (recording_) recording_->add(trace_of(id, options));
  auto body = std::make_unique<Body>(std::move(options));
  body->id = id;
  carry_out(std::make_unique<AddBody>(std::move(body), slots_for(id)));
  records_[slot_of(id)] = std::move(record);
}

// Room in the scene's table, brought from outside while the servo may not allocate it.
BodyTable::Slots LiveScene::slots_for(BodyId id) {
  BodyTable::Slots slots;
  if (!live_ || slot_of(id) < slot_room_) return slots;
  slots.reserve(2 * slot_of(id) + 1);
  slot_room_ = slots.capacity();
  return slots;
}

bool LiveScene::remove(BodyId id) {
  const std::lock_guard lock(mutex_);
  if (!find(id)) return false;
  carry_out(std::make_unique<RemoveBody>(std::move(records_[slot_of(id)])));
  ids_.give_back(id);
  if (id == tool_) tool_ = 0;
  return true;
}

bool LiveScene::set_pose(BodyId id, const Pose& pose) {
  const std::lock_guard lock(mutex_);
  BodyRecord* const record = find(id);
  if (!record) return false;
  record->pose = pose;
  record->in_hand = id == tool_ && device_ != nullptr;
  if (!live_) return scene_.set_pose(id, pose);
  if (record->post.send(pose)) inbox_.post(&record->post);
  return true;
}

std::optional<Pose> LiveScene::pose_of(BodyId id) {
  const std::lock_guard lock(mutex_);
  const BodyRecord* const record = find(id);
  if (!record) return std::nullopt;
  const bool in_hand = record->in_hand || (id == tool_ && device_);
  return in_hand ? pose_in_hand(*record) : record->pose;
}

// A device moves the tool without a word to its record.
Pose LiveScene::pose_in_hand(const BodyRecord& tool) {
  if (!live_) return scene_.find(tool.id)->pose();
  parts_->tool_places.fetch();
  const ToolView& view = parts_->tool_places.front();
  return view.tool == tool.id ? view.pose : tool.pose;
}

template <class Change>
void LiveScene::change(Change change) {
  carry_out(std::make_unique<ChangeScene<Change>>(change));
}

void LiveScene::set_cutoff(double cutoff) {
  const std::lock_guard lock(mutex_);
  change([cutoff](Scene& scene) { scene.set_cutoff(cutoff); });
  options_.cutoff = cutoff;
}

void LiveScene::set_stiffness(double stiffness) {
  const std::lock_guard lock(mutex_);
  change([stiffness](Scene& scene) { scene.set_stiffness(stiffness); });
  options_.stiffness = stiffness;
}

void LiveScene::set_damping(double damping) {
  const std::lock_guard lock(mutex_);
  change([damping](Scene& scene) { scene.set_damping(damping); });
  options_.damping = damping;
}

void LiveScene::set_stiffness_cap(double cap) {
  const std::lock_guard lock(mutex_);
  change([cap](Scene& scene) { scene.set_stiffness_cap(cap); });
  options_.stiffness_cap = cap;
}

void LiveScene::set_friction(double friction) {
  const std::lock_guard lock(mutex_);
  change([friction](Scene& scene) { scene.set_friction(friction); });
  options_.friction = friction;
}

void LiveScene::set_law(ForceLaw law) {
  const std::lock_guard lock(mutex_);
  change([law](Scene& scene) { scene.set_law(law); });
  options_.law = law;
}

void LiveScene::set_mode(SearchMode mode) {
  const std::lock_guard lock(mutex_);
  change([mode](Scene& scene) { scene.set_mode(mode); });
  options_.mode = mode;
}

Status LiveScene::set_device(std::shared_ptr<GuardedDevice> device, const DeviceMapping& mapping) {
  const auto done = std::make_shared<Flag>();
  bool live = false;
  {
    const std::lock_guard lock(mutex_);
    if (device && device != device_ && !device->claim())
      return Error{ErrorCode::kWrongState, "another scene has the device; take it from there first"};
    if (BodyRecord* const tool = find(tool_)) tool->in_hand = true;
    device_ = device;
    live = live_;
    change([this, device, mapping, done](Scene&) mutable {
      device = loop_.exchange(std::move(device), mapping);
      done->raise();
    });
  }
  if (live) wait_for(*done);
  return Done{};
}

std::shared_ptr<GuardedDevice> LiveScene::device() {
  const std::lock_guard lock(mutex_);
  return device_;
}

Status LiveScene::step() {
  const std::lock_guard lock(mutex_);
  if (live_) return Error{ErrorCode::kWrongState, "the scene's servo runs"};
  loop_.tick(options_.time_step);
  if (recorder_) recorder_->record_whole(scene_, options_.time_step);
  return Done{};
}

Status LiveScene::record(const std::string& path, const TraceSpace& space) {
  const std::lock_guard lock(mutex_);
  if (recording_) return Error{ErrorCode::kWrongState, "the scene is recorded already"};
  Result<std::shared_ptr<SceneRecorder>> recorder =
      SceneRecorder::create(path, trace_of(options_, space), records_.size());
  if (!recorder) return recorder.error();
  for (const auto& record : records_)
    if (record) recorder.value()->add(trace_of(record->id, record->as_added));
  attach(recorder.value(), std::make_shared<Flag>());
  recording_ = std::move(recorder.value());
  return Done{};
}

Status LiveScene::stop_recording(Recording& outcome) {
  const auto done = std::make_shared<Flag>();
  std::shared_ptr<SceneRecorder> ended;
  bool live = false;
  {
    const std::lock_guard lock(mutex_);
    if (!recording_) return Error{ErrorCode::kWrongState, "the scene is not recorded"};
    attach(nullptr, done);
    ended = std::move(recording_);
    live = live_;
  }
  if (live) wait_for(*done);
  const Status status = ended->finish();
  outcome = ended->state();
  return status;
}

// The servo takes it up, or lets it go, between two ticks.
void LiveScene::attach(std::shared_ptr<SceneRecorder> recorder, std::shared_ptr<Flag> done) {
  change([this, recorder, done](Scene& scene) mutable {
    if (recorder_) recorder_->leave(scene);
    if (recorder) recorder->meet(scene);
    recorder_.swap(recorder);
    done->raise();
  });
}

Recording LiveScene::recording() {
  const std::lock_guard lock(mutex_);
  return recording_ ? recording_->state() : Recording{};
}

Status LiveScene::go_live() {
  {
    const std::lock_guard lock(mutex_);
    if (live_) return Error{ErrorCode::kWrongState, "the scene's servo runs"};
    BodyTable::Slots slots;
    slots.reserve(2 * records_.size() + 1);
    const std::size_t slot_room = slots.capacity();
    parts_.emplace(inbox_);
    scene_.fix();
    scene_.move_to(slots);
    slot_room_ = slot_room;
    publish_tool(0.0);
    live_ = true;
  }
  try {
    search_globally();
    execute_commands(std::numeric_limits<std::size_t>::max());
  } catch (...) {
    go_still();
    throw;
  }
  return Done{};
}

void LiveScene::go_still() {
  const std::lock_guard lock(mutex_);
  if (!live_) return;
  execute_commands(std::numeric_limits<std::size_t>::max());
  destroy_returned();
  scene_.unfix();
  live_ = false;
}

void LiveScene::tick(double dt) noexcept {
  execute_commands(kMostCommandsATick);
  loop_.tick(dt);
  if (recorder_) recorder_->record(scene_, dt);
  publish(dt);
}

void LiveScene::execute_commands(std::size_t most) {
  for (std::size_t count = 0; count < most; ++count) {
    if (!pending_) pending_ = inbox_.take();
    if (!pending_) return;
    auto* const command = static_cast<Command*>(pending_);
    pending_ = command->next();  // first: a command that does not end may be posted anew
    const bool ends = command->ends();
    command->execute(scene_);
    if (ends) returned_.post(command);
  }
}

void LiveScene::publish(double dt) {
  const Contacts& contacts = scene_.contacts();
  parts_->outcomes.back() = contacts;
  parts_->outcomes.publish();
  if (contacts.status & kStatusWaiting) parts_->waiting_ticks.add(1);
  if (contacts.status & kStatusCut) parts_->cut_ticks.add(1);
  publish_tool(dt);
}

void LiveScene::publish_tool(double dt) {
  const Body* const tool = scene_.find(scene_.tool());
  if (!tool) return;
  for (TripleSlot<ToolView>* slot : {&parts_->tool_views, &parts_->tool_places}) {
    slot->back() = {scene_.tool(), tool->pose(), scene_.steps(), dt};
    slot->publish();
  }
}

bool LiveScene::search_globally() {
  destroy_returned();
  take_survey();
  const bool worked = survey_.tool != 0 && parts_->global.run(survey_);
  survey_.near.clear();
  survey_.tool_model.reset();
  return worked;
}

void LiveScene::destroy_returned() {
  destroy_all(returned_.take());
}

void LiveScene::take_survey() {
  parts_->tool_views.fetch();
  ToolView view = parts_->tool_views.front();
  const std::lock_guard lock(mutex_);
  survey_.near.clear();
  survey_.tool = tool_;
  survey_.options = options_;
  const BodyRecord* const tool = find(tool_);
  if (!tool) return;
  if (view.tool != tool_) view = {tool_, tool->pose, 0, 0.0};
  survey_.tool_model = tool->model;
  survey_.tool_pose = view.pose;
  survey_.step = view.step;
  const Sphere around = view.pose * Sphere{tool->model->centre(), tool->model->radius()};
  for (const auto& record : records_)
    if (record && record->id != tool_ && soon_near(*record, around, view))
      survey_.near.push_back({record->id, record->model, record->pose});
}

bool LiveScene::soon_near(BodyRecord& record, const Sphere& tool, const ToolView& view) const {
  const Sphere body = record.pose * Sphere{record.model->centre(), record.model->radius()};
  const DVec3 at = body.centre - tool.centre;
  if (record.seen && view.step > record.seen->step && view.dt > 0.0) {
    const double seconds = static_cast<double>(view.step - record.seen->step) * view.dt;
    // A leap from one place to another is not a speed.
    record.ahead = std::min(glm::length(at - record.seen->at) * kReadyAhead / seconds,
                            options_.cutoff + body.radius + tool.radius);
  }
  if (!record.seen || view.step > record.seen->step) record.seen = {at, view.step};
  return within_reach(body, tool, kReadyReach * options_.cutoff + record.ahead);
}

void LiveScene::carry_out(std::unique_ptr<Command> command) {
  if (live_) return inbox_.post(command.release());
  command->execute(scene_);
}

BodyRecord* LiveScene::find(BodyId id) {
  return ids_.alive(id) ? records_[slot_of(id)].get() : nullptr;
}

const Contacts& LiveScene::newest_contacts() {
  if (!live_) return scene_.contacts();
  parts_->outcomes.fetch();
  return parts_->outcomes.front();
}

LiveCounts LiveScene::counts() {
  const std::lock_guard lock(mutex_);
  if (!parts_) return {};
  return {parts_->waiting_ticks.value(), parts_->cut_ticks.value(), parts_->global.preparations(),
          parts_->global.searches()};
}

std::uint64_t LiveScene::result_age() {
  const std::lock_guard lock(mutex_);
  return newest_contacts().work.coherence.age;
}

}  // namespace palpate

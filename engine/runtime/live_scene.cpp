#include "engine/runtime/live_scene.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "engine/math/finite.h"
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

template <class Change>
std::unique_ptr<Command> change_of(Change change) {
  return std::make_unique<ChangeScene<Change>>(change);
}

BodyKind kind_of(const NewBody& body) {
  return body.options.kind;
}

Status finished(SceneRecorder& recorder) noexcept {
  try {
    return recorder.finish();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::kOutOfMemory, "out of memory"};  // short: needs none itself
  }
}

void destroy_all(Letter* letter) {
  while (letter) delete std::exchange(letter, letter->next());
}

}  // namespace

LiveScene::LiveScene(const SceneOptions& options) : options_(options), scene_(options) {}

LiveScene::~LiveScene() {
  go_still();
  if (!recording_) return;
  if (recorder_) recorder_->leave(scene_);
  static_cast<void>(finished(*recording_));
}

Result<BodyId> LiveScene::add(BodyOptions options) {
  std::vector<NewBody> one;
  one.push_back({std::move(options), {}});
  Result<std::vector<BodyId>> added = add_all(std::move(one), 0.0);
  if (!added) return added.error();
  return added.value().front();
}

Result<std::vector<BodyId>> LiveScene::add_all(std::vector<NewBody> bodies, double cutoff) {
  const std::lock_guard lock(mutex_);
  const auto tools = std::ranges::count(bodies, BodyKind::kTool, kind_of);
  if (tools > 0 && tool_ != 0) return Error{ErrorCode::kInvalidArgument, "the scene has a tool already"};
  if (tools > 1) return Error{ErrorCode::kInvalidArgument, "more than one body is the tool"};
  std::vector<BodyId> ids;
  try {
    if (!take_ids(bodies.size(), ids)) return Error{ErrorCode::kLimit, "the scene is full"};
    Arrivals arrivals = arrivals_of(ids, std::move(bodies), cutoff);
    admit(std::move(arrivals));
  } catch (...) {
    give_back(ids);
    throw;
  }
  if (cutoff > 0.0) options_.cutoff = cutoff;
  return ids;
}

bool LiveScene::take_ids(std::size_t count, std::vector<BodyId>& ids) {
  ids.reserve(count);
  while (ids.size() < count) {
    const BodyId id = ids_.take();
    if (id == 0) {
      give_back(ids);
      return false;
    }
    ids.push_back(id);
  }
  return true;
}

void LiveScene::give_back(const std::vector<BodyId>& ids) {
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) ids_.give_back_unused(*id);
}

// All memory that the bodies need, so that admit() cannot fail half-way.
LiveScene::Arrivals LiveScene::arrivals_of(const std::vector<BodyId>& ids, std::vector<NewBody> bodies,
                                           double cutoff) {
  std::uint32_t last = 0;
  for (const BodyId id : ids) last = std::max(last, slot_of(id));
  if (last >= records_.size()) records_.resize(last + 1);
  BodyTable::Slots slots = slots_for(last);
  Arrivals arrivals;
  arrivals.slot_room = slots.capacity();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    NewBody& body = bodies[i];
    auto record = std::make_unique<BodyRecord>(ids[i]);
    record->pose = body.options.pose;
    record->options = body.options;
    record->node = std::move(body.node);
    if (recording_) arrivals.traced.push_back(trace_of(ids[i], body.options));
    if (record->node.above != 0) record->node.above = ids[record->node.above - 1];
    arrivals.records.push_back(std::move(record));
    auto placed = std::make_unique<Body>(std::move(body.options));
    placed->id = ids[i];
    arrivals.commands.push_back(
        std::make_unique<AddBody>(std::move(placed), std::exchange(slots, BodyTable::Slots())));
  }
  if (cutoff > 0.0)
    arrivals.commands.push_back(change_of([cutoff](Scene& scene) { scene.set_cutoff(cutoff); }));
  return arrivals;
}

// Cannot fail: the first command brings room for all, and what a recording has no memory for is told at its
// end.
void LiveScene::admit(Arrivals arrivals) noexcept {
  for (const TraceBody& body : arrivals.traced) recording_->add(body);
  slot_room_ = std::max(slot_room_, arrivals.slot_room);
  for (std::unique_ptr<Command>& command : arrivals.commands) carry_out(std::move(command));
  for (std::unique_ptr<BodyRecord>& record : arrivals.records) {
    if (record->options.kind == BodyKind::kTool) tool_ = record->id;
    records_[slot_of(record->id)] = std::move(record);
  }
}

// Room in the scene's table, brought from outside: a servo may not allocate it.
BodyTable::Slots LiveScene::slots_for(std::uint32_t slot) const {
  BodyTable::Slots slots;
  if (slot >= slot_room_) slots.reserve(2 * std::size_t{slot} + 1);
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
  return pose_now(*record);
}

Pose LiveScene::pose_now(const BodyRecord& record) {
  const bool in_hand = record.in_hand || (record.id == tool_ && device_);
  return in_hand ? pose_in_hand(record) : record.pose;
}

std::vector<BodyId> LiveScene::bodies() {
  const std::lock_guard lock(mutex_);
  std::vector<BodyId> ids;
  for (const auto& record : records_) {
    if (record && ids_.alive(record->id)) ids.push_back(record->id);
  }
  return ids;
}

BodyId LiveScene::find_named(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find_if(records_, [&](const auto& record) {
    return record && ids_.alive(record->id) && record->node.name == name;
  });
  return found == records_.end() ? 0 : (*found)->id;
}

std::optional<NewBody> LiveScene::as_added(BodyId id) {
  const std::lock_guard lock(mutex_);
  const BodyRecord* const record = find(id);
  if (!record) return std::nullopt;
  return NewBody{record->options, record->node};
}

Result<DMat4> LiveScene::parent_from_node(BodyId id) {
  const std::lock_guard lock(mutex_);
  const BodyRecord* const record = find(id);
  if (!record) return Error{ErrorCode::kInvalidHandle, "body is none of this scene"};
  const BodyNode& node = record->node;
  if (node.index < 0) return Error{ErrorCode::kInvalidArgument, "the body comes from no file"};
  DMat4 scene_from_parent = node.above_from_parent;
  if (node.above != 0) {
    const BodyRecord* const above = find(node.above);
    if (!above) return Error{ErrorCode::kWrongState, "the body above in the file's hierarchy was removed"};
    scene_from_parent = matrix_of(pose_now(*above)) * scene_from_parent;
  }
  const DMat4 parent_from_node =
      glm::inverse(scene_from_parent) * matrix_of(pose_now(*record)) * node.body_from_node;
  if (!is_finite(parent_from_node))
    return Error{ErrorCode::kWrongState, "the node's parent crushes all that is below it"};
  return parent_from_node;
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
  carry_out(change_of(change));
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
  const auto done = std::make_shared<Bell>();
  std::unique_ptr<Command> command = change_of([this, device, mapping, done](Scene&) mutable {
    device = loop_.exchange(std::move(device), mapping);
    done->ring();
  });
  {
    const std::lock_guard lock(mutex_);
    if (device && device != device_ && !device->claim())
      return Error{ErrorCode::kWrongState, "another scene has the device; take it from there first"};
    if (BodyRecord* const tool = find(tool_)) tool->in_hand = true;
    device_ = std::move(device);
    carry_out(std::move(command));
  }
  done->wait(kLongestWait);
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
    if (record) recorder.value()->add(trace_of(record->id, record->options));
  Attachment attachment = attachment_of(recorder.value());
  Attachment detachment = attachment_of(nullptr);
  if (Status begun = recorder.value()->begin(); !begun) return begun;
  carry_out(std::move(attachment.command));
  recording_ = std::move(recorder.value());
  detachment_ = std::move(detachment);
  return Done{};
}

Status LiveScene::stop_recording(Recording& outcome) {
  std::shared_ptr<Bell> done;
  std::shared_ptr<SceneRecorder> ended;
  {
    const std::lock_guard lock(mutex_);
    if (!recording_) return Error{ErrorCode::kWrongState, "the scene is not recorded"};
    done = std::move(detachment_.done);
    carry_out(std::move(detachment_.command));
    ended = std::move(recording_);
  }
  done->wait(kLongestWait);
  Status status = finished(*ended);
  outcome = ended->state();
  return status;
}

// The servo takes it up, or lets it go, between two ticks, and then rings.
LiveScene::Attachment LiveScene::attachment_of(std::shared_ptr<SceneRecorder> recorder) {
  const auto done = std::make_shared<Bell>();
  return {change_of([this, recorder, done](Scene& scene) mutable {
            if (recorder_) recorder_->leave(scene);
            if (recorder) recorder->meet(scene);
            recorder_.swap(recorder);
            done->ring();
          }),
          done};
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
    try {
      scene_.fix();
    } catch (...) {
      scene_.unfix();
      throw;
    }
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
  survey_.tool_model = tool->options.model;
  survey_.tool_pose = view.pose;
  survey_.step = view.step;
  const Sphere around = view.pose * Sphere{tool->options.model->centre(), tool->options.model->radius()};
  for (const auto& record : records_)
    if (record && record->id != tool_ && !record->options.intangible && soon_near(*record, around, view))
      survey_.near.push_back({record->id, record->options.model, record->pose});
}

bool LiveScene::soon_near(BodyRecord& record, const Sphere& tool, const ToolView& view) const {
  const Sphere body = record.pose * Sphere{record.options.model->centre(), record.options.model->radius()};
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

#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/device/servo_task.h"
#include "engine/exchange/bell.h"
#include "engine/exchange/counter.h"
#include "engine/exchange/mailbox.h"
#include "engine/exchange/triple_slot.h"
#include "engine/runtime/body_record.h"
#include "engine/runtime/command.h"
#include "engine/runtime/global_search.h"
#include "engine/runtime/haptic_loop.h"
#include "engine/runtime/scene_recorder.h"
#include "engine/runtime/servo_state.h"
#include "engine/runtime/survey.h"

namespace palpate {

// A scene that any threads may change and look at. It is stepped either by them, or, while it is live, by one
// thread alone that waits for nobody: changes reach it through a mailbox, outcomes leave it through a triple
// slot, and what it frees is destroyed elsewhere. Nothing but tick() is then the servo's.
class LiveScene : public ServoTask {
 public:
  explicit LiveScene(const SceneOptions& options);
  ~LiveScene() override;

  // From any thread.
  Result<BodyId> add(BodyOptions options);  // errors: kInvalidArgument (a second tool), kLimit
  // All of them or, on an error, none, and the cutoff, unless it is 0. Errors as of add().
  Result<std::vector<BodyId>> add_all(std::vector<NewBody> bodies, double cutoff);
  bool remove(BodyId id);  // false: no such body, as the next two
  bool set_pose(BodyId id, const Pose& pose);
  std::optional<Pose> pose_of(BodyId id);
  std::vector<BodyId> bodies();                // in the order of slots: that of adding, while none is removed
  BodyId find_named(const std::string& name);  // the first of that name; 0: none
  std::optional<NewBody> as_added(BodyId id);
  // The node's transform in its parent that puts it where the body is. Errors: kInvalidHandle,
  // kInvalidArgument (the body has no node), kWrongState (the body above was removed; the parent has no
  // inverse).
  Result<DMat4> parent_from_node(BodyId id);
  void set_cutoff(double cutoff);
  void set_stiffness(double stiffness);
  void set_damping(double damping);
  void set_stiffness_cap(double cap);
  void set_friction(double friction);
  void set_law(ForceLaw law);
  void set_mode(SearchMode mode);

  // As Scene's; only while it is not live.
  void set_executor(Executor* executor) { scene_.set_executor(executor); }

  // Gives the tool to a device, whose hand feels it from then on; null takes it away. When it returns, the
  // device before may be given to anybody, unless a servo takes longer than 0.1 s for a tick. Errors:
  // kWrongState (another scene has the device).
  Status set_device(std::shared_ptr<GuardedDevice> device, const DeviceMapping& mapping);
  std::shared_ptr<GuardedDevice> device();

  // Errors: kWrongState (it is live). If it throws, the outcome is what it was.
  Status step();

  // From now on every tick goes into a trace in `path`, which says that the caller's space is `space`.
  // Errors: kWrongState (it is recorded already), kLimit (no more threads), kFileNotFound, kFileWrite.
  Status record(const std::string& path, const TraceSpace& space);
  // Ends the trace and fills `outcome`, with an error, too. Errors: kWrongState (it is not recorded),
  // kFileWrite, kOutOfMemory: the first that there was since the beginning.
  Status stop_recording(Recording& outcome);
  Recording recording();  // so far

  // Calls visit(contacts) with the newest outcome, if it is newer than that of the last call.
  template <class Visit>
  void visit_newer(Visit&& visit) {
    const std::lock_guard lock(mutex_);
    const Contacts& contacts = newest_contacts();
    if (contacts.step <= visited_step_) return;
    visit(contacts);
    visited_step_ = contacts.step;
  }

  // Errors: kWrongState (it is live). From now on one thread calls tick() and another search_globally(). Near
  // pairs are ready when it returns.
  Status go_live();
  void go_still();  // both have come to rest: what was sent is carried out

  void tick(double dt) noexcept override;
  bool search_globally();  // one round; false: nothing was to be done

  LiveCounts counts();
  std::uint64_t result_age();

 private:
  struct ToolView {
    BodyId tool = 0;
    Pose pose;
    std::uint64_t step = 0;
    double dt = 0.0;  // seconds a step
  };
  // Of the live time.
  struct Live {
    explicit Live(Mailbox& to_servo) : global(to_servo) {
      for (Contacts& outcome : outcomes.buffers()) outcome.fix(kMostListed);
    }

    GlobalSearch global;
    TripleSlot<Contacts> outcomes;
    TripleSlot<ToolView> tool_views;   // for the global search
    TripleSlot<ToolView> tool_places;  // for pose_of()
    Counter waiting_ticks;
    Counter cut_ticks;
  };

  void carry_out(std::unique_ptr<Command> command);
  template <class Change>
  void change(Change change);
  // Bodies on their way into the scene.
  struct Arrivals {
    std::vector<std::unique_ptr<BodyRecord>> records;
    std::vector<std::unique_ptr<Command>> commands;
    std::vector<TraceBody> traced;
    std::size_t slot_room = 0;  // of the table that they bring; 0: none
  };

  bool take_ids(std::size_t count, std::vector<BodyId>& ids);  // false: there are not so many, none is taken
  void give_back(const std::vector<BodyId>& ids);
  Arrivals arrivals_of(const std::vector<BodyId>& ids, std::vector<NewBody> bodies, double cutoff);
  void admit(Arrivals arrivals) noexcept;
  Pose pose_now(const BodyRecord& record);
  BodyTable::Slots slots_for(std::uint32_t slot) const;
  BodyRecord* find(BodyId id);
  Pose pose_in_hand(const BodyRecord& tool);
  const Contacts& newest_contacts();
  void execute_commands(std::size_t most);
  void publish(double dt);
  void publish_tool(double dt);
  void destroy_returned();
  // A recorder on its way to the thread that steps, which rings when it has it.
  struct Attachment {
    std::unique_ptr<Command> command;
    std::shared_ptr<Bell> done;
  };
  Attachment attachment_of(std::shared_ptr<SceneRecorder> recorder);
  void take_survey();
  bool soon_near(BodyRecord& record, const Sphere& tool, const ToolView& view) const;

  std::mutex mutex_;  // guards what follows, and that one thread at a time posts and reads
  bool live_ = false;
  SceneOptions options_;
  BodyIds ids_;
  std::vector<std::unique_ptr<BodyRecord>> records_;  // by slot
  BodyId tool_ = 0;
  std::shared_ptr<GuardedDevice> device_;
  std::size_t slot_room_ = 0;  // of the scene's table
  std::uint64_t visited_step_ = 0;
  std::shared_ptr<SceneRecorder> recording_;  // null: none
  Attachment detachment_;                     // that ends it, made when it began

  // The servo's while live, otherwise guarded, too.
  Scene scene_;
  HapticLoop loop_{scene_};
  Letter* pending_ = nullptr;
  std::shared_ptr<SceneRecorder> recorder_;  // recording_, as soon as it is known here

  Mailbox inbox_;              // commands to the servo
  Mailbox returned_;           // commands that are done
  std::optional<Live> parts_;  // of the last time, too
  Survey survey_;              // the global search's
};

}  // namespace palpate

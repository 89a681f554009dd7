#include "tests/soak/soak.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "palpate/palpate.h"
#include "tests/support/models.h"
#include "tests/support/motion.h"

namespace palpate::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kCutoff = 0.02;  // of the scene's diagonal
constexpr double kSpeed = 0.2;    // diagonals a second
constexpr int kWarmRounds = 2;
constexpr std::chrono::seconds kReportEvery{10};

void check(plp_result result) {
  if (result < 0) throw std::runtime_error(plp_last_error());
}

std::int64_t resident_bytes() {
  long pages = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%*d %ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * ::sysconf(_SC_PAGESIZE);
}

plp_pose pose_of(const Pose& pose) {
  const DVec3& at = pose.translation;
  const auto& turn = pose.rotation;
  const glm::dquat q = glm::quat_cast(DMat3(turn));
  return {{at.x, at.y, at.z}, {q.x, q.y, q.z, q.w}};
}

// A model for the C interface, and a way over it.
class HeldModel {
 public:
  explicit HeldModel(const Model& model) {
    const Mesh& mesh = model.mesh();
    std::vector<double> positions;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
      const DVec3 at = mesh.frame.metres(mesh.position(i));
      positions.insert(positions.end(), {at.x, at.y, at.z});
    }
    plp_triangles triangles;
    plp_triangles_init(&triangles, sizeof triangles);
    triangles.positions = positions.data();
    triangles.position_type = PLP_TYPE_FLOAT64;
    triangles.vertex_count = mesh.positions.size();
    triangles.indices = mesh.triangles.data();
    triangles.triangle_count = mesh.triangles.size();
    check(plp_model_create_from_triangles(&triangles, nullptr, &handle_));
  }
  ~HeldModel() { plp_model_release(handle_); }
  HeldModel(const HeldModel&) = delete;
  HeldModel& operator=(const HeldModel&) = delete;

  plp_model handle() const { return handle_; }

 private:
  plp_model handle_ = nullptr;
};

struct Track {
  Track(const SoakPair& pair, int poses, Random& random) : name(std::string(pair.scene) + "–" + pair.tool) {
    const auto a = asset_model(pair.scene), b = asset_model(pair.tool, pair.tool_scale);
    cutoff = kCutoff * a->bounds().diagonal();
    for (const Pose& pose : sliding_motion(*a, *b, cutoff, kSpeed * a->bounds().diagonal(), poses, random))
      way.push_back(pose_of(pose));
    for (std::size_t i = way.size(); i-- > 0;) way.push_back(way[i]);
    scene = std::make_unique<HeldModel>(*a);
    tool = std::make_unique<HeldModel>(*b);
  }

  std::string name;
  double cutoff = 0.0;
  std::vector<plp_pose> way;  // to and fro
  std::unique_ptr<HeldModel> scene;
  std::unique_ptr<HeldModel> tool;
};

// A scene that goes its way again and again.
class Walker {
 public:
  Walker(const Track& track, plp_mode mode, plp_law law) : track_(track), mode_(mode), law_(law) {
    plp_scene_options options;
    plp_scene_options_init(&options, sizeof options);
    options.cutoff = track.cutoff;
    options.mode = mode;
    options.law = law;
    options.fade_time = 0.0;
    check(plp_scene_create(&options, &scene_));
    add(track.scene->handle(), PLP_BODY_STATIC);
    tool_ = add(track.tool->handle(), PLP_BODY_TOOL);
  }
  ~Walker() { plp_scene_release(scene_); }
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;

  void go_round(std::atomic<std::uint64_t>& ticks, std::atomic<std::uint64_t>& touching) {
    const auto start = Clock::now();
    for (const plp_pose& pose : track_.way) {
      check(plp_scene_set_pose(scene_, tool_, &pose));
      check(plp_scene_step(scene_));
      touching += contacts().lmd_count > 0;
      ++ticks;
    }
    spent_ += Clock::now() - start;
    ++rounds_;
  }

  int rounds() const { return rounds_; }
  Clock::duration spent() const { return spent_; }

  // Where it stands, as bytes. What descent has found depends on where it began; so it is asked for the whole
  // set.
  std::string found() {
    if (mode_ == PLP_MODE_DESCENT) {
      check(plp_scene_set_mode(scene_, PLP_MODE_CERTIFIED));
      check(plp_scene_step(scene_));
      check(plp_scene_set_mode(scene_, PLP_MODE_DESCENT));
    }
    const plp_contacts now = contacts();
    std::string bytes;
    const auto add = [&](const void* data, std::size_t size) {
      bytes.append(static_cast<const char*>(data), size);
    };
    add(&now.wrench, sizeof now.wrench);
    add(&now.min_distance, sizeof now.min_distance);
    for (std::size_t i = 0; i < now.lmd_count; ++i) add(&now.lmds[i], sizeof now.lmds[i]);
    return bytes;
  }

  std::unique_ptr<Walker> afresh() const { return std::make_unique<Walker>(track_, mode_, law_); }

  std::string name() const {
    constexpr const char* kModes[] = {"global", "descent", "certified"};
    constexpr const char* kLaws[] = {"springs", "smooth"};
    return track_.name + ", " + kModes[mode_] + ", " + kLaws[law_];
  }

 private:
  plp_body add(plp_model model, plp_body_kind kind) {
    plp_body_options options;
    plp_body_options_init(&options, sizeof options);
    options.model = model;
    options.kind = kind;
    plp_body body = 0;
    check(plp_scene_add_body(scene_, &options, &body));
    return body;
  }

  plp_contacts contacts() {
    plp_contacts contacts;
    plp_contacts_init(&contacts, sizeof contacts);
    check(plp_scene_get_contacts(scene_, &contacts));
    return contacts;
  }

  const Track& track_;
  const plp_mode mode_;
  const plp_law law_;
  plp_scene scene_ = nullptr;
  plp_body tool_ = 0;
  int rounds_ = 0;
  Clock::duration spent_{};
};

using Walkers = std::vector<Walker*>;

class Soak {
 public:
  Soak(const SoakOptions& options, const std::function<void(const SoakProgress&)>& report)
      : options_(options), report_(report) {
    Random random(options.seed);
    for (const SoakPair& pair : options.pairs)
      tracks_.push_back(std::make_unique<Track>(pair, options.poses, random));
    for (const auto& track : tracks_)
      for (const plp_mode mode : {PLP_MODE_GLOBAL, PLP_MODE_DESCENT, PLP_MODE_CERTIFIED})
        for (const plp_law law : {PLP_LAW_SPRINGS, PLP_LAW_SMOOTH})
          walkers_.push_back(std::make_unique<Walker>(*track, mode, law));
  }

  SoakOutcome run() {
    SoakOutcome outcome;
    walk([](const Walkers& walkers) {
      const auto next =
          std::ranges::find_if(walkers, [](const Walker* w) { return w->rounds() < kWarmRounds; });
      return next == walkers.end() ? nullptr : *next;
    });
    outcome.warm = progress();
    // In equal shares of the time, so that many ticks are those of the fast.
    const auto end = start_ + std::chrono::duration<double>(options_.seconds);
    walk([end](const Walkers& walkers) {
      return Clock::now() < end ? *std::ranges::min_element(walkers, {}, &Walker::spent) : nullptr;
    });
    outcome.end = progress();
    outcome.most_resident_bytes = std::max(most_resident_, outcome.end.resident_bytes);
    outcome.touching_ticks = touching_;
    report_(outcome.end);
    compare(outcome.wrong);
    return outcome;
  }

 private:
  SoakProgress progress() const {
    const std::chrono::duration<double> passed = Clock::now() - start_;
    return {passed.count(), ticks_, resident_bytes()};
  }

  // Every thread has walkers of its own, of whom `next` names the one that goes round; null: none any more.
  template <class Next>
  void walk(Next next) {
    std::vector<std::thread> threads;
    at_work_ = options_.threads;
    for (unsigned t = 0; t < options_.threads; ++t)
      threads.emplace_back([this, t, next] {
        Walkers own;
        for (std::size_t i = t; i < walkers_.size(); i += options_.threads) own.push_back(walkers_[i].get());
        while (Walker* const walker = own.empty() ? nullptr : next(own)) walker->go_round(ticks_, touching_);
        const std::lock_guard lock(mutex_);
        if (--at_work_ == 0) done_.notify_all();
      });
    report_till_done();
    for (std::thread& thread : threads) thread.join();
  }

  void report_till_done() {
    std::unique_lock lock(mutex_);
    while (!done_.wait_for(lock, kReportEvery, [this] { return at_work_ == 0; })) {
      const SoakProgress now = progress();
      most_resident_ = std::max(most_resident_, now.resident_bytes);
      report_(now);
    }
  }

  void compare(std::vector<std::string>& wrong) {
    std::atomic<std::uint64_t> ignored = 0;
    for (const auto& walker : walkers_) {
      const auto fresh = walker->afresh();
      fresh->go_round(ignored, ignored);
      if (fresh->found() != walker->found()) wrong.push_back(walker->name());
    }
  }

  const SoakOptions& options_;
  const std::function<void(const SoakProgress&)>& report_;
  const Clock::time_point start_ = Clock::now();
  std::vector<std::unique_ptr<Track>> tracks_;
  std::vector<std::unique_ptr<Walker>> walkers_;
  std::atomic<std::uint64_t> ticks_ = 0;
  std::atomic<std::uint64_t> touching_ = 0;

  std::mutex mutex_;
  std::condition_variable done_;
  unsigned at_work_ = 0;
  std::int64_t most_resident_ = 0;
};

}  // namespace

SoakOutcome soak(const SoakOptions& options, const std::function<void(const SoakProgress&)>& report) {
  return Soak(options, report).run();
}

}  // namespace palpate::test

// The same inputs give the same bits: whatever the number of threads, the build and the instruction set.
// Shapes and motion are made with + − × ÷ and square roots alone, which every machine rounds alike.
#include <hwy/targets.h>

#include <bit>
#include <cstdio>
#include <memory>
#include <thread>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

constexpr int kSteps = 240;
constexpr int kBodies = 7;

// A cube blown up to a ball with bumps.
Shape bumpy_ball(float radius, int cuts) {
  Shape shape;
  const auto corner = [&](int face, int i, int j) -> std::uint32_t {
    const double u = 2.0 * i / cuts - 1.0, v = 2.0 * j / cuts - 1.0, side = face % 2 ? 1.0 : -1.0;
    double x[3];
    x[face / 2] = side;
    x[(face / 2 + 1) % 3] = side * u;
    x[(face / 2 + 2) % 3] = v;
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (double& component : x) component /= length;
    const double bumps = 1.0 + 0.6 * x[0] * x[1] * (1.0 - x[2] * x[2]) + 0.3 * x[2] * x[0] * x[0];
    std::array<float, 3> position;
    for (int k = 0; k < 3; ++k) position[k] = static_cast<float>(radius * bumps * x[k]);
    shape.positions.push_back(position);
    return static_cast<std::uint32_t>(shape.positions.size() - 1);
  };
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < cuts; ++i) {
      for (int j = 0; j < cuts; ++j) {
        const std::uint32_t a = corner(face, i, j), b = corner(face, i + 1, j),
                            c = corner(face, i + 1, j + 1), d = corner(face, i, j + 1);
        shape.triangles.push_back({a, b, c});
        shape.triangles.push_back({a, c, d});
      }
    }
  }
  return shape;
}

// FNV-1a over the bytes of what has no padding.
class Hash {
 public:
  template <class T>
  void add(const T& value) {
    const auto bytes = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3u;
  }
  void add_contacts(const plp_contacts& contacts) {
    add(contacts.wrench);
    add(contacts.status);
    add(contacts.overlap);
    add(static_cast<std::uint64_t>(contacts.set_count));
    for (std::size_t i = 0; i < contacts.lmd_count; ++i) add(contacts.lmds[i]);
    for (std::size_t i = 0; i < contacts.spring_count; ++i) add(contacts.springs[i]);
    for (std::size_t i = 0; i < contacts.overlap_count; ++i) add(contacts.overlaps[i]);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

// Back and forth between -1 and 1 with a period of `period` steps, in parabolas.
double swing(int step, int period) {
  const double phase = static_cast<double>(step % period) / period;  // 0 to 1
  const double half = phase < 0.5 ? 4.0 * phase - 1.0 : 3.0 - 4.0 * phase;
  return half * (1.5 - 0.5 * half * half);
}

// What is replayed.
enum class Course {
  kRoll,   // a bumpy ball turns over balls and tilted boxes
  kFlush,  // a box slides and rocks on a plate between upright boxes: plateaus of faces and of edges
};

// How a replay is searched.
struct Manner {
  plp_mode mode;
  std::uint32_t tick_budget;
  plp_law law = PLP_LAW_SPRINGS;
  Course course = Course::kRoll;
};

struct Models {
  TestModel ball{bumpy_ball(0.5f, 10)};
  TestModel box{test::box(0.45f, 0.5f, 0.4f)};
  TestModel plate{test::box(2.0f, 2.0f, 0.1f)};
};

plp_pose rolling(int step) {
  return {{0.9 * swing(step, 160), 0.8 * swing(step, 114), 0.3 + 0.2 * swing(step, 60)},
          {0.4 * swing(step, 90), 0.3, 0.5 * swing(step, 140), 1.0}};
}

// Flat on the plate half of the time, above it or pressed in.
plp_pose flush(int step) {
  const double rock = swing(step, 120) > 0.0 ? 0.02 * swing(step, 120) : 0.0;
  return {{0.15 * swing(step, 114), 0.3 * swing(step, 96), 0.02 + 0.16 * swing(step, 80)},
          {rock, 0.0, 0.0, 1.0}};
}

// Several bodies, one of which moves, and a tool among them. The models must outlive it.
class Replay {
 public:
  Replay(const Models& models, Manner manner, std::uint32_t threads)
      : course_(manner.course), scene_(options_of(manner, threads)) {
    course_ == Course::kRoll ? place_tilted(models) : place_upright(models);
  }

  std::uint64_t hash() {
    Hash hash;
    for (int step = 0; step < kSteps; ++step) {
      const plp_pose tool = course_ == Course::kRoll ? rolling(step) : flush(step);
      EXPECT_EQ(plp_scene_set_pose(scene_.handle, tool_, &tool), PLP_OK);
      const double aside = 0.1 * swing(step, 50);
      const plp_pose moved = course_ == Course::kRoll
                                 ? plp_pose{{-1.05 + aside, -1.05, -0.9}, {0.0, 0.2, 0.0, 1.0}}
                                 : at(-1.2 + aside, 0.0, 0.0);
      EXPECT_EQ(plp_scene_set_pose(scene_.handle, moving_, &moved), PLP_OK);
      const plp_contacts contacts = scene_.step();
      hash.add_contacts(contacts);
      most_pairs = std::max(most_pairs, contacts.work.body_pairs);
      lmds += contacts.lmd_count;
      overlaps += contacts.overlap_count;
      by_descent += (contacts.status & PLP_STATUS_BY_DESCENT) != 0;
      plateaus += contacts.lmd_count > contacts.set_count;
      walls += (contacts.status & PLP_STATUS_WALL) != 0;
    }
    return hash.value();
  }

  std::uint64_t most_pairs = 0, lmds = 0, overlaps = 0;
  std::uint64_t by_descent = 0, plateaus = 0, walls = 0;  // steps that have some

 private:
  static plp_scene_options options_of(Manner manner, std::uint32_t threads) {
    plp_scene_options options = TestScene::options_with(0.3);
    options.mode = manner.mode;
    options.threads = threads;
    options.tick_budget = manner.tick_budget;
    options.law = manner.law;
    return options;
  }

  void place_tilted(const Models& models) {
    for (int i = 0; i < kBodies; ++i) {
      const plp_body body = scene_.add(
          i % 2 ? models.ball.handle : models.box.handle, i == 0 ? PLP_BODY_MOVING : PLP_BODY_STATIC,
          {{1.05 * (i % 3) - 1.05, 1.05 * (i / 3) - 1.05, -0.9}, {0.1 * i, 0.2, 0.05 * i, 1.0}});
      if (i == 0) moving_ = body;
    }
    tool_ = scene_.add(models.ball.handle, PLP_BODY_TOOL, at(0, 0, 0));
  }

  void place_upright(const Models& models) {
    moving_ = scene_.add(models.box.handle, PLP_BODY_MOVING, at(-1.2, 0.0, 0.0));
    scene_.add(models.box.handle, PLP_BODY_STATIC, at(1.2, 0.0, 0.0));
    scene_.add(models.plate.handle, PLP_BODY_STATIC, at(0.0, 0.0, -0.6));
    tool_ = scene_.add(models.box.handle, PLP_BODY_TOOL, at(0, 0, 1));
  }

  Course course_;
  TestScene scene_;
  plp_body moving_ = 0;
  plp_body tool_ = 0;
};

struct Golden {
  const char* name;
  Manner manner;
  std::uint64_t hash;
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

class GoldenTest : public testing::TestWithParam<Golden> {};

TEST_P(GoldenTest, IsTheSameForEveryNumberOfThreads) {
  const Models models;
  for (const std::uint32_t threads : {0u, 1u, 2u, 4u}) {
    Replay replay(models, GetParam().manner, threads);
    const std::uint64_t hash = replay.hash();
    std::printf(
        "%s, %u threads: %016llx; %llu LMDs, %llu overlaps, up to %llu pairs, %llu steps by descent, %llu "
        "with "
        "plateaus, %llu with walls\n",
        GetParam().name, threads, static_cast<unsigned long long>(hash),
        static_cast<unsigned long long>(replay.lmds), static_cast<unsigned long long>(replay.overlaps),
        static_cast<unsigned long long>(replay.most_pairs),
        static_cast<unsigned long long>(replay.by_descent), static_cast<unsigned long long>(replay.plateaus),
        static_cast<unsigned long long>(replay.walls));
    EXPECT_EQ(hash, GetParam().hash) << std::hex << hash;
    EXPECT_GT(replay.lmds, 200u);
    EXPECT_GT(replay.overlaps, 0u);
    EXPECT_GT(replay.walls, 0u);
    EXPECT_GE(replay.plateaus, GetParam().manner.course == Course::kFlush ? 100u : 0u);
    EXPECT_GE(replay.most_pairs, 3u) << "too few to be shared by threads";
    EXPECT_EQ(replay.by_descent > 0, GetParam().manner.tick_budget > 0);
  }
}

// The models' hierarchies are built by whichever thread first needs them.
TEST_P(GoldenTest, IsTheSameInThreadsThatShareModels) {
  const Models models;
  std::uint64_t hashes[4];
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : hashes)
    threads.emplace_back([&] { hash = Replay(models, GetParam().manner, 1).hash(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, GetParam().hash) << std::hex << hash;
}

TEST_P(GoldenTest, IsTheSameForEveryInstructionSet) {
  const Models models;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    EXPECT_EQ(Replay(models, GetParam().manner, 1).hash(), GetParam().hash) << hwy::TargetName(target);
  }
  hwy::SetSupportedTargetsForTest(0);
}

// Taken with the release build. A change of what is computed changes them; a change of how fast must not.
INSTANTIATE_TEST_SUITE_P(
    Modes, GoldenTest,
    testing::Values(
        Golden{"global", {PLP_MODE_GLOBAL, 0}, 0xfc4085c0a975ada4},
        Golden{"descent", {PLP_MODE_DESCENT, 0}, 0x21f767d801483de4},
        Golden{"certified", {PLP_MODE_CERTIFIED, 0}, 0xfc4085c0a975ada4},
        Golden{"smooth", {PLP_MODE_CERTIFIED, 0, PLP_LAW_SMOOTH}, 0x0e4f1d6c391ce0de},
        Golden{"smooth_global", {PLP_MODE_GLOBAL, 0, PLP_LAW_SMOOTH}, 0x0e4f1d6c391ce0de},
        Golden{"smooth_descent", {PLP_MODE_DESCENT, 0, PLP_LAW_SMOOTH}, 0xe4b0d0554f66803c},
        Golden{"budget", {PLP_MODE_CERTIFIED, 600}, 0xd3da926b89ae21f1},
        Golden{"flush", {PLP_MODE_CERTIFIED, 0, PLP_LAW_SPRINGS, Course::kFlush}, 0xc1947714dd72cd8e},
        Golden{"flush_descent", {PLP_MODE_DESCENT, 0, PLP_LAW_SPRINGS, Course::kFlush}, 0xad7d7742279ccebb},
        Golden{"flush_smooth", {PLP_MODE_CERTIFIED, 0, PLP_LAW_SMOOTH, Course::kFlush}, 0x6b727342668562ef}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace palpate::test

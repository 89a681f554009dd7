// The same inputs give the same bits: whatever the number of threads, the build and the instruction set.
// Shapes and motion are made with + − × ÷ and square roots alone, which every machine rounds alike.
#include <hwy/targets.h>

#include <bit>
#include <cstdio>
#include <memory>

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

// How a replay is searched.
struct Manner {
  plp_mode mode;
  std::uint32_t tick_budget;
  plp_law law = PLP_LAW_SPRINGS;
};

// Several bodies, one of which moves, and a tool among them.
class Replay {
 public:
  Replay(Manner manner, std::uint32_t threads) : scene_(options_of(manner, threads)) {
    for (int i = 0; i < kBodies; ++i)
      bodies_[i] =
          scene_.add(i % 2 ? ball_.handle : box_.handle, i == 0 ? PLP_BODY_MOVING : PLP_BODY_STATIC,
                     {{1.05 * (i % 3) - 1.05, 1.05 * (i / 3) - 1.05, -0.9}, {0.1 * i, 0.2, 0.05 * i, 1.0}});
    tool_ = scene_.add(ball_.handle, PLP_BODY_TOOL, at(0, 0, 0));
  }

  std::uint64_t hash() {
    Hash hash;
    for (int step = 0; step < kSteps; ++step) {
      const plp_pose tool{{0.9 * swing(step, 160), 0.8 * swing(step, 114), 0.3 + 0.2 * swing(step, 60)},
                          {0.4 * swing(step, 90), 0.3, 0.5 * swing(step, 140), 1.0}};
      EXPECT_EQ(plp_scene_set_pose(scene_.handle, tool_, &tool), PLP_OK);
      const plp_pose moved{{-1.05 + 0.1 * swing(step, 50), -1.05, -0.9}, {0.0, 0.2, 0.0, 1.0}};
      EXPECT_EQ(plp_scene_set_pose(scene_.handle, bodies_[0], &moved), PLP_OK);
      const plp_contacts contacts = scene_.step();
      hash.add_contacts(contacts);
      most_pairs = std::max(most_pairs, contacts.work.body_pairs);
      lmds += contacts.lmd_count;
      overlaps += contacts.overlap_count;
      by_descent += (contacts.status & PLP_STATUS_BY_DESCENT) != 0;
    }
    return hash.value();
  }

  std::uint64_t most_pairs = 0, lmds = 0, overlaps = 0, by_descent = 0;

 private:
  static plp_scene_options options_of(Manner manner, std::uint32_t threads) {
    plp_scene_options options = TestScene::options_with(0.3);
    options.mode = manner.mode;
    options.threads = threads;
    options.tick_budget = manner.tick_budget;
    options.law = manner.law;
    return options;
  }

  TestModel ball_{bumpy_ball(0.5f, 10)};
  TestModel box_{box(0.45f, 0.5f, 0.4f)};
  TestScene scene_;
  plp_body bodies_[kBodies];
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
  for (const std::uint32_t threads : {0u, 1u, 2u, 4u}) {
    Replay replay(GetParam().manner, threads);
    const std::uint64_t hash = replay.hash();
    std::printf(
        "%s, %u threads: %016llx; %llu LMDs, %llu overlaps, up to %llu pairs, %llu steps by descent\n",
        GetParam().name, threads, static_cast<unsigned long long>(hash),
        static_cast<unsigned long long>(replay.lmds), static_cast<unsigned long long>(replay.overlaps),
        static_cast<unsigned long long>(replay.most_pairs),
        static_cast<unsigned long long>(replay.by_descent));
    EXPECT_EQ(hash, GetParam().hash) << std::hex << hash;
    EXPECT_GT(replay.lmds, 200u);
    EXPECT_GT(replay.overlaps, 0u);
    EXPECT_GE(replay.most_pairs, 3u) << "too few to be shared by threads";
    EXPECT_EQ(replay.by_descent > 0, GetParam().manner.tick_budget > 0);
  }
}

TEST_P(GoldenTest, IsTheSameForEveryInstructionSet) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    EXPECT_EQ(Replay(GetParam().manner, 1).hash(), GetParam().hash) << hwy::TargetName(target);
  }
  hwy::SetSupportedTargetsForTest(0);
}

// Taken with the release build. A change of what is computed changes them; a change of how fast must not.
INSTANTIATE_TEST_SUITE_P(
    Modes, GoldenTest,
    testing::Values(Golden{"global", {PLP_MODE_GLOBAL, 0}, 0xfc4085c0a975ada4},
                    Golden{"descent", {PLP_MODE_DESCENT, 0}, 0xccc04b336aaa53f0},
                    Golden{"certified", {PLP_MODE_CERTIFIED, 0}, 0xfc4085c0a975ada4},
                    Golden{"smooth", {PLP_MODE_CERTIFIED, 0, PLP_LAW_SMOOTH}, 0x0e4f1d6c391ce0de},
                    Golden{"smooth_global", {PLP_MODE_GLOBAL, 0, PLP_LAW_SMOOTH}, 0x0e4f1d6c391ce0de},
                    Golden{"smooth_descent", {PLP_MODE_DESCENT, 0, PLP_LAW_SMOOTH}, 0x6a81cec487225dde},
                    Golden{"budget", {PLP_MODE_CERTIFIED, 600}, 0x7f8c335b27403499}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace palpate::test

// A trace that is replayed gives the same bits, and so the same trace.
#include <cstdio>

#include "tests/trace/traces.h"

namespace palpate::test {
namespace {

constexpr int kSteps = 150;

struct Manner {
  plp_mode mode;
  plp_law law;
  bool in_unity_centimetres = false;
};

std::string name_of(const testing::TestParamInfo<Manner>& info) {
  const char* modes[] = {"Global", "Descent", "Certified"};
  return std::string(modes[info.param.mode]) + (info.param.law == PLP_LAW_SMOOTH ? "Smooth" : "Springs") +
         (info.param.in_unity_centimetres ? "InAnotherSpace" : "");
}

class Replay : public testing::TestWithParam<Manner> {
 protected:
  double unit() const { return GetParam().in_unity_centimetres ? 0.01 : 1.0; }

  plp_scene_options options() const {
    plp_scene_options options = TestScene::options_with(0.31 / unit());
    options.mode = GetParam().mode;
    options.law = GetParam().law;
    options.global_every = 7;
    options.damping = 3.0;
    options.friction = 0.3;
    options.stiffness_cap = 2500.0;
    options.time_step = 0.002;
    if (GetParam().in_unity_centimetres) options.space = {{-1, 2, 3}, 0, unit()};
    return options;
  }

  TestModel ring_{torus(1.0, 0.35, 24, 12)};
  TestModel box_{box(0.2f, 0.2f, 0.2f)};
};

// What a scene gave, step by step.
struct Told {
  std::vector<std::string> bits;
  std::size_t lmds = 0, overlaps = 0, walls = 0;

  void add(const plp_contacts& contacts) {
    bits.push_back(bits_of(contacts));
    lmds += contacts.lmd_count;
    overlaps += contacts.overlap;
    walls += (contacts.status & PLP_STATUS_WALL) != 0;
  }
};

// The tool and two bodies, one of which moves now and then, are recorded and replayed twice.
TEST_P(Replay, GivesTheSameBits) {
  const std::uint32_t seed = 11;
  std::printf("seed %u\n", seed);
  TraceFile first, second;
  Told told;
  {
    TestScene scene(options());
    plp_pose moving_at = at(0.0, 0.0, -0.9 / unit());
    const plp_body ring = scene.add(ring_.handle, PLP_BODY_STATIC, at(0, 0, 0));
    const plp_body moving = scene.add(box_.handle, PLP_BODY_MOVING, moving_at);
    plp_body_options tool_options;
    plp_body_options_init(&tool_options, sizeof tool_options);
    tool_options.model = box_.handle;
    tool_options.kind = PLP_BODY_TOOL;
    tool_options.reference_point[1] = 0.07 / unit();
    plp_body tool = 0;
    ASSERT_EQ(plp_scene_add_body(scene.handle, &tool_options, &tool), PLP_OK);
    ASSERT_EQ(plp_scene_record(scene.handle, first.path()), PLP_OK) << plp_last_error();
    Wander wander(0.4 / unit(), seed);
    for (int i = 0; i < kSteps; ++i) {
      const plp_pose pose = wander.next();
      ASSERT_EQ(plp_scene_set_pose(scene.handle, tool, &pose), PLP_OK);
      if (i % 20 == 10) {
        moving_at.position[0] += 0.1 / unit();
        ASSERT_EQ(plp_scene_set_pose(scene.handle, moving, &moving_at), PLP_OK);
      }
      told.add(scene.step());
    }
    const plp_recording recording = stop_recording(scene.handle);
    EXPECT_EQ(recording.ticks, std::uint64_t{kSteps});
    EXPECT_EQ(recording.lost, 0u);
    EXPECT_EQ(recording.bytes, first.bytes().size());
    static_cast<void>(ring);
  }
  EXPECT_GT(told.lmds, std::size_t{kSteps} / 2);

  const TestTrace trace(first);
  ASSERT_EQ(trace.info().ticks, std::uint64_t{kSteps});
  ASSERT_EQ(trace.info().bodies, 3u);
  EXPECT_EQ(trace.info().complete, 1);
  EXPECT_NEAR(trace.info().duration, 0.002 * (kSteps - 1), 1e-12);
  {
    TestScene scene(trace.options());
    std::vector<plp_trace_body> recorded;
    std::vector<plp_body> bodies;
    for (std::uint64_t i = 0; i < 3; ++i) {
      recorded.push_back(trace.body(i));
      EXPECT_EQ(recorded[i].first_tick, 0u);
      EXPECT_EQ(recorded[i].end_tick, std::uint64_t{kSteps});
      plp_body_options body;
      plp_body_options_init(&body, sizeof body);
      body.model = i == 0 ? ring_.handle : box_.handle;
      std::uint64_t hash = 0;
      ASSERT_EQ(plp_model_get_hash(body.model, &hash), PLP_OK);
      EXPECT_EQ(hash, recorded[i].model_hash);
      body.kind = static_cast<plp_body_kind>(recorded[i].kind);
      std::copy_n(recorded[i].reference_point, 3, body.reference_point);
      ASSERT_EQ(plp_scene_add_body(scene.handle, &body, &bodies.emplace_back()), PLP_OK);
    }
    ASSERT_EQ(plp_scene_record(scene.handle, second.path()), PLP_OK) << plp_last_error();
    for (std::uint64_t i = 0; i < kSteps; ++i) {
      for (std::size_t b = 0; b < 3; ++b)
        ASSERT_EQ(plp_trace_place(trace.handle, i, recorded[b].body, scene.handle, bodies[b]), PLP_OK)
            << plp_last_error();
      EXPECT_EQ(bits_of(scene.step()), told.bits[i]) << "step " << i;
    }
  }  // which finishes the file

  const TestTrace again(second);
  ASSERT_EQ(again.info().ticks, std::uint64_t{kSteps});
  EXPECT_EQ(again.info().complete, 1);
  for (std::uint64_t i = 0; i < kSteps; ++i) {
    const plp_trace_tick one = trace.read(i);
    const std::string bits = bits_of(trace.contacts());
    EXPECT_EQ(bits, told.bits[i]);
    const plp_trace_tick other = again.read(i);
    EXPECT_EQ(bits_of(again.contacts()), bits);
    EXPECT_EQ(one.step, i + 1);
    EXPECT_EQ(std::memcmp(&one.wrench, &other.wrench, sizeof one.wrench), 0);
    EXPECT_EQ(std::memcmp(&one.tool_pose, &other.tool_pose, sizeof one.tool_pose), 0);
    EXPECT_EQ(one.cutoff, options().cutoff);
    EXPECT_EQ(one.time, other.time);
  }
  std::printf("%zu LMDs, %zu steps overlapped, %zu with walls\n", told.lmds, told.overlaps, told.walls);
}

INSTANTIATE_TEST_SUITE_P(
    Manners, Replay,
    testing::Values(Manner{PLP_MODE_GLOBAL, PLP_LAW_SPRINGS}, Manner{PLP_MODE_GLOBAL, PLP_LAW_SMOOTH},
                    Manner{PLP_MODE_DESCENT, PLP_LAW_SPRINGS}, Manner{PLP_MODE_DESCENT, PLP_LAW_SMOOTH},
                    Manner{PLP_MODE_CERTIFIED, PLP_LAW_SPRINGS}, Manner{PLP_MODE_CERTIFIED, PLP_LAW_SMOOTH},
                    Manner{PLP_MODE_CERTIFIED, PLP_LAW_SMOOTH, true}),
    name_of);

}  // namespace
}  // namespace palpate::test

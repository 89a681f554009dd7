#include <atomic>
#include <functional>
#include <thread>

#include "tests/capi/shapes.h"

namespace palpate::test {
namespace {

void in_threads(int count, const std::function<void(int)>& work) {
  std::vector<std::thread> threads;
  for (int i = 0; i < count; ++i) threads.emplace_back(work, i);
  for (std::thread& thread : threads) thread.join();
}

// The first to come near builds the hierarchy, the others wait for it.
TEST(Threads, ShareOneModel) {
  const TestModel model(torus(1.0, 0.25, 48, 24));
  in_threads(4, [&](int thread) {
    TestQuery query;
    plp_query_options options;
    plp_query_options_init(&options, sizeof options);
    options.cutoff = 0.2;
    for (int i = 0; i < 20; ++i) {
      const plp_pose pose = at(2.55 + 0.001 * i, 0.01 * thread, 0);
      EXPECT_EQ(plp_query(model.handle, model.handle, &pose, &options, query.handle), PLP_OK);
      EXPECT_GT(query.contacts().set_count, 0u);
    }
  });
}

TEST(Threads, RetainAndReleaseOneModel) {
  plp_model model = nullptr;
  const Shape shape = box(1, 1, 1);
  const plp_triangles triangles = triangles_of(shape);
  ASSERT_EQ(plp_model_create_from_triangles(&triangles, nullptr, &model), PLP_OK);
  in_threads(4, [&](int) {
    for (int i = 0; i < 2000; ++i) {
      EXPECT_EQ(plp_model_retain(model), PLP_OK);
      EXPECT_EQ(plp_model_release(model), PLP_OK);
    }
  });
  EXPECT_EQ(plp_model_release(model), PLP_OK);
  EXPECT_EQ(plp_model_prepare(model), PLP_ERROR_INVALID_HANDLE);
}

// A model is released while others use it: each use either succeeds or is refused.
TEST(Threads, ReleaseWhileInUse) {
  const Shape shape = box(1, 1, 1);
  const plp_triangles triangles = triangles_of(shape);
  for (int round = 0; round < 50; ++round) {
    plp_model model = nullptr;
    ASSERT_EQ(plp_model_create_from_triangles(&triangles, nullptr, &model), PLP_OK);
    std::atomic<int> surprises = 0;
    in_threads(3, [&](int thread) {
      if (thread == 0) {
        plp_model_release(model);
        return;
      }
      plp_model_info info;
      plp_model_info_init(&info, sizeof info);
      const plp_result result = plp_model_get_info(model, &info);
      const bool expected =
          result == PLP_OK ? info.searched.triangles == 12 : result == PLP_ERROR_INVALID_HANDLE;
      if (!expected) ++surprises;
    });
    EXPECT_EQ(surprises, 0);
  }
}

TEST(Threads, ScenesSideBySide) {
  const TestModel ring(torus(1.0, 0.25, 48, 24));
  std::vector<double> forces(4);
  in_threads(4, [&](int thread) {
    TestScene scene(0.2);
    scene.add(ring.handle, PLP_BODY_STATIC, at(0, 0, 0));
    scene.add(ring.handle, PLP_BODY_TOOL, at(2.6, 0, 0.05));
    forces[thread] = scene.step().wrench.force[0];
  });
  EXPECT_GT(forces[0], 0.0);
  for (const double force : forces) EXPECT_EQ(force, forces[0]);
}

TEST(Threads, LogReceiverIsExchangedWhileModelsAreMade) {
  std::atomic<int> heard = 0;
  const auto hear = [](plp_log_level, const char*, void* user) { ++*static_cast<std::atomic<int>*>(user); };
  in_threads(4, [&](int thread) {
    for (int i = 0; i < 50; ++i) {
      if (thread < 2) {
        plp_set_log_callback(hear, &heard);
      } else {
        const TestModel model(box(1, 1, 1));
      }
    }
  });
  plp_set_log_callback(nullptr, nullptr);
  EXPECT_LE(heard, 100);
}

}  // namespace
}  // namespace palpate::test

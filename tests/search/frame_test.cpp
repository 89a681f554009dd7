#include "engine/mesh/frame.h"

#include <gtest/gtest.h>

#include "tests/support/random_poses.h"

namespace palpate {
namespace {

// Every float32 coordinate comes back with all its bits, wherever the model lies.
TEST(ModelFrame, KeepsEveryBitOfFloat32) {
  Random random(7);
  for (double offset : {0.0, 0.3, 1.0, 7.0, 1e3, 1e6, -1e6}) {
    for (double size : {1e-3, 1.0, 50.0}) {
      std::vector<DVec3> positions;
      Box box;
      for (int i = 0; i < 1000; ++i) {
        const Vec3 p(offset + size * random.uniform(-1, 1), size * random.uniform(-1, 1),
                     -2 * offset + size * random.uniform(-1, 1));
        positions.emplace_back(p);
        box.grow(positions.back());
      }
      const ModelFrame frame = frame_of(box);
      for (const DVec3& p : positions) EXPECT_EQ(frame.metres(DVec3(frame.normalised(p))), p);
    }
  }
}

TEST(ModelFrame, KeepsFlatModelsFlat) {
  for (double height : {0.0, 3.0, -0.1f * 1e6}) {
    Box box;
    box.grow(DVec3(0, 0, height));
    box.grow(DVec3(1, 2, height));
    const ModelFrame frame = frame_of(box);
    EXPECT_EQ(frame.metres(DVec3(frame.normalised({0.5, 0.25, height}))).z, height);
  }
}

TEST(ModelFrame, BelowTheRangeOfFloatIsZero) {
  Box box;
  box.grow(DVec3(0, 0, 1e-320));
  box.grow(DVec3(1, 2, 1e-320));
  EXPECT_EQ(frame_of(box).normalised({0.5, 0.25, 1e-320}).z, 0.0f);
}

TEST(ModelFrame, DiagonalIsAboutOne) {
  for (double size : {1e-30, 1e-6, 0.3, 1.0, 4.0, 1e6, 1e30}) {
    Box box;
    box.grow(DVec3(-size));
    box.grow(DVec3(size));
    const double diagonal = box.diagonal() / frame_of(box).scale;
    EXPECT_GE(diagonal, 0.5);
    EXPECT_LE(diagonal, 1.0);
  }
}

}  // namespace
}  // namespace palpate

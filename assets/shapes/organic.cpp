#include "assets/shapes/organic.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "assets/shapes/random_numbers.h"
#include "assets/shapes/soup_edit.h"

namespace palpate::shapes {
namespace {

// A ripple over the sphere of directions.
struct Wave {
  DVec3 frequency;
  double phase;
  double height;
};

// A smooth bump around one direction; `sharpness` is the inverse square of its width in radians.
struct Lobe {
  DVec3 direction;
  double sharpness;
  double height;
};

class Relief {
 public:
  Relief() {
    constexpr std::uint64_t kSeed = 2004;
    RandomNumbers random(kSeed);
    for (int i = 0; i < 24; ++i) {
      const double octave = std::exp2(i / 8);
      waves_.push_back(
          {random.direction() * 4.0 * octave, random.between(0.0, 2.0 * std::numbers::pi), 0.03 / octave});
    }
    for (int i = 0; i < 9; ++i) {
      lobes_.push_back({random.direction(), random.between(12.0, 30.0), random.between(0.25, 0.5)});
    }
  }

  // Radius in a direction, about 1.
  double radius(const DVec3& direction) const {
    double sum = 1.0;
    for (const Wave& w : waves_) sum += w.height * std::sin(glm::dot(w.frequency, direction) + w.phase);
    for (const Lobe& l : lobes_)
      sum += l.height * std::exp(l.sharpness * (glm::dot(l.direction, direction) - 1.0));
    return sum;
  }

 private:
  std::vector<Wave> waves_;
  std::vector<Lobe> lobes_;
};

// From the cube [−1, 1]³ to the sphere; the tangent evens out the sizes of the cells.
DVec3 direction_of(const DVec3& cube_point) {
  constexpr double kEighthTurn = 0.25 * std::numbers::pi;
  DVec3 warped;
  for (int axis = 0; axis < 3; ++axis) warped[axis] = std::tan(kEighthTurn * cube_point[axis]);
  return glm::normalize(warped);
}

}  // namespace

TriangleSoup organic(const Divisions& divisions) {
  const DVec3 semi_axes(0.075, 0.058, 0.05);
  const Relief relief;
  TriangleSoup soup = box({2.0, 2.0, 2.0}, divisions);
  for (DVec3& position : soup.positions) {
    const DVec3 direction = direction_of(position);
    position = semi_axes * direction * relief.radius(direction);
  }
  return rounded_to_float32(std::move(soup));
}

}  // namespace palpate::shapes

#include "engine/trace/trace_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/trace/fields.h"

namespace palpate {
namespace {

constexpr double kLargestNumber = 1e15;  // of what a caller may give
constexpr std::uint32_t kLastMode = 2, kLastLaw = 1, kLastKind = 2;
constexpr double kRigid = 1e-9;  // by which a rotation's columns may miss unit length and right angles

// Of all numbers of a record.
class FiniteTest {
 public:
  void operator()(double number) { all_ = all_ && std::isfinite(number); }
  template <class Number>
  void operator()(const Number&) {}
  template <class Number, std::size_t kCount>
  void operator()(const std::array<Number, kCount>& numbers) {
    for (const Number& number : numbers) (*this)(number);
  }
  bool all() const { return all_; }

 private:
  bool all_ = true;
};

template <class Record>
bool is_finite(Record record) {
  FiniteTest test;
  each_field(record, test);
  return test.all();
}

bool within(double number, double low, double high) {
  return number >= low && number <= high;
}

double dot(const TracePose& pose, int i, int j) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += pose.rotation[3 * i + k] * pose.rotation[3 * j + k];
  return sum;
}

double determinant(const std::array<double, 9>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}

bool is_rigid(const TracePose& pose) {
  for (int i = 0; i < 3; ++i) {
    if (!within(pose.translation[i], -kLargestNumber, kLargestNumber)) return false;
    for (int j = 0; j <= i; ++j)
      if (!(std::abs(dot(pose, i, j) - (i == j ? 1.0 : 0.0)) <= kRigid)) return false;
  }
  return determinant(pose.rotation) > 0.0;
}

bool is_space(const TraceSpace& space) {
  bool used[4] = {};
  for (const std::int32_t axis : space.axes) {
    if (axis < -3 || axis > 3 || axis == 0 || used[std::abs(axis)]) return false;
    used[std::abs(axis)] = true;
  }
  return within(space.metres_per_unit, 1e-9, 1e9);
}

}  // namespace

const char* fault_of(const TraceHeader& header) {
  if (!is_space(header.space)) return "its space is none";
  if (!within(header.fade_time, 0.0, kLargestNumber)) return "its fade_time is out of range";
  if (!within(header.time_step, 1e-6, 1.0)) return "its time_step is out of range";
  return fault_of(header.settings);
}

const char* fault_of(const TraceSettings& settings) {
  const double least = std::numeric_limits<double>::denorm_min();
  if (!within(settings.cutoff, least, kLargestNumber)) return "a cutoff is out of range";
  for (const double number :
       {settings.stiffness, settings.damping, std::abs(settings.stiffness_cap), settings.friction})
    if (!within(number, 0.0, kLargestNumber)) return "a setting is out of range";
  if (settings.mode > kLastMode) return "a mode is none";
  if (settings.law > kLastLaw) return "a law is none";
  return nullptr;
}

const char* fault_of(const TraceBody& body) {
  if (body.id == 0) return "a body has no id";
  if (body.kind > kLastKind) return "a body is of no kind";
  if (body.intangible > 1) return "a body is neither tangible nor not";
  if (!within(body.stiffness, 0.0, kLargestNumber) || !within(body.damping, 0.0, kLargestNumber) ||
      !within(body.friction, -kLargestNumber, kLargestNumber))
    return "a number of a body is out of range";
  const auto in_range = [](double x) { return within(x, -kLargestNumber, kLargestNumber); };
  return std::ranges::all_of(body.reference_point, in_range) ? nullptr : "a reference point is out of range";
}

const char* fault_of(const TraceTick& tick) {
  if (tick.step == 0) return "a step has no number";
  if (!within(tick.time_step, 1e-6, 1.0)) return "a time_step is out of range";
  if (!is_rigid(tick.tool_pose)) return "the pose of the tool is none";
  if (!(tick.min_distance >= 0.0)) return "a least distance is out of range";
  TraceTick finite = tick;
  finite.min_distance = 0.0;  // may be infinite
  if (!is_finite(finite)) return "a number is infinite or none";
  if (tick.overlap > 1 || tick.settings_count > 1) return "a flag is neither 0 nor 1";
  return nullptr;
}

const char* fault_of(const TraceMove& move) {
  return is_rigid(move.pose) ? nullptr : "the pose of a body is none";
}

const char* fault_of(const TraceContact& contact) {
  if (!is_finite(contact)) return "a contact has a number that is infinite or none";
  for (int i = 0; i < 2; ++i)
    if (contact.feature[i] > 2 || contact.corner[i] > 2) return "a contact is on no feature";
  return nullptr;
}

}  // namespace palpate

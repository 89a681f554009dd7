#include "engine/snch/node_batch.h"

// Compiled once for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/snch/node_batch.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, NodeBatch::kMost>;
using Float = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

// Bound on the rounding of a float32 sum of lengths, relative to their size.
constexpr float kRounding = 4e-6f;
constexpr float kForever = 1e30f;

Float constant(float x) {
  return hn::Set(Lanes(), x);
}

Float squared(Float x) {
  return hn::Mul(x, x);
}

Float positive(Float x) {
  return hn::Max(x, hn::Zero(Lanes()));
}

struct Float3 {
  Float x, y, z;
};

Float dot(const Float3& a, const Float3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

Float length(const Float3& a) {
  return hn::Sqrt(dot(a, a));
}

Float3 operator*(const Float3& a, Float factor) {
  return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

Float3 operator+(const Float3& a, const Float3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

Float3 cross(const Float3& a, const Float3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

Float3 negative(const Float3& a) {
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}

// Matrices come by column.
Float3 times(const float (&m)[3][3], const Float3& v) {
  const auto row = [&](int k) {
    return hn::Add(hn::Add(hn::Mul(constant(m[0][k]), v.x), hn::Mul(constant(m[1][k]), v.y)),
                   hn::Mul(constant(m[2][k]), v.z));
  };
  return {row(0), row(1), row(2)};
}

Float3 transposed_times(const float (&m)[3][3], const Float3& v) {
  const auto row = [&](int k) {
    return hn::Add(hn::Add(hn::Mul(constant(m[k][0]), v.x), hn::Mul(constant(m[k][1]), v.y)),
                   hn::Mul(constant(m[k][2]), v.z));
  };
  return {row(0), row(1), row(2)};
}

Float3 select(Mask mask, const Float3& yes, const Float3& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

// A cone of unit directions; the cosine is negative where it is whole.
struct WideCone {
  Float3 axis;
  Float cosine;
  Float sine;
};

using Words = hn::RebindToUnsigned<Lanes>;
using Word = hn::Vec<Words>;

// Four words of as many nodes as there are lanes.
struct FourWords {
  Word word[4];
};

// Turns rows around: four words of every fourth node each become four words of all.
FourWords half_of(const NodeBatch::Rows& rows, std::size_t half, std::size_t first) {
#if HWY_TARGET == HWY_SCALAR
  const std::uint32_t* words = rows.halves[half][first % 4].data() + first / 4 * 4;
  return {{hn::Load(Words(), words), hn::Load(Words(), words + 1), hn::Load(Words(), words + 2),
           hn::Load(Words(), words + 3)}};
#else
  const auto row = [&](std::size_t j) { return hn::Load(Words(), rows.halves[half][j].data() + first); };
  const Word row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
  const Word even = hn::InterleaveLower(Words(), row0, row2), odd = hn::InterleaveLower(Words(), row1, row3);
  const Word even_up = hn::InterleaveUpper(Words(), row0, row2),
             odd_up = hn::InterleaveUpper(Words(), row1, row3);
  return {{hn::InterleaveLower(Words(), even, odd), hn::InterleaveUpper(Words(), even, odd),
           hn::InterleaveLower(Words(), even_up, odd_up), hn::InterleaveUpper(Words(), even_up, odd_up)}};
#endif
}

// One lane a node: decodes as many rows as there are lanes, as PackedNode does.
class WideNodes {
 public:
  WideNodes(const NodeBatch::Rows& rows, std::size_t first) {
    const auto [x, y, z, link] = half_of(rows, 0, first).word;
    const auto [x_and_y, z_and_radius, low_bits_and_cone, octant] = half_of(rows, 1, first).word;
    centre_ = {hn::BitCast(Lanes(), x), hn::BitCast(Lanes(), y), hn::BitCast(Lanes(), z)};
    half_ = {span(low(x_and_y), low_bits_and_cone), span(high(x_and_y), hn::ShiftRight<4>(low_bits_and_cone)),
             span(low(z_and_radius), hn::ShiftRight<8>(low_bits_and_cone))};
    radius_ = span(high(z_and_radius), hn::ShiftRight<12>(low_bits_and_cone));
    cone_ = cone_of(high(low_bits_and_cone), axis_of(octant));
  }

  const Float3& centre() const { return centre_; }
  Float radius() const { return radius_; }
  const Float3& half() const { return half_; }
  const WideCone& cone() const { return cone_; }

 private:
  using Ints = hn::RebindToSigned<Lanes>;

  static Word low(Word word) { return hn::And(word, hn::Set(Words(), 0xFFFFu)); }
  static Word high(Word word) { return hn::ShiftRight<16>(word); }

  static Float decoded(Word code) {
    return hn::BitCast(
        Lanes(), hn::Add(hn::ShiftLeft<FloatCode::kDropped>(code), hn::Set(Words(), FloatCode::kLeast)));
  }
  static Float span(Word upper, Word lower) {
    return decoded(hn::Or(hn::ShiftLeft<4>(upper), hn::And(lower, hn::Set(Words(), 15u))));
  }

  static Float3 axis_of(Word octant) {
    const auto place = [](Word code) {
      const auto from_centre = hn::Sub(hn::BitCast(Ints(), code), hn::Set(Ints(), PackedNode::kOctantCentre));
      return hn::Mul(hn::ConvertTo(Lanes(), from_centre), constant(1.0f / PackedNode::kOctantCentre));
    };
    Float3 axis{place(low(octant)), place(high(octant)), constant(1.0f)};
    axis.z = hn::Sub(hn::Sub(axis.z, hn::Abs(axis.x)), hn::Abs(axis.y));
    const Float fold = positive(hn::Neg(axis.z));
    axis.x = hn::Sub(axis.x, hn::CopySign(fold, axis.x));
    axis.y = hn::Sub(axis.y, hn::CopySign(fold, axis.y));
    return axis * hn::Div(constant(1.0f), length(axis));
  }

  static WideCone cone_of(Word code, const Float3& axis) {
    const Mask whole =
        hn::RebindMask(Lanes(), hn::Eq(code, hn::Set(Words(), std::uint32_t{PackedNode::kWhole})));
    const Float tangent = decoded(hn::ShiftLeft<4>(code)), tangent_squared = squared(tangent);
    const Float share = hn::Div(constant(2.0f), hn::Add(constant(1.0f), tangent_squared));
    const Float cosine = hn::Sub(constant(PackedNode::kBelowOne), hn::Mul(share, tangent_squared));
    return {axis, hn::IfThenElse(whole, constant(-1.0f), cosine),
            hn::IfThenElse(whole, hn::Zero(Lanes()), hn::Mul(share, tangent))};
  }

  static_assert(offsetof(PackedNode, half) == 16 && offsetof(PackedNode, radius) == 22 &&
                offsetof(PackedNode, low_bits) == 24 && offsetof(PackedNode, cone) == 26 &&
                offsetof(PackedNode, octant) == 28);

  Float3 centre_;
  Float radius_;
  Float3 half_;
  WideCone cone_;
};

// Squared distance from `d` to the segments from the origin of length `cutoff` along all directions of the
// cone.
Float squared_distance_to_sector(const Float3& d, Float d_squared, const WideCone& cone, Float cutoff) {
  const Float along = dot(d, cone.axis);
  const Float across = hn::Sqrt(positive(hn::Sub(d_squared, squared(along))));
  const Mask inside = hn::Or(hn::Lt(cone.cosine, hn::Zero(Lanes())),
                             hn::Ge(hn::Mul(along, cone.sine), hn::Mul(across, cone.cosine)));
  const Float beyond = positive(hn::Sub(hn::Sqrt(d_squared), cutoff));
  const Float foot = hn::Add(hn::Mul(along, cone.cosine), hn::Mul(across, cone.sine));
  const Float reach = hn::Min(positive(foot), cutoff);
  const Float outside = hn::Add(squared(hn::Sub(along, hn::Mul(reach, cone.cosine))),
                                squared(hn::Sub(across, hn::Mul(reach, cone.sine))));
  return hn::IfThenElse(inside, squared(beyond), outside);
}

// Directions that two cones have in common lie in one; `empty` where there are none.
struct Lens {
  WideCone cone;
  Mask empty;
};

// The chord through the two points where the cones' rims meet is foot + height; a rim's centre beyond the
// foot has its smaller cone wholly within the other.
Lens lens_of(const WideCone& one, const WideCone& other) {
  const Float zero = hn::Zero(Lanes()), unit = constant(1.0f);
  const Mask whole = hn::Lt(one.cosine, zero), other_whole = hn::Lt(other.cosine, zero);
  const Mask neither = hn::Not(hn::Or(whole, other_whole));
  const Float between = dot(one.axis, other.axis);
  const Float sum_cosine = hn::Sub(hn::Mul(one.cosine, other.cosine), hn::Mul(one.sine, other.sine));
  const Mask empty = hn::And(neither, hn::Lt(between, hn::Sub(sum_cosine, constant(kRounding))));

  const Mask takes_one = hn::Or(other_whole, hn::AndNot(whole, hn::Gt(one.cosine, other.cosine)));
  const WideCone smaller{select(takes_one, one.axis, other.axis),
                         hn::IfThenElse(takes_one, one.cosine, other.cosine),
                         hn::IfThenElse(takes_one, one.sine, other.sine)};

  const Float across = hn::Max(hn::Sub(unit, squared(between)), constant(1e-4f));
  const Float along = hn::Div(hn::Sub(one.cosine, hn::Mul(between, other.cosine)), across);
  const Float other_along = hn::Div(hn::Sub(other.cosine, hn::Mul(between, one.cosine)), across);
  const Float3 foot = one.axis * along + other.axis * other_along;
  const Float reach = length(foot);
  const Float cosine = hn::Sub(hn::Sub(reach, constant(1e-5f)), hn::Div(constant(kRounding), across));
  Mask narrower = hn::And(neither, hn::Gt(across, constant(1e-4f)));
  narrower = hn::And(narrower, hn::And(hn::Gt(along, zero), hn::Gt(other_along, zero)));
  narrower = hn::And(narrower, hn::And(hn::Lt(cosine, unit), hn::Gt(cosine, hn::Max(smaller.cosine, zero))));
  const Float3 axis = foot * hn::Div(unit, hn::Max(reach, constant(1e-4f)));
  const Float sine = hn::Sqrt(positive(hn::Sub(unit, squared(cosine))));
  return {{select(narrower, axis, smaller.axis), hn::IfThenElse(narrower, cosine, smaller.cosine),
           hn::IfThenElse(narrower, sine, smaller.sine)},
          empty};
}

// What both tests measure first: spheres and boxes.
struct Gap {
  Float3 in_a;  // centre to centre, A's frame
  Float3 in_b;  // the same, B's axes
  Float squared;
  Float distance;
  Float radii;       // of both spheres, rounding added
  Float3 outside_a;  // beyond both boxes along A's axes; negative within
  Float3 outside_b;
};

Float3 outside(const Float3& gap, const Float3& halves) {
  return {hn::Sub(hn::Abs(gap.x), halves.x), hn::Sub(hn::Abs(gap.y), halves.y),
          hn::Sub(hn::Abs(gap.z), halves.z)};
}

Float length_outside(const Float3& outside) {
  return length({positive(outside.x), positive(outside.y), positive(outside.z)});
}

Gap gap_between(const NodeBatch::View& view, const WideNodes& a, const WideNodes& b, const Float3& in_a) {
  const Float ratio = constant(view.ratio);
  const Float radii = hn::Add(a.radius(), hn::Mul(ratio, b.radius()));
  const Float slack = hn::Mul(constant(kRounding), hn::Add(radii, constant(view.cutoff)));
  const Float3 slacks{slack, slack, slack};
  const Float3 half_a = a.half(), half_b = b.half() * ratio;
  Gap gap;
  gap.in_a = in_a;
  gap.in_b = transposed_times(view.rotation, in_a);
  gap.squared = dot(in_a, in_a);
  gap.distance = hn::Sqrt(gap.squared);
  gap.radii = hn::Mul(radii, constant(1.0f + kRounding));
  gap.outside_a = outside(gap.in_a, half_a + times(view.magnitude, half_b) + slacks);
  gap.outside_b = outside(gap.in_b, transposed_times(view.magnitude, half_a) + half_b + slacks);
  return gap;
}

// The largest component, along an axis, of the unit directions of a cone whose own axis has these components
// along it and across; not negative.
Float farthest_along(const WideCone& cone, Float along, Float across) {
  const Float rim = hn::Add(hn::Mul(along, cone.cosine), hn::Mul(across, cone.sine));
  const Mask within = hn::Or(hn::Lt(cone.cosine, hn::Zero(Lanes())), hn::Ge(along, cone.cosine));
  return hn::Add(hn::IfThenElse(within, constant(1.0f), positive(rim)), constant(kRounding));
}

// How far the one model lies, along an axis, beyond the boxes that the other's cones sweep within the cutoff;
// the larger over the axes, seen from A and from B.
struct Swept {
  Float from_a;
  Float from_b;
};

Swept beyond_swept_boxes(const Gap& gap, const WideCone& a, const WideCone& b, float cutoff) {
  const Float zero = hn::Zero(Lanes()), reach = constant(cutoff);
  const auto beyond = [&](Float outside, Mask high, const WideCone& cone, Float along, Float one,
                          Float other) {
    const Float towards = hn::IfThenElse(high, along, hn::Neg(along));
    const Float across = hn::Sqrt(hn::Add(squared(one), squared(other)));
    return hn::Sub(outside, hn::Mul(reach, farthest_along(cone, towards, across)));
  };
  const auto over_axes = [&](const Float3& outside, Mask x, Mask y, Mask z, const WideCone& cone) {
    const Float3& axis = cone.axis;
    return hn::Max(beyond(outside.x, x, cone, axis.x, axis.y, axis.z),
                   hn::Max(beyond(outside.y, y, cone, axis.y, axis.z, axis.x),
                           beyond(outside.z, z, cone, axis.z, axis.x, axis.y)));
  };
  return {over_axes(gap.outside_a, hn::Gt(gap.in_a.x, zero), hn::Gt(gap.in_a.y, zero),
                    hn::Gt(gap.in_a.z, zero), a),
          over_axes(gap.outside_b, hn::Lt(gap.in_b.x, zero), hn::Lt(gap.in_b.y, zero),
                    hn::Lt(gap.in_b.z, zero), b)};
}

WideCone cone_in_a(const NodeBatch::View& view, const WideCone& cone) {
  return {negative(times(view.rotation, cone.axis)), cone.cosine, cone.sine};
}

#if HWY_TARGET == HWY_SCALAR
using Parts = Lanes;

template <class Of>
Float by_parts(const Of& of) {
  return of([](Float all) { return all; });
}
#else
using Parts = hn::Half<Lanes>;

// Of doubles there is room for half the lanes at a time.
template <class Of>
Float by_parts(const Of& of) {
  return hn::Combine(Lanes(), of([](Float all) { return hn::UpperHalf(Parts(), all); }),
                     of([](Float all) { return hn::LowerHalf(Parts(), all); }));
}
#endif

// The way from A's centres to B's along one of A's axes. Double precision, rounded after the subtraction.
Float gap_along(const NodeBatch::View& view, int axis, Float a, const Float3& b) {
  using Doubles = hn::Rebind<double, Parts>;
  return by_parts([&](const auto& part) {
    const auto wide = [&](Float all) { return hn::PromoteTo(Doubles(), part(all)); };
    const auto times = [&](int column, Float all) {
      return hn::Mul(hn::Set(Doubles(), view.linear[column][axis]), wide(all));
    };
    const auto turned = hn::Add(hn::Add(times(0, b.x), times(1, b.y)), times(2, b.z));
    const auto there = hn::Add(turned, hn::Set(Doubles(), view.translation[axis]));
    return hn::DemoteTo(Parts(), hn::Sub(there, wide(a)));
  });
}

Float3 gap_of_centres(const NodeBatch::View& view, const WideNodes& a, const WideNodes& b) {
  return {gap_along(view, 0, a.centre().x, b.centre()), gap_along(view, 1, a.centre().y, b.centre()),
          gap_along(view, 2, a.centre().z, b.centre())};
}

void judge_lanes(const NodeBatch::View& view, const NodeBatch::Rows& rows_a, const NodeBatch::Rows& rows_b,
                 std::size_t first, NodeBatch::Verdict* verdicts) {
  const WideNodes a(rows_a, first), b(rows_b, first);
  const Gap gap = gap_between(view, a, b, gap_of_centres(view, a, b));
  const Float cutoff = constant(view.cutoff), zero = hn::Zero(Lanes());
  const Float apart = hn::Max(length_outside(gap.outside_a), length_outside(gap.outside_b));
  const Mask near =
      hn::And(hn::Le(hn::Mul(gap.distance, constant(1.0f - kRounding)), hn::Add(gap.radii, cutoff)),
              hn::Le(apart, cutoff));
  const Mask contact = hn::And(near, hn::And(hn::Le(apart, zero), hn::Le(gap.squared, squared(gap.radii))));

  const Swept swept = beyond_swept_boxes(gap, a.cone(), b.cone(), view.cutoff);
  const Lens lens = lens_of(a.cone(), cone_in_a(view, b.cone()));
  const Float sector = squared_distance_to_sector(gap.in_a, gap.squared, lens.cone, cutoff);
  const Mask in_sector =
      hn::Le(sector, hn::Add(squared(gap.radii), hn::Mul(constant(kRounding), gap.squared)));
  Mask minimum = hn::And(near, hn::Le(hn::Max(swept.from_a, swept.from_b), zero));
  minimum = hn::And(minimum, hn::AndNot(lens.empty, in_sector));

  alignas(64) float minima[NodeBatch::kMost], contacts[NodeBatch::kMost];
  hn::Store(hn::IfThenElseZero(minimum, constant(1.0f)), Lanes(), minima);
  hn::Store(hn::IfThenElseZero(contact, constant(1.0f)), Lanes(), contacts);
  for (std::size_t i = 0; i < hn::Lanes(Lanes()); ++i) verdicts[i] = {minima[i] != 0.0f, contacts[i] != 0.0f};
}

void judge(const NodeBatch::View& view, const NodeBatch::Rows& rows_a, const NodeBatch::Rows& rows_b,
           std::size_t count, NodeBatch::Verdicts& verdicts) {
  for (std::size_t first = 0; first < count; first += hn::Lanes(Lanes()))
    judge_lanes(view, rows_a, rows_b, first, verdicts.data() + first);
}

// As certified_from_b().
Float seen_from_b(Float slack, float reach) {
  const Float kept =
      hn::Div(slack, hn::Add(constant(1.0f), hn::Mul(positive(slack), constant(1.0f / reach))));
  return hn::Mul(kept, constant(1.0f - kRounding));
}

// A lower bound of the angle by which one cone clears the other; not positive where they meet. The sine of a
// difference of angles bounds it up to a right angle, and is exact enough for narrow cones, too.
Float angle_between(const WideCone& one, const WideCone& other) {
  const Float zero = hn::Zero(Lanes());
  const Float cosine = dot(one.axis, other.axis), sine = length(cross(one.axis, other.axis));
  const Float sum_cosine = hn::Sub(hn::Mul(one.cosine, other.cosine), hn::Mul(one.sine, other.sine));
  const Float sum_sine = hn::Add(hn::Mul(one.sine, other.cosine), hn::Mul(one.cosine, other.sine));
  const Float clear_sine = hn::Sub(hn::Mul(sine, sum_cosine), hn::Mul(cosine, sum_sine));
  const Float clear_cosine = hn::Add(hn::Mul(cosine, sum_cosine), hn::Mul(sine, sum_sine));
  const Mask obtuse = hn::And(hn::Lt(clear_cosine, zero), hn::Gt(clear_sine, zero));
  const Float angle = hn::Sub(hn::IfThenElse(obtuse, constant(1.0f), clear_sine), constant(kRounding));
  const Mask bounded = hn::And(hn::Ge(one.cosine, zero), hn::Ge(other.cosine, zero));
  return hn::IfThenElse(bounded, angle, constant(-1.0f));
}

void certify_lanes(const NodeBatch::View& view, const NodeBatch::Rows& rows_a, const NodeBatch::Rows& rows_b,
                   std::size_t first, const MotionRate& rate, float reach,
                   NodeBatch::Certificates& certificates) {
  const WideNodes a(rows_a, first), b(rows_b, first);
  const Gap gap = gap_between(view, a, b, gap_of_centres(view, a, b));
  const Float cutoff = constant(view.cutoff), zero = hn::Zero(Lanes()), forever = constant(kForever);
  const Float between = hn::Sub(hn::Mul(gap.distance, constant(1.0f - kRounding)), gap.radii);
  const Float from_a = length_outside(gap.outside_a), from_b = length_outside(gap.outside_b);
  const Float far =
      hn::Max(hn::Sub(hn::Max(between, from_a), cutoff), seen_from_b(hn::Sub(from_b, cutoff), reach));
  const Float apart = hn::Max(hn::Max(between, from_a), seen_from_b(from_b, reach));

  // No direction of the one cone meets the other's model within the cutoff.
  const WideCone cone_a = a.cone(), cone_b = cone_in_a(view, b.cone());
  const auto clear_of = [&](const WideCone& cone) {
    const Float clear = hn::Sqrt(squared_distance_to_sector(gap.in_a, gap.squared, cone, cutoff));
    return hn::Sub(hn::Sub(clear, gap.radii), hn::Mul(constant(kRounding), gap.distance));
  };
  const Swept boxes = beyond_swept_boxes(gap, a.cone(), b.cone(), view.cutoff);
  const Float swept = hn::Max(hn::Max(boxes.from_a, clear_of(cone_a)),
                              seen_from_b(hn::Max(boxes.from_b, clear_of(cone_b)), reach));
  const Float turned = angle_between(cone_a, cone_b);
  const Float ratio = constant(static_cast<float>(rate.distance() / rate.angle()));
  const Mask by_turn = hn::Gt(hn::Mul(turned, ratio), swept);

  const Mask is_far = hn::Gt(far, zero);
  const Float distance = hn::IfThenElse(is_far, far, hn::Min(apart, hn::IfThenElse(by_turn, forever, swept)));
  const Float angle = hn::IfThenElse(hn::AndNot(is_far, by_turn), turned, forever);
  hn::Store(positive(distance), Lanes(), certificates.distance.data() + first);
  hn::Store(positive(angle), Lanes(), certificates.angle.data() + first);
}

void certify(const NodeBatch::View& view, const NodeBatch::Rows& rows_a, const NodeBatch::Rows& rows_b,
             std::size_t count, const MotionRate& rate, float reach, NodeBatch::Certificates& certificates) {
  for (std::size_t first = 0; first < count; first += hn::Lanes(Lanes()))
    certify_lanes(view, rows_a, rows_b, first, rate, reach, certificates);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>

namespace palpate {
namespace {

HWY_EXPORT(judge);
HWY_EXPORT(certify);

NodeBatch::View view_of(const Placement& placement, double cutoff) {
  constexpr float kRounding = 4e-6f;
  NodeBatch::View view;
  for (int column = 0; column < 3; ++column) {
    view.translation[column] = placement.translation[column];
    for (int row = 0; row < 3; ++row) {
      view.linear[column][row] = placement.linear[column][row];
      const auto entry = static_cast<float>(placement.rotation[column][row]);
      view.rotation[column][row] = entry;
      view.magnitude[column][row] = std::abs(entry) + kRounding;
    }
  }
  view.ratio = static_cast<float>(placement.ratio);
  view.cutoff = static_cast<float>(cutoff) * (1.0f + kRounding);
  return view;
}

}  // namespace

NodeBatch::NodeBatch(const Tree& a, const Tree& b, const Placement& placement, double cutoff)
    : a_(a),
      b_(b),
      view_(view_of(placement, cutoff)),
      tells_features_(std::max(a.node_count(), b.node_count()) <= FeatureNode::kMostNodes) {}

void NodeBatch::judge(std::span<const NodePair> pairs, Verdicts& verdicts) {
  gather(pairs);
  HWY_DYNAMIC_DISPATCH(judge)(view_, rows_a_, rows_b_, pairs.size(), verdicts);
}

void NodeBatch::certify(std::span<const NodePair> pairs, const MotionRate& rate, double reach,
                        Certificates& certificates) {
  gather(pairs);
  HWY_DYNAMIC_DISPATCH(certify)
  (view_, rows_a_, rows_b_, pairs.size(), rate, std::nextafter(static_cast<float>(reach), 0.0f),
   certificates);
}

// Rows that no pair fills repeat the first, so that no lane meets garbage.
void NodeBatch::gather(std::span<const NodePair> pairs) {
  for (std::size_t i = 0; i < kMost; ++i) {
    const NodePair pair = pairs[i < pairs.size() ? i : 0];
    rows_a_.set(i, a_.packed(FeatureNode(pair.a).node()));
    rows_b_.set(i, b_.packed(FeatureNode(pair.b).node()));
  }
}

}  // namespace palpate
#endif

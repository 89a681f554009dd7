#include "engine/kernel/triangle_batch.h"

// Compiled once for every instruction set that the processor may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/kernel/triangle_batch.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace palpate {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, TriangleBatch::kMost>;
using Float = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;
using Ints = hn::RebindToSigned<Lanes>;
using Int = hn::Vec<Ints>;

Float constant(float x) {
  return hn::Set(Lanes(), x);
}

struct Float3 {
  Float x, y, z;
};

Float3 operator+(const Float3& a, const Float3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

Float3 operator-(const Float3& a, const Float3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

Float3 operator*(const Float3& a, Float factor) {
  return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}

Float dot(const Float3& a, const Float3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

Float3 cross(const Float3& a, const Float3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

Float3 select(Mask mask, const Float3& yes, const Float3& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

Float largest(const Float3& a) {
  return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
}

// NaN, which a parameter of parallel lines or of a side without length may be, becomes 0.
Float clamp_unit(Float x) {
  const Float positive = hn::IfThenElseZero(hn::Gt(x, hn::Zero(Lanes())), x);
  return hn::Min(positive, constant(1.0f));
}

// A triangle with its longest side as its base: corner + x·base + y·height is inside for y ≥ 0 and
// foot·y ≤ x ≤ 1 − (1 − foot)·y.
struct WideFace {
  Float3 corner;
  Float3 base;
  Float3 height;  // at right angles to the base
  Float foot;     // of the height on the base
  Float per_base_squared;
  Float per_height_squared;
};

struct WideTriangle {
  Float3 corner[3];
  Float3 along[3];
  Float per_squared[3];  // 1 over the squared lengths of the sides
  WideFace face;
};

WideTriangle triangle_at(const TriangleBatch::Triangles& rows, std::size_t first) {
  const auto load = [&](int k, int axis) { return hn::Load(Lanes(), rows.corner[k][axis].data() + first); };
  const Float one = constant(1.0f);
  WideTriangle triangle;
  for (int k = 0; k < 3; ++k) triangle.corner[k] = {load(k, 0), load(k, 1), load(k, 2)};
  Float squared[3];
  for (int k = 0; k < 3; ++k) {
    triangle.along[k] = triangle.corner[(k + 1) % 3] - triangle.corner[k];
    squared[k] = dot(triangle.along[k], triangle.along[k]);
    triangle.per_squared[k] = hn::Div(one, squared[k]);
  }
  const Mask second = hn::Gt(squared[1], squared[0]);
  const Mask third = hn::Gt(squared[2], hn::Max(squared[0], squared[1]));
  const auto longest = [&](const Float3& of_first, const Float3& of_second, const Float3& of_third) {
    return select(third, of_third, select(second, of_second, of_first));
  };
  WideFace& face = triangle.face;
  face.corner = longest(triangle.corner[0], triangle.corner[1], triangle.corner[2]);
  face.base = longest(triangle.along[0], triangle.along[1], triangle.along[2]);
  const Float3 apex = longest(triangle.corner[2], triangle.corner[0], triangle.corner[1]) - face.corner;
  face.per_base_squared =
      hn::IfThenElse(third, triangle.per_squared[2],
                     hn::IfThenElse(second, triangle.per_squared[1], triangle.per_squared[0]));
  face.foot = hn::Mul(dot(apex, face.base), face.per_base_squared);
  face.height = apex - face.base * face.foot;
  face.per_height_squared = hn::Div(one, dot(face.height, face.height));
  return triangle;
}

// The closest candidate so far: two places, 0 to 2 for a side and 3 for the face, as 4 · first + second, and
// two parameters. Those of sides are one of each; those of a face are both of that face, and the other place
// is a corner, the start of the side.
struct Candidate {
  Float squared;
  Float s;
  Float t;
  Float places;

  void keep_closer(Mask valid, Float other_squared, Float other_s, Float other_t, int other_places) {
    const Mask closer = hn::And(valid, hn::Lt(other_squared, squared));
    squared = hn::IfThenElse(closer, other_squared, squared);
    s = hn::IfThenElse(closer, other_s, s);
    t = hn::IfThenElse(closer, other_t, t);
    places = hn::IfThenElse(closer, constant(static_cast<float>(other_places)), places);
  }
};

constexpr int kFace = 3;

void compare_sides(Candidate& best, const WideTriangle& a, int i, const WideTriangle& b, int j) {
  const Float3 &u = a.along[i], &v = b.along[j];
  const Float3 between = b.corner[j] - a.corner[i];
  const Float3 normal = cross(u, v);
  const Float uv = dot(u, v);
  const Float first_guess = clamp_unit(hn::Div(dot(cross(between, v), normal), dot(normal, normal)));
  const Float t = clamp_unit(hn::Mul(hn::Sub(hn::Mul(first_guess, uv), dot(between, v)), b.per_squared[j]));
  const Float s = clamp_unit(hn::Mul(hn::Add(hn::Mul(t, uv), dot(between, u)), a.per_squared[i]));
  const Float3 apart = between + v * t - u * s;
  const Float squared = dot(apart, apart);
  best.keep_closer(hn::Eq(squared, squared), squared, s, t, 4 * i + j);
}

void compare_corner(Candidate& best, const WideFace& face, const Float3& corner, int places) {
  const Float3 way = corner - face.corner;
  const Float x = hn::Mul(dot(way, face.base), face.per_base_squared);
  const Float3 across = way - face.base * x;
  const Float y = hn::Mul(dot(across, face.height), face.per_height_squared);
  const Float3 apart = across - face.height * y;
  const Float low = hn::Mul(face.foot, y);
  const Float high = hn::Add(hn::Sub(constant(1.0f), y), low);
  const Mask inside = hn::And(hn::Ge(y, hn::Zero(Lanes())), hn::And(hn::Ge(x, low), hn::Le(x, high)));
  best.keep_closer(inside, dot(apart, apart), x, y, places);
}

Candidate closest_of(const WideTriangle& a, const WideTriangle& b) {
  const Float zero = hn::Zero(Lanes());
  Candidate best{constant(3e38f), zero, zero, zero};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) compare_sides(best, a, i, b, j);
  for (int k = 0; k < 3; ++k) compare_corner(best, a.face, b.corner[k], 4 * kFace + k);
  for (int k = 0; k < 3; ++k) compare_corner(best, b.face, a.corner[k], 4 * k + kFace);
  return best;
}

struct Witness {
  Float3 point;
  Int place;
};

Mask is(Int value, int other) {
  return hn::RebindMask(Lanes(), hn::Eq(value, hn::Set(Ints(), other)));
}

// `parameter` is along a side; x and y are on the face.
Witness witness_on(const WideTriangle& triangle, Int place, Float parameter, Float x, Float y) {
  const Mask second = is(place, 1), third = is(place, 2), on_face = is(place, kFace);
  const auto of_side = [&](const Float3(&of)[3]) {
    return select(third, of[2], select(second, of[1], of[0]));
  };
  const Float3 on_side = of_side(triangle.corner) + of_side(triangle.along) * parameter;
  const Float3 in_face = triangle.face.corner + triangle.face.base * x + triangle.face.height * y;

  const auto integer = [](int k) { return hn::Set(Ints(), k); };
  const auto to_ints = [](Mask mask) { return hn::RebindMask(Ints(), mask); };
  const Int next = hn::IfThenElse(to_ints(third), integer(0), hn::Add(place, integer(1)));
  const Int inner =
      hn::IfThenElse(to_ints(hn::Gt(parameter, hn::Zero(Lanes()))), hn::Add(place, integer(3)), place);
  const Int code = hn::IfThenElse(to_ints(hn::Ge(parameter, constant(1.0f))), next, inner);
  return {select(on_face, in_face, on_side),
          hn::IfThenElse(to_ints(on_face), integer(TrianglePlace::kFace), code)};
}

void store(const Float3& point, TriangleBatch::Row<float> (&rows)[3], std::size_t first) {
  hn::Store(point.x, Lanes(), rows[0].data() + first);
  hn::Store(point.y, Lanes(), rows[1].data() + first);
  hn::Store(point.z, Lanes(), rows[2].data() + first);
}

void measure_lanes(const TriangleBatch& batch, std::size_t first, TriangleBatch::Closest& closest) {
  const WideTriangle a = triangle_at(batch.first, first), b = triangle_at(batch.second, first);
  const Candidate best = closest_of(a, b);
  const Int places = hn::ConvertTo(Ints(), best.places);
  const Int place_a = hn::ShiftRight<2>(places), place_b = hn::And(places, hn::Set(Ints(), 3));
  const Float zero = hn::Zero(Lanes());
  const Witness on_a =
      witness_on(a, place_a, hn::IfThenElse(is(place_b, kFace), zero, best.s), best.s, best.t);
  const Witness on_b =
      witness_on(b, place_b, hn::IfThenElse(is(place_a, kFace), zero, best.t), best.s, best.t);

  Float size = largest(a.corner[0]);
  for (int k = 1; k < 3; ++k) size = hn::Max(size, largest(a.corner[k]));
  for (int k = 0; k < 3; ++k) size = hn::Max(size, largest(b.corner[k]));
  const Float least = hn::Sub(hn::Sqrt(best.squared), hn::Mul(size, constant(TriangleBatch::kRounding)));

  hn::Store(best.squared, Lanes(), closest.squared_distance.data() + first);
  hn::Store(hn::IfThenElseZero(hn::Gt(least, zero), least), Lanes(), closest.least_distance.data() + first);
  store(on_a.point, closest.on_first, first);
  store(on_b.point, closest.on_second, first);
  hn::Store(on_a.place, Ints(), closest.first_place.data() + first);
  hn::Store(on_b.place, Ints(), closest.second_place.data() + first);
}

void measure(const TriangleBatch& batch, std::size_t count, TriangleBatch::Closest& closest) {
  for (std::size_t first = 0; first < count; first += hn::Lanes(Lanes()))
    measure_lanes(batch, first, closest);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace palpate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace palpate {
namespace {

HWY_EXPORT(measure);

}  // namespace

void TriangleBatch::measure(std::size_t count, Closest& closest) const {
  HWY_DYNAMIC_DISPATCH(measure)(*this, count, closest);
}

}  // namespace palpate
#endif

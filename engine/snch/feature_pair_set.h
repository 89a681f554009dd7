#pragma once

#include <bit>
#include <cstdint>

#include "engine/kernel/triangle_pair.h"

namespace palpate {

// Some of the pairs of features that two triangles form, a bit each, and whether they touch, as one more.
// Corners, sides and triangles are numbered as in TestedTriangle.
class FeaturePairSet {
 public:
  static constexpr int kCount = 50;
  static constexpr int kFaces = 48;
  static constexpr int kContact = 49;

  static constexpr int corner_and_face(bool corner_is_of_b, int k) { return 3 * corner_is_of_b + k; }
  static constexpr int edge_and_face(bool edge_is_of_b, int j) { return 6 + 3 * edge_is_of_b + j; }
  static constexpr int corner_and_edge(bool corner_is_of_b, int k, int j) {
    return 12 + 9 * corner_is_of_b + 3 * k + j;
  }
  static constexpr int edges(int i, int j) { return 30 + 3 * i + j; }
  static constexpr int corners(int i, int j) { return 39 + 3 * i + j; }

  static constexpr FeaturePairSet all() { return FeaturePairSet{(std::uint64_t{1} << kCount) - 1}; }

  // Those of one place of the triangle of A, or of B; contact is that of faces.
  static FeaturePairSet of(bool is_of_b, TrianglePlace place) {
    FeaturePairSet pairs;
    if (place.is_corner()) {
      const int k = place.code;
      pairs.add(corner_and_face(is_of_b, k));
      for (int other = 0; other < 3; ++other) {
        pairs.add(corner_and_edge(is_of_b, k, other));
        pairs.add(is_of_b ? corners(other, k) : corners(k, other));
      }
    } else if (place.is_side()) {
      const int j = place.side();
      pairs.add(edge_and_face(is_of_b, j));
      for (int other = 0; other < 3; ++other) {
        pairs.add(corner_and_edge(!is_of_b, other, j));
        pairs.add(is_of_b ? edges(other, j) : edges(j, other));
      }
    } else {
      pairs.add(kFaces);
      pairs.add(kContact);
      for (int other = 0; other < 3; ++other) {
        pairs.add(corner_and_face(!is_of_b, other));
        pairs.add(edge_and_face(!is_of_b, other));
      }
    }
    return pairs;
  }

  // The pair of a place of the triangle of A and one of the triangle of B.
  static FeaturePairSet of(TrianglePlace a, TrianglePlace b) {
    FeaturePairSet pair;
    if (a.is_corner())
      pair.add(b.is_corner() ? corners(a.code, b.code)
               : b.is_side() ? corner_and_edge(false, a.code, b.side())
                             : corner_and_face(false, a.code));
    else if (a.is_side())
      pair.add(b.is_corner() ? corner_and_edge(true, b.code, a.side())
               : b.is_side() ? edges(a.side(), b.side())
                             : edge_and_face(false, a.side()));
    else
      pair.add(b.is_corner() ? corner_and_face(true, b.code)
               : b.is_side() ? edge_and_face(true, b.side())
                             : kFaces);
    return pair;
  }

  constexpr FeaturePairSet() = default;

  bool empty() const { return bits_ == 0; }
  bool has(int pair) const { return (bits_ >> pair & 1) != 0; }
  void add(int pair) { bits_ |= std::uint64_t{1} << pair; }
  void add(FeaturePairSet pairs) { bits_ |= pairs.bits_; }

  // Any of `count` pairs from `first` on.
  bool has_any(int first, int count) const {
    return (bits_ >> first & ((std::uint64_t{1} << count) - 1)) != 0;
  }

  // Calls visit(pair) for each.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::uint64_t left = bits_; left != 0; left &= left - 1) visit(std::countr_zero(left));
  }

  friend bool operator==(const FeaturePairSet&, const FeaturePairSet&) = default;

 private:
  explicit constexpr FeaturePairSet(std::uint64_t bits) : bits_(bits) {}

  std::uint64_t bits_ = 0;
};

}  // namespace palpate

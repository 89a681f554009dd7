#pragma once

#include <cmath>

#include "engine/math/vector.h"

namespace palpate {

// The largest eigenvalue of a symmetric matrix, whose upper half is read. Based on Jacobi's rotations as in
// Golub & Van Loan, Matrix Computations, section 8.5: accurate to rounding, and unlike the closed form
// without trigonometric functions, in which machines differ.
inline double largest_eigenvalue(DMat3 m) {
  constexpr int kSweeps = 8;  // convergence is quadratic: five have always been enough
  constexpr int kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const auto [p, q] : kPairs) {
      const double off = m[q][p];
      if (off == 0.0) continue;
      const double theta = 0.5 * (m[q][q] - m[p][p]) / off;
      const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
      const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
      m[p][p] -= t * off;
      m[q][q] += t * off;
      m[q][p] = 0.0;
      const int r = 3 - p - q;
      double& rp = r < p ? m[p][r] : m[r][p];
      double& rq = r < q ? m[q][r] : m[r][q];
      const double old_rp = rp;
      rp = c * old_rp - s * rq;
      rq = s * old_rp + c * rq;
    }
  }
  return std::fmax(m[0][0], std::fmax(m[1][1], m[2][2]));
}

}  // namespace palpate

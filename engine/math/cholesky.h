#pragma once

#include <cmath>

#include "engine/math/vector.h"

namespace palpate {

// The x for which m x = b. `m` is symmetric and positive definite; its lower half is read. Based on
// Cholesky's factors as in Golub & Van Loan, Matrix Computations, section 4.2: stable without pivots.
inline DVec4 solve_symmetric(DMat4 m, DVec4 b) {
  constexpr int kSize = 4;
  for (int column = 0; column < kSize; ++column) {
    for (int k = 0; k < column; ++k)
      for (int row = column; row < kSize; ++row) m[column][row] -= m[k][row] * m[k][column];
    const double scale = 1.0 / std::sqrt(m[column][column]);
    for (int row = column; row < kSize; ++row) m[column][row] *= scale;
  }
  for (int row = 0; row < kSize; ++row) {
    for (int k = 0; k < row; ++k) b[row] -= m[k][row] * b[k];
    b[row] /= m[row][row];
  }
  for (int row = kSize - 1; row >= 0; --row) {
    for (int k = row + 1; k < kSize; ++k) b[row] -= m[row][k] * b[k];
    b[row] /= m[row][row];
  }
  return b;
}

}  // namespace palpate

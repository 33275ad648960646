// Eigenvalues and eigenvectors of a symmetric 3×3 matrix.
#pragma once

#include <sudar/math.h>

namespace sudar::inline SUDAR_PRECISION {

// The matrix is vectors · diagonal(values) · vectorsᵀ; `vectors` is a proper rotation (determinant +1).
struct Eigen3 {
  Vec3d values;
  Mat3d vectors;
};

// By Jacobi's rotations (1846), each by at most 45°: every axis stays the one nearest to it, so the order is that of
// the matrix's own axes, not of size. Off-diagonal elements up to `tolerance` · trace count as 0, for a positive
// matrix: what is diagonal but for rounding keeps its axes.
Eigen3 eigen_symmetric(const Mat3d& matrix, double tolerance = 1e-9);

}

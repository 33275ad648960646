#include "math/eigen.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Turns the axes p and q so that a[q][p] becomes 0 (Golub and Van Loan, Matrix Computations, 8.5.2).
void rotate_away(Mat3d& a, Mat3d& vectors, int p, int q) {
  const double apq = a[q][p];
  if (apq == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * apq);
  const double t = (theta < 0 ? -1 : 1) / (abs(theta) + sqrt(theta * theta + 1));  // tan of the angle, the smaller root
  const double c = 1 / sqrt(t * t + 1), s = t * c;
  Mat3d turn = Mat3d::identity();
  turn[p][p] = turn[q][q] = c;
  turn[q][p] = s;
  turn[p][q] = -s;
  a = transpose(turn) * a * turn;
  a[q][p] = a[p][q] = 0;
  vectors = vectors * turn;
}

}

Eigen3 eigen_symmetric(const Mat3d& matrix, double tolerance) {
  Mat3d a = (matrix + transpose(matrix)) * 0.5;
  const auto off_diagonal = [&] { return max(max(abs(a[1][0]), abs(a[2][0])), abs(a[2][1])); };
  Eigen3 result{{}, Mat3d::identity()};
  if (off_diagonal() > tolerance * abs(trace(a))) {
    // Converges quadratically: four or five sweeps in practice.
    for (int sweep = 0; sweep < 30 && off_diagonal() > 1e-300; ++sweep) {
      rotate_away(a, result.vectors, 0, 1);
      rotate_away(a, result.vectors, 0, 2);
      rotate_away(a, result.vectors, 1, 2);
    }
  }
  result.values = {a[0][0], a[1][1], a[2][2]};
  return result;
}

}

#include "BlockSolver.h"

#include <cmath>

namespace insonate::wire {
namespace {

/// Lower Cholesky factor of a block, in place; the part above the diagonal is not used. False on a pivot that is not
/// positive.
bool cholesky(Block& a) {
  for (int j = 0; j < 6; ++j) {
    double pivot = a(j, j);
    for (int k = 0; k < j; ++k) pivot -= a(j, k) * a(j, k);
    if (!(pivot > 0)) return false;
    const double root = std::sqrt(pivot);
    a(j, j) = root;
    for (int i = j + 1; i < 6; ++i) {
      double sum = a(i, j);
      for (int k = 0; k < j; ++k) sum -= a(i, k) * a(j, k);
      a(i, j) = sum / root;
    }
  }
  return true;
}

void forward(const Block& l, BlockVector& b) {
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < i; ++k) b(i) -= l(i, k) * b(k);
    b(i) /= l(i, i);
  }
}

void backward(const Block& l, BlockVector& b) {
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) b(i) -= l(k, i) * b(k);
    b(i) /= l(i, i);
  }
}

}  // namespace

bool BlockSolver::factorize(int count, const BlockVector& shift) {
  for (int i = 0; i < count; ++i) {
    Block a = diagonal[i];
    a.diagonal() += shift;
    if (i > 0) {
      // left = beside^T L^-T: row by row, L x = column of `beside`.
      for (int row = 0; row < 6; ++row) {
        BlockVector x = beside[i - 1].col(row);
        forward(lower_[i - 1], x);
        left_[i].row(row) = x.transpose();
      }
      a.noalias() -= left_[i] * left_[i].transpose();
    }
    if (!cholesky(a)) return false;
    lower_[i] = a;
  }
  return true;
}

void BlockSolver::solve(int count, std::vector<BlockVector>& right) const {
  for (int i = 0; i < count; ++i) {
    if (i > 0) right[i].noalias() -= left_[i] * right[i - 1];
    forward(lower_[i], right[i]);
  }
  for (int i = count - 1; i >= 0; --i) {
    if (i + 1 < count) right[i].noalias() -= left_[i + 1].transpose() * right[i + 1];
    backward(lower_[i], right[i]);
  }
}

}  // namespace insonate::wire

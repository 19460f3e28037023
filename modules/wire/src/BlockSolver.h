#pragma once

#include <Eigen/Core>
#include <vector>

namespace insonate::wire {

using Block = Eigen::Matrix<double, 6, 6>;
using BlockVector = Eigen::Matrix<double, 6, 1>;

/// Symmetric block-tridiagonal equations, solved by a block Cholesky factorization in linear time.
class BlockSolver {
 public:
  explicit BlockSolver(int maxBlocks) : diagonal(maxBlocks), beside(maxBlocks), lower_(maxBlocks), left_(maxBlocks) {}

  std::vector<Block> diagonal, beside;  ///< beside[i] couples row i with column i + 1

  /// Factorizes the first `count` blocks, with `shift` added to the diagonal. False if the matrix is not positive
  /// definite.
  bool factorize(int count, const BlockVector& shift);
  /// Solves for a right side, in place. Needs a factorization.
  void solve(int count, std::vector<BlockVector>& right) const;

 private:
  std::vector<Block> lower_;  ///< Cholesky factors of the diagonal blocks
  std::vector<Block> left_;   ///< left_[i] = beside[i-1]^T L[i-1]^-T
};

}  // namespace insonate::wire

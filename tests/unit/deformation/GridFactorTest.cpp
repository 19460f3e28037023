#include "elastic/GridFactor.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace insonate::elastic {
namespace {

/// A random matrix over a grid, and the same as Eigen has it: diagonally dominant, so positive definite; entries over
/// three decades, as moduli are.
struct Pair {
  GridMatrix grid;
  Eigen::MatrixXd dense;

  Pair(int columns, int rows, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    grid.resize(columns, rows);
    dense = Eigen::MatrixXd::Zero(2 * columns * rows, 2 * columns * rows);
    constexpr int kDi[] = {0, 1, -1, 0, 1}, kDj[] = {0, 0, 1, 1, 1};
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const int n = j * columns + i;
        const double scale = std::pow(10, 1.5 * uniform(random));
        for (int block = GridMatrix::East; block < GridMatrix::kBlocks; ++block) {
          const int i2 = i + kDi[block], j2 = j + kDj[block];
          if (i2 < 0 || i2 >= columns || j2 >= rows) continue;
          for (int k = 0; k < 4; ++k) {
            const auto value = static_cast<float>(scale * uniform(random));
            grid.value[GridMatrix::first(block) + k][n] = value;
            const int row = 2 * n + k / 2, column = 2 * (j2 * columns + i2) + k % 2;
            dense(row, column) = dense(column, row) = value;
          }
        }
        dense(2 * n, 2 * n + 1) = dense(2 * n + 1, 2 * n) = grid.value[1][n] = float(0.3 * scale * uniform(random));
      }
    for (int k = 0; k < dense.rows(); ++k) {
      const auto diagonal = static_cast<float>(1.05 * dense.row(k).cwiseAbs().sum() + 0.01);
      dense(k, k) = grid.value[k % 2 == 0 ? 0 : 2][k / 2] = diagonal;
    }
  }
};

TEST(GridFactor, SolvesAsEigenDoes) {
  constexpr int kSizes[][2] = {{2, 2}, {3, 7}, {5, 4}, {13, 9}, {31, 6}, {9, 33}, {24, 25}, {6, 5}};
  GridFactor factor;
  unsigned seed = 1;
  for (const auto& [columns, rows] : kSizes) {
    const Pair pair(columns, rows, seed++);
    const Eigen::VectorXd right = Eigen::VectorXd::Random(pair.dense.rows());
    const Eigen::VectorXd exact = pair.dense.llt().solve(right);
    std::vector<float> x(right.data(), right.data() + right.size());
    x.resize(x.size() + 2 * GridMatrix::kPadding);
    factor.prepare(columns, rows);
    std::vector<float> again = x;
    EXPECT_TRUE(factor.factor(pair.grid, x));
    factor.solve(again);
    for (const auto& solution : {x, again}) {
      double worst = 0;
      for (int k = 0; k < exact.size(); ++k) worst = std::max(worst, std::abs(solution[k] - exact[k]));
      EXPECT_LT(worst, 2e-5 * exact.cwiseAbs().maxCoeff()) << columns << " x " << rows;
    }
  }
}

TEST(GridFactor, SaysWhenAMatrixIsNotPositiveDefinite) {
  Pair pair(12, 11, 5);
  GridFactor factor;
  factor.prepare(12, 11);
  std::vector<float> x(2 * 12 * 11 + 2 * GridMatrix::kPadding);
  EXPECT_TRUE(factor.factor(pair.grid, x));
  pair.grid.value[2][70] *= -1;
  EXPECT_FALSE(factor.factor(pair.grid, x));
}

}  // namespace
}  // namespace insonate::elastic

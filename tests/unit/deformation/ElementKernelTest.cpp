#include "elastic/Elements.h"
#include "reference/Equations.h"

#include <gtest/gtest.h>

#include <random>

namespace insonate::elastic {
namespace {

/// Gradients of a displacement under which cells are pressed together, and with which lumens are stretched to their
/// limit.
const Eigen::Matrix2d kPressed{{1.2, 0.3}, {-0.2, 0.4}}, kStretched{{1.9, 0.3}, {-0.2, 1.4}};

/// A distorted grid of cells of all kinds, as the fast kernels have it and as the reference does.
class ElementKernel : public testing::Test {
 protected:
  static constexpr int kColumns = 37, kRows = 6;

  ElementKernel() {
    elements.resize(kColumns, kRows);
    rest.resize(kColumns * kRows);
    at.resize(kColumns * kRows);
    matrix.resize(kColumns, kRows);
    force.assign(2 * kColumns * kRows + 2 * GridMatrix::kPadding, 0);
    reference::Vector plain(2 * kColumns * kRows);
    for (int n = 0; n < kColumns * kRows; ++n) {
      plain[2 * n] = rest.x[n] = float(n % kColumns + off(0.25));
      plain[2 * n + 1] = rest.z[n] = float(0.7 * (n / kColumns) + off(0.17));
    }
    std::vector<double> mu, bulk;
    for (int j = 0; j + 1 < kRows; ++j)
      for (int i = 0; i + 1 < kColumns; ++i) {
        const int n = j * kColumns + i;
        mu.push_back(elements.mu[n] = float(std::pow(10, off(2))));
        bulk.push_back(elements.bulk[n] = elements.mu[n] * float(20 + off(15)));
      }
    shapeElements(rest, elements);
    body = reference::makeGrid(kColumns, kRows, plain, mu, bulk);
    for (reference::Cell& cell : body.cells) {
      const int n = cell.node[0];
      cell.initial = elements.base[n] = float(-cell.mu + off(1));
      cell.shut = elements.shut[n] = float(std::max(0.0, off(30)));
      cell.full = elements.full[n] = float(std::max(0.0, off(30)));
      cell.fullAbove = elements.fullAbove[n] = float(1.8 + off(0.6));
      tension.push_back(elements.carried[n] = float(off(5)));
    }
  }

  double off(double most) { return std::uniform_real_distribution<double>(-most, most)(random); }

  void move(double off_mm, const Eigen::Matrix2d& gradient) {
    moved = body.rest;
    for (int n = 0; n < kColumns * kRows; ++n) {
      moved.segment<2>(2 * n) = gradient * body.rest.segment<2>(2 * n) + Eigen::Vector2d(off(off_mm), off(off_mm));
      moved[2 * n] = at.x[n] = float(moved[2 * n]);
      moved[2 * n + 1] = at.z[n] = float(moved[2 * n + 1]);
    }
  }

  /// Entry of the fast kernel's matrix.
  double entry(int row, int column) const {
    const int a = row / 2, b = column / 2;
    if (a > b) return entry(column, row);
    if (a == b) return matrix.value[row % 2 + column % 2][a];
    constexpr int kDi[] = {0, 1, -1, 0, 1}, kDj[] = {0, 0, 1, 1, 1};
    for (int block = 1; block < GridMatrix::kBlocks; ++block)
      if (b == a + kDj[block] * kColumns + kDi[block])
        return matrix.value[GridMatrix::first(block) + 2 * (row % 2) + column % 2][a];
    return 0;
  }

  std::mt19937 random{11};
  Elements elements;
  Nodes rest, at;
  GridMatrix matrix;
  std::vector<float> force;
  reference::Body body;
  std::vector<double> tension;
  reference::Vector moved;
};

TEST_F(ElementKernel, ForcesAndTangentAreThoseOfPlainLoops) {
  for (const auto& [gradientOfMove, cautious] :
       {std::pair(kPressed, false), std::pair(kPressed, true), std::pair(kStretched, false)}) {
    move(0.2, gradientOfMove);
    for (auto& array : matrix.value) std::fill(array.begin(), array.end(), 0.0f);
    std::fill(force.begin(), force.end(), 0.0f);
    assemble(elements, at, cautious, matrix, force);
    const reference::Vector gradient = gradientOf(body, moved, {});
    double worst = 0;
    for (int k = 0; k < gradient.size(); ++k) worst = std::max(worst, std::abs(force[k] + gradient[k]));
    EXPECT_LT(worst, 3e-6 * gradient.cwiseAbs().maxCoeff());
    if (cautious) continue;  // its tangent is damped besides
    const auto entries = tangentOf(body, moved, {}, tension, 1e30);
    reference::Matrix sum(gradient.size(), gradient.size());
    sum.setFromTriplets(entries.begin(), entries.end());
    double largest = 0;
    worst = 0;
    for (int column = 0; column < sum.cols(); ++column)
      for (reference::Matrix::InnerIterator it(sum, column); it; ++it) {
        worst = std::max(worst, std::abs(entry(int(it.row()), column) - it.value()));
        largest = std::max(largest, std::abs(it.value()));
      }
    EXPECT_LT(worst, 3e-6 * largest);
  }
}

TEST_F(ElementKernel, ALinearDisplacementOfUniformTissueIsInBalance) {
  for (int n = 0; n < kColumns * (kRows - 1); ++n) {
    if (n % kColumns == kColumns - 1) continue;
    elements.mu[n] = 3, elements.bulk[n] = 150, elements.base[n] = -3, elements.shut[n] = 0;
  }
  shapeElements(rest, elements);
  move(0, Eigen::Matrix2d{{1.1, 0.2}, {-0.1, 0.8}});
  assemble(elements, at, false, matrix, force);
  for (int j = 1; j + 1 < kRows; ++j)
    for (int i = 1; i + 1 < kColumns; ++i)
      for (const int axis : {0, 1}) EXPECT_NEAR(force[2 * (j * kColumns + i) + axis], 0, 1e-3) << i << " " << j;
}

/// The reference's own loops: the gradient is that of the energy, the tangent that of the gradient.
TEST_F(ElementKernel, PlainLoopsAreDerivativesOfTheEnergy) {
  move(0.1, Eigen::Matrix2d{{1.1, 0.1}, {-0.1, 0.8}});
  body.struts = {{40, 40 + kColumns, 1, 2.0, 400}, {50, 51, 0, 2.0, 300}};
  for (std::size_t n = 0; n < tension.size(); ++n)
    tension[n] = reference::tensionOf(body.cells[n], {}, reference::areaOf(body.cells[n], moved)).value;
  reference::Vector direction(moved.size());
  for (double& d : direction) d = off(1);
  constexpr double h = 1e-6;
  const reference::Vector up = moved + h * direction, down = moved - h * direction;
  const reference::Vector gradient = gradientOf(body, moved, {});
  const double slope = (energyOf(body, up, {}) - energyOf(body, down, {})) / (2 * h);
  EXPECT_NEAR(gradient.dot(direction), slope, 1e-6 * std::abs(slope));
  const auto entries = tangentOf(body, moved, {}, tension, 1e30);
  reference::Matrix tangent(moved.size(), moved.size());
  tangent.setFromTriplets(entries.begin(), entries.end());
  const reference::Vector change = (gradientOf(body, up, {}) - gradientOf(body, down, {})) / (2 * h);
  EXPECT_LT((tangent * direction - change).norm(), 1e-6 * change.norm());
}

}  // namespace
}  // namespace insonate::elastic

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Small matrices of fixed size with plain loops. Eigen computes the same, but the compiler needs minutes for its
/// unrolled 6x6 and 12x12 products.
namespace insonate::camera {

template <int R, int C>
struct Matrix {
  std::array<double, std::size_t(R) * C> values{};

  double& operator()(int r, int c) { return values[std::size_t(r) * C + std::size_t(c)]; }
  double operator()(int r, int c) const { return values[std::size_t(r) * C + std::size_t(c)]; }
  double& operator[](int i) { return values[std::size_t(i)]; }
  double operator[](int i) const { return values[std::size_t(i)]; }

  Matrix& operator+=(const Matrix& other) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += other.values[i];
    return *this;
  }
  Matrix operator*(double s) const {
    Matrix m = *this;
    for (double& v : m.values) v *= s;
    return m;
  }
};

template <int N>
using Vector = Matrix<N, 1>;

template <int R, int K, int C>
Matrix<R, C> operator*(const Matrix<R, K>& a, const Matrix<K, C>& b) {
  Matrix<R, C> m;
  for (int r = 0; r < R; ++r)
    for (int k = 0; k < K; ++k)
      for (int c = 0; c < C; ++c) m(r, c) += a(r, k) * b(k, c);
  return m;
}

template <int R, int C>
Matrix<C, R> transposed(const Matrix<R, C>& a) {
  Matrix<C, R> m;
  for (int r = 0; r < R; ++r)
    for (int c = 0; c < C; ++c) m(c, r) = a(r, c);
  return m;
}

template <int N>
Matrix<N, N> identity() {
  Matrix<N, N> m;
  for (int i = 0; i < N; ++i) m(i, i) = 1;
  return m;
}

/// Solves a x = b for `columns` right sides by Cholesky factorization. `a` (n x n, row by row, symmetric and positive
/// definite) and `b` (n x columns) are overwritten; `b` then contains x. Returns false if `a` is not positive definite.
inline bool solvePositive(double* a, double* b, int n, int columns) {
  for (int j = 0; j < n; ++j) {
    double pivot = a[j * n + j];
    for (int k = 0; k < j; ++k) pivot -= a[j * n + k] * a[j * n + k];
    if (!(pivot > 0) || !std::isfinite(pivot)) return false;
    const double root = std::sqrt(pivot);
    a[j * n + j] = root;
    for (int i = j + 1; i < n; ++i) {
      double sum = a[i * n + j];
      for (int k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      a[i * n + j] = sum / root;
    }
  }
  for (int c = 0; c < columns; ++c) {
    for (int i = 0; i < n; ++i) {
      double sum = b[i * columns + c];
      for (int k = 0; k < i; ++k) sum -= a[i * n + k] * b[k * columns + c];
      b[i * columns + c] = sum / a[i * n + i];
    }
    for (int i = n - 1; i >= 0; --i) {
      double sum = b[i * columns + c];
      for (int k = i + 1; k < n; ++k) sum -= a[k * n + i] * b[k * columns + c];
      b[i * columns + c] = sum / a[i * n + i];
    }
  }
  return true;
}

/// Solves a x = b; x is 0 if `a` is not positive definite.
template <int N, int C>
Matrix<N, C> solved(Matrix<N, N> a, Matrix<N, C> b) {
  if (!solvePositive(a.values.data(), b.values.data(), N, C)) return {};
  return b;
}

template <int N>
Matrix<N, N> inverted(const Matrix<N, N>& a) {
  return solved(a, identity<N>());
}

}  // namespace insonate::camera

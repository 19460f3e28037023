#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace insonate::test {

/// Mean structural similarity of two 8-bit images of equal size (Wang, Bovik, Sheikh, Simoncelli, IEEE Trans. Image
/// Process. 13(4), 2004), over 8 x 8 windows every 4 pixels; 1 for equal pictures.
inline double ssim(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int width, int height) {
  constexpr int kWindow = 8, kHop = 4;
  constexpr double kC1 = (0.01 * 255) * (0.01 * 255), kC2 = (0.03 * 255) * (0.03 * 255);
  double total = 0;
  int windows = 0;
  for (int y = 0; y + kWindow <= height; y += kHop)
    for (int x = 0; x + kWindow <= width; x += kHop) {
      double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
      for (int v = y; v < y + kWindow; ++v)
        for (int u = x; u < x + kWindow; ++u) {
          const double p = a[std::size_t(v) * width + u], q = b[std::size_t(v) * width + u];
          sa += p, sb += q, saa += p * p, sbb += q * q, sab += p * q;
        }
      constexpr double kN = kWindow * kWindow;
      const double ma = sa / kN, mb = sb / kN;
      const double va = saa / kN - ma * ma, vb = sbb / kN - mb * mb, cov = sab / kN - ma * mb;
      total += (2 * ma * mb + kC1) * (2 * cov + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
      ++windows;
    }
  return windows ? total / windows : 1;
}

}  // namespace insonate::test

// Vectors over rows, for the kernels of the display.
#if defined(INSONATE_DISPLAY_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_DISPLAY_ROWS_INL_H_
#undef INSONATE_DISPLAY_ROWS_INL_H_
#else
#define INSONATE_DISPLAY_ROWS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace insonate::display::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using I = hn::RebindToSigned<F>;
using U = hn::RebindToUnsigned<F>;

/// Calls body(i) for each vector of a row that may be read and written up to a multiple of 16 columns. Every vector is
/// computed completely, whatever the vector length of the processor.
template <class Body>
HWY_INLINE void overPadded(int columns, const Body& body) {
  const int lanes = static_cast<int>(hn::Lanes(F())), padded = (columns + 15) / 16 * 16;
  for (int i = 0; i < padded; i += lanes) body(i);
}

template <class V>
HWY_INLINE V mix(V a, V b, V share) {
  return hn::Add(a, hn::Mul(share, hn::Sub(b, a)));
}

}  // namespace insonate::display::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#include <insonate/views/HuHistogram.h>
#include <insonate/views/TransferFunction.h>

#include <algorithm>
#include <array>

namespace insonate::views {
namespace {

constexpr int kValues = 4096;
constexpr int kLeast = int(TransferFunction::kMin_HU);
/// Range that every CT has: air to dense bone.
constexpr double kAtLeastFrom_HU = -1000, kAtLeastTo_HU = 1500;
constexpr double kBrightestShare = 1e-5;
/// Voxels between two checks of `stop`.
constexpr std::size_t kPortion = 1 << 20;

}  // namespace

HuHistogram huHistogram(const CtVolume& ct, int bins, const std::atomic<bool>* stop) {
  std::array<std::uint64_t, kValues> fine{};
  const std::size_t count = ct.voxels.size();
  for (std::size_t first = 0; first < count; first += kPortion) {
    if (stop && *stop) return {};
    const std::size_t last = std::min(count, first + kPortion);
    for (std::size_t k = first; k < last; ++k) ++fine[std::size_t(std::clamp(ct.voxels[k] - kLeast, 0, kValues - 1))];
  }
  HuHistogram histogram;
  if (count == 0 || bins < 1) return histogram;

  int low = 0, high = kValues - 1;
  while (low < high && fine[std::size_t(low)] == 0) ++low;
  for (double above = 0; high > low; --high) {
    above += double(fine[std::size_t(high)]);
    if (above > kBrightestShare * double(count)) break;
  }
  histogram.min_HU = std::min<double>(low + kLeast, kAtLeastFrom_HU);
  histogram.max_HU = std::max<double>(high + 1 + kLeast, kAtLeastTo_HU);
  histogram.counts.assign(std::size_t(bins), 0);
  const double perBin = histogram.binWidth_HU();
  for (int value = 0; value < kValues; ++value) {
    const int bin = int((value + 0.5 + kLeast - histogram.min_HU) / perBin);
    if (bin >= 0 && bin < bins) histogram.counts[std::size_t(bin)] += fine[std::size_t(value)];
  }
  return histogram;
}

}  // namespace insonate::views

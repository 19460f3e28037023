#include <insonate/segmentation/HistogramThreshold.h>

#include <itkHistogram.h>
#include <itkOtsuThresholdCalculator.h>

#include <algorithm>
#include <cmath>

namespace insonate {

std::optional<std::size_t> otsuBin(std::span<const std::uint64_t> counts) {
  const auto isFilled = [](std::uint64_t count) { return count > 0; };
  if (std::ranges::count_if(counts, isFilled) < 2) return std::nullopt;
  using Histogram = itk::Statistics::Histogram<double>;
  auto histogram = Histogram::New();
  histogram->SetMeasurementVectorSize(1);
  Histogram::SizeType size(1);
  Histogram::MeasurementVectorType low(1), high(1);
  size.Fill(counts.size()), low.Fill(0), high.Fill(double(counts.size()));
  histogram->Initialize(size, low, high);
  for (std::size_t bin = 0; bin < counts.size(); ++bin) histogram->SetFrequency(bin, counts[bin]);
  auto otsu = itk::OtsuThresholdCalculator<Histogram, double>::New();
  otsu->SetInput(histogram);
  otsu->Update();
  // The filter returns the middle of the darker class's last bin.
  return std::min(std::size_t(std::floor(otsu->GetThreshold())) + 1, counts.size() - 1);
}

}  // namespace insonate

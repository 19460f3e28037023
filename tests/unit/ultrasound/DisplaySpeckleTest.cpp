#include "DisplaySupport.h"
#include "SpeckleFrame.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

/// The display's filters follow the beam. That of the speckle below: a pulse of 0.26 mm, 0.62 mm wide at the focus.
class DisplaySpeckle : public testing::Test {
 protected:
  Probe probe = [] {
    Probe p = *loadProbe("linear");
    p.bandwidth = 0.347, p.receiveFNumber = 1.73, p.transmitFNumber = 3.46, p.apodization = Apodization::Hann;
    return p;
  }();
  ImagingSettings settings = [this] {
    ImagingSettings s = settingsFor(probe);
    s.frequency_MHz = 7.5;
    s.effects.attenuation = s.effects.noise = s.effects.nearField = false;
    return s;
  }();
  BeamGrid grid{probe, settings};

  EnvelopeFrame speckle(double lateralFwhm_mm, unsigned seed) const {
    return test::speckleFrame(settings.scanlines, settings.samples, settings.looks, 0.26 / grid.step_mm(),
                              lateralFwhm_mm / grid.scanlineSpacing_mm(0), seed);
  }
};

/// The ranges measured on homogeneous patches (thyroid, plain deep tissue) of real neck pictures.
TEST_F(DisplaySpeckle, PlainTissueLooksLikeThatOfRealMachines) {
  for (const double lateralFwhm_mm : {0.62, 0.75}) {
    const auto grain = test::medianGrain(test::display(probe, settings, speckle(lateralFwhm_mm, 3)), 110);
    EXPECT_GT(grain.sd, 8) << "published 5 to 13.5, median 11.5";
    EXPECT_LT(grain.sd, 13.5);
    EXPECT_GT(grain.sd / grain.mean, 0.14) << "published 0.12 to 0.43, median 0.19";
    EXPECT_LT(grain.sd / grain.mean, 0.25);
    EXPECT_GT(grain.skewness, 0) << "published -0.15 to 0.57, median 0.28";
    EXPECT_LT(grain.skewness, 0.57);
    EXPECT_GT(grain.axialFwhm_mm, 0.30);
    EXPECT_LT(grain.axialFwhm_mm, 0.43);
    EXPECT_GT(grain.lateralFwhm_mm, 0.59);
    EXPECT_LT(grain.lateralFwhm_mm, 0.99);
  }
}

TEST_F(DisplaySpeckle, OneBareLookIsRayleigh) {
  settings = test::bareSettings(probe);
  const auto grain = test::medianGrain(test::display(probe, settings, speckle(0.62, 4)), 110);
  EXPECT_NEAR(grain.sd, 22, 1.5) << "5.57 dB is 23.7 grey levels, less what interpolation and nulls below black take";
  EXPECT_LT(grain.skewness, -0.6);
}

/// Distance over which a step's gray rises from 10 to 90 %, on the middle column.
double edgeWidth_mm(const BModeImage& image) {
  std::vector<double> profile;
  for (int row = 0; row < image.height; ++row) {
    double sum = 0;
    for (int column = image.width / 2 - 20; column < image.width / 2 + 20; ++column)
      sum += image.gray[std::size_t(row) * image.width + column];
    profile.push_back(sum);
  }
  const double low = profile[profile.size() / 4], high = profile[profile.size() * 3 / 4];
  const auto crossing = [&](double share) {
    const double level = low + share * (high - low);
    for (std::size_t i = profile.size() / 4; i + 1 < profile.size(); ++i)
      if (profile[i] < level && profile[i + 1] >= level)
        return double(i) + (level - profile[i]) / (profile[i + 1] - profile[i]);
    return std::nan("");
  };
  return (crossing(0.9) - crossing(0.1)) * image.pixel_mm;
}

TEST_F(DisplaySpeckle, SmoothingKeepsAnInterfaceSharp) {
  settings.grayMap = GrayMap::Linear;
  EnvelopeFrame frame = speckle(0.62, 5);
  for (int look = 0; look < frame.looks; ++look)
    for (int k = 0; k < frame.samples; ++k) {
      const double level_dB = 20 / (1 + std::exp(-(grid.range_mm(k) - 20) / 0.05));
      for (int l = 0; l < frame.scanlines; ++l)
        frame.look(look)[std::size_t(k) * frame.scanlines + l] *= static_cast<float>(std::pow(10, level_dB / 20));
    }
  const double smoothed_mm = edgeWidth_mm(test::display(probe, settings, frame));
  settings.speckleReduction = 0;
  const double bare_mm = edgeWidth_mm(test::display(probe, settings, frame));
  EXPECT_LT(smoothed_mm, bare_mm + 0.12) << "less than a third of the grain";
}

/// Mean absolute gray difference between pixels at a distance along and across a direction.
double variationAlong(const BModeImage& image, double slope, double step_mm) {
  double sum = 0;
  int count = 0;
  for (double x = -10; x <= 8; x += 0.2) {
    const double z = 20 + slope * x;
    sum += std::abs(test::grayAt(image, x, z) - test::grayAt(image, x + step_mm, z + slope * step_mm));
    ++count;
  }
  return sum / count;
}

TEST_F(DisplaySpeckle, GrainIsStretchedAlongAnInterface) {
  settings.grayMap = GrayMap::Linear;
  for (const double slope : {0.0, 0.3, -0.3}) {
    EnvelopeFrame frame = speckle(0.62, 6);
    for (int look = 0; look < frame.looks; ++look)
      for (int k = 0; k < frame.samples; ++k)
        for (int l = 0; l < frame.scanlines; ++l) {
          const double off_mm = grid.range_mm(k) - (20 + slope * grid.origin(l).x);
          const double level_dB = 20 * std::exp(-0.5 * off_mm * off_mm / (0.25 * 0.25));
          frame.look(look)[std::size_t(k) * frame.scanlines + l] *= static_cast<float>(std::pow(10, level_dB / 20));
        }
    settings.speckleReduction = 1;
    const double smoothed = variationAlong(test::display(probe, settings, frame), slope, 0.4);
    settings.speckleReduction = 0;
    const double bare = variationAlong(test::display(probe, settings, frame), slope, 0.4);
    EXPECT_LT(smoothed, 0.6 * bare) << "slope " << slope;
  }
}

}  // namespace
}  // namespace insonate

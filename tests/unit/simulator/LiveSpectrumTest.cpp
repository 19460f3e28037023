#include "LiveProbe.h"

#include <insonate/simulator/MovingBlood.h>

#include <algorithm>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::Live;

/// The case with named veins, so that blood flows.
std::shared_ptr<const PatientCase> flowingCase() {
  auto patient = std::make_shared<PatientCase>(*test::wideCase());
  NamedVessel vein;
  vein.name = "right internal jugular vein", vein.label = kVein;
  for (const double z_mm : {-20.0, 0.0, 19.0}) vein.course.push_back({{0, 12, z_mm}, 5});
  patient->manifest.vessels.push_back(vein);
  return patient;
}

SpectralSettings gateInVein() {
  SpectralSettings gate;
  gate.range_mm = 12;
  // The vein is perpendicular to the beam.
  gate.wallFilter_Hz = 0;
  return gate;
}

bool hasSpectra(Live& live) {
  std::vector<LiveSpectrum> spectra;
  live->takeSpectra(spectra);
  return !spectra.empty();
}

/// Spectra of half a second or more.
std::vector<LiveSpectrum> someSpectra(LiveImaging& live) {
  std::vector<LiveSpectrum> all, taken;
  for (int i = 0; i < 200 && all.size() < 100; ++i) {
    std::this_thread::sleep_for(20ms);
    live.takeSpectra(taken);
    all.insert(all.end(), taken.begin(), taken.end());
  }
  return all;
}

TEST(LiveSpectrum, SpectraComeAtEqualStepsAlsoWithoutNewImages) {
  Live live(test::poseAt(0), test::smallSetup(), {}, flowingCase());
  live.frameAt(test::poseAt(0));
  live.settle();
  EXPECT_FALSE(hasSpectra(live)) << "nothing is computed without a gate";
  live->setGate(gateInVein());
  const std::vector<LiveSpectrum> spectra = someSpectra(*live.operator->());
  ASSERT_GE(spectra.size(), 100U);
  for (std::size_t i = 1; i < spectra.size(); ++i)
    EXPECT_NEAR(spectra[i].time_s - spectra[i - 1].time_s, kSpectrumStep_s, 1e-9);
  EXPECT_EQ(spectra.front().power.size(), std::size_t(kSpectrumBins));
  EXPECT_GT(std::ranges::max(spectra.back().power), 1) << "the gate receives echoes";
  live->setGate({});
  EXPECT_FALSE(hasSpectra(live));
}

TEST(LiveSpectrum, NoSpectraWhileFrozenOrPaused) {
  Live live(test::poseAt(0), test::smallSetup(), {}, flowingCase());
  live.frameAt(test::poseAt(0));
  live->setGate(gateInVein());
  ASSERT_FALSE(someSpectra(*live.operator->()).empty());
  live->setFrozen(true);
  std::this_thread::sleep_for(50ms);
  hasSpectra(live);
  std::this_thread::sleep_for(100ms);
  EXPECT_FALSE(hasSpectra(live));
  live->setFrozen(false);
  EXPECT_FALSE(someSpectra(*live.operator->()).empty());
  live->setPaused(true);
  std::this_thread::sleep_for(50ms);
  hasSpectra(live);
  std::this_thread::sleep_for(100ms);
  EXPECT_FALSE(hasSpectra(live));
}

TEST(LiveSpectrum, AGateThatTheImageDoesNotReachHasNoEchoes) {
  Live live(test::poseAt(0), test::smallSetup(), {}, flowingCase());
  live.frameAt(test::poseAt(0));
  SpectralSettings gate = gateInVein();
  gate.range_mm = 80;
  live->setGate(gate);
  const std::vector<LiveSpectrum> spectra = someSpectra(*live.operator->());
  ASSERT_FALSE(spectra.empty());
  EXPECT_EQ(std::ranges::max(spectra.back().power), 0);
}

}  // namespace
}  // namespace insonate

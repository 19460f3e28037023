#include "LiveProbe.h"
#include "live/SpectrumThread.h"
#include "support/Allocations.h"

#include <filesystem>
#include <iterator>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using live::GateMoment;
using live::SpectrumThread;

std::ptrdiff_t threads() {
  using Entries = std::filesystem::directory_iterator;
  return std::distance(Entries("/proc/self/task"), Entries());
}

/// A vein across the middle of the image, whose blood flows toward the steered gate.
class Spectra : public testing::Test {
 protected:
  Spectra() {
    vein_.name = "right internal jugular vein", vein_.label = kVein;
    for (int x_mm = -20; x_mm <= 20; x_mm += 2) vein_.course.push_back({{double(x_mm), 12, 0}, 5});
    auto patient = std::make_shared<PatientCase>(*test::wideCase());
    for (int k = 0; k < patient->labels.geometry.size[2]; ++k)
      for (int j = 12; j < patient->labels.geometry.size[1]; ++j)
        for (int i = 0; i < patient->labels.geometry.size[0]; ++i)
          patient->labels.at(i, j, k) = std::hypot(j - 22, k - 20) < 5 ? kVein : kSoftTissue;
    ImagingSetup setup = test::smallSetup();
    setup.settings.conformingContact = false;  // the gate stays in the middle of the vein
    setup_ = std::make_shared<const ImagingSetup>(std::move(setup));
    scene_ = *makeScene(*patient, *setup_, regionOf(setup_->probe, setup_->settings, test::poseAt(0)));
    gate_.range_mm = 12, gate_.steering_deg = 20, gate_.wallFilter_Hz = 20;
    still_.heartRate_perMin = still_.breathing_perMin = 0;
  }

  /// The state at an image in which the vein has this part of its height.
  GateMoment momentOf(double height, double time_s) const {
    PlaneDisplacement d{-25, 0, 0.5, 101, 71, {}};
    for (int row = 0; row < d.rows; ++row)
      for (int column = 0; column < d.columns; ++column)
        d.restFromDisplayed.push_back({0, float((0.5 * row - 12) * (1 / height - 1))});
    GateMoment moment;
    moment.scene = scene_, moment.setup = setup_, moment.patientFromProbe = test::poseAt(0);
    moment.displacement = std::make_shared<const PlaneDisplacement>(std::move(d));
    moment.physiology = still_, moment.time_s = time_s, moment.interval_s = 0.03;
    return moment;
  }
  /// Lets time pass until there are spectra of it, and returns their velocity.
  double velocityAfter(SpectrumThread& thread, double seconds) {
    now_s_ = now_s_ + seconds;
    const double expected_s = std::floor(now_s_ / kSpectrumStep_s) * kSpectrumStep_s - 1e-9;
    double velocity_mmps = NAN;
    for (int i = 0; i < 1000; ++i) {
      thread.take(spectra_);
      if (!spectra_.empty()) velocity_mmps = velocitiesOf(spectra_.back().power, gate_).mean_mmps;
      if (!spectra_.empty() && spectra_.back().time_s >= expected_s) break;
      std::this_thread::sleep_for(5ms);
    }
    return velocity_mmps;
  }

  NamedVessel vein_;
  std::shared_ptr<const ImagingSetup> setup_;
  std::shared_ptr<const AcousticScene> scene_;
  SpectralSettings gate_;
  Physiology still_;
  std::atomic<double> now_s_ = 1;
  std::vector<LiveSpectrum> spectra_;
};

TEST_F(Spectra, TheThreadBeginsWithTheFirstGate) {
  const auto before = threads();
  SpectrumThread thread({&vein_, 1}, nullptr, [this] { return now_s_.load(); });
  thread.setGate({});
  EXPECT_EQ(threads(), before);
  thread.setGate(gate_);
  EXPECT_EQ(threads(), before + 1);
}

/// A vein that was compressed while PW Doppler was off has no burst of expelled blood afterwards.
TEST_F(Spectra, WhatHappenedWithoutAGateIsNotShown) {
  SpectrumThread thread({&vein_, 1}, nullptr, [this] { return now_s_.load(); });
  const auto settled = [&](double height) {
    double velocity_mmps = 0;
    for (int image = 0; image < 25; ++image) {
      thread.show(momentOf(height, now_s_));
      velocity_mmps = velocityAfter(thread, 0.03);
    }
    return velocity_mmps;
  };
  thread.setGate(gate_);
  const double open_mmps = settled(1);
  EXPECT_GT(std::abs(open_mmps), 10);
  const double narrowed_mmps = settled(0.7);
  EXPECT_GT(std::abs(narrowed_mmps), 1.2 * std::abs(open_mmps)) << "a narrower vein is faster";
  settled(1);
  for (const bool seen : {false, true}) {
    thread.setGate({});
    if (seen) std::this_thread::sleep_for(100ms);
    now_s_ = now_s_ + 5;
    thread.setGate(gate_);
    thread.show(momentOf(0.7, now_s_));
    EXPECT_NEAR(velocityAfter(thread, 0.03), narrowed_mmps, 0.05 * std::abs(narrowed_mmps)) << seen;
    settled(1);
  }
}

TEST_F(Spectra, NoMemoryIsAllocatedForASpectrum) {
  SpectrumThread thread({&vein_, 1}, nullptr, [this] { return now_s_.load(); });
  thread.setGate(gate_);
  thread.show(momentOf(1, now_s_));
  for (int i = 0; i < 5; ++i) velocityAfter(thread, 0.24);
  const long before = test::allocations();
  for (int i = 0; i < 10; ++i) velocityAfter(thread, 0.1);
  EXPECT_EQ(test::allocations(), before);
}

TEST_F(Spectra, TheOldestSpectraAreDroppedIfTheyAreNotTaken) {
  SpectrumThread thread({&vein_, 1}, nullptr, [this] { return now_s_.load(); });
  thread.setGate(gate_);
  thread.show(momentOf(1, now_s_));
  for (int i = 0; i < 15; ++i) {
    now_s_ = now_s_ + 0.2;
    std::this_thread::sleep_for(40ms);
  }
  velocityAfter(thread, 0.1);
  EXPECT_LE(spectra_.size(), 400U);
  for (std::size_t i = 1; i < spectra_.size(); ++i) EXPECT_LT(spectra_[i - 1].time_s, spectra_[i].time_s);
}

}  // namespace
}  // namespace insonate

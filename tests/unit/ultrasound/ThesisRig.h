#pragma once

#include "support/LabelPhantom.h"

#include <insonate/ultrasound/Engine.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace insonate::test {

/// Every tissue alike: 1.6 MRayl, nothing absorbed, 0 dB.
inline AcousticTable plainTissues() {
  AcousticTable table;
  for (AcousticTissue& tissue : table.tissues) tissue.attenuation_dBpcmMHz = 0;
  return table;
}

/// Thesis look without any effect, the face where the pose says.
inline ImagingSettings thesisSettings(const Probe& probe, int scanlines = 64, int samples = 800) {
  ImagingSettings settings = settingsFor(probe);
  settings.look = Look::Thesis;
  settings.scanlines = scanlines, settings.samples = samples, settings.elevationPlanes = 1;
  settings.conformingContact = false;
  settings.effects = Effects::none();
  return settings;
}

inline std::shared_ptr<const AcousticScene> thesisScene(const LabelPhantom& phantom, const AcousticTable& table) {
  const Region all{{-200, -200, -200}, {200, 200, 200}};
  return *AcousticScene::make(phantom.ct, phantom.labels, table, all);
}

inline EnvelopeFrame thesisFrame(const std::string& engineName, const Probe& probe, const ImagingSettings& settings,
                                 const AcousticScene& scene, const Transform& patientFromProbe = {}) {
  const auto engine = *makeEngine(engineName);
  EnvelopeFrame frame;
  engine->prepare(probe, settings);
  engine->render(scene, patientFromProbe, frame);
  return frame;
}

/// The middle scanline, one value a sample.
inline std::vector<double> middleLine(const EnvelopeFrame& frame) {
  std::vector<double> line(frame.samples);
  for (int m = 0; m < frame.samples; ++m)
    line[m] = frame.amplitude[std::size_t(m) * frame.scanlines + frame.scanlines / 2];
  return line;
}

/// RMS of the difference over the RMS of the truth.
inline double frameError(const EnvelopeFrame& frame, const EnvelopeFrame& truth) {
  double difference = 0, power = 0;
  for (std::size_t i = 0; i < truth.amplitude.size(); ++i) {
    difference += std::pow(double(frame.amplitude[i]) - truth.amplitude[i], 2);
    power += std::pow(double(truth.amplitude[i]), 2);
  }
  return std::sqrt(difference / power);
}

inline double decibel(double amplitude) {
  return 20 * std::log10(amplitude);
}

inline std::string thesisEngineName(const testing::TestParamInfo<std::string>& engine) {
  return engine.param;
}

class ThesisEngines : public testing::TestWithParam<std::string> {
 protected:
  /// Skips where this machine has not what the engine needs, such as OpenGL.
  void SetUp() override {
    if (auto engine = makeEngine(GetParam()); !engine) GTEST_SKIP() << engine.error().message;
  }
  const Probe probe = *loadProbe("linear");
};

}  // namespace insonate::test

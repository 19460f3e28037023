#include "FlowTable.h"

#include <insonate/embedded/flow.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

using Json = nlohmann::json;

/// Periodic cubic through the points (phase, flow), whose slope at a point is that between its neighbors.
double flowAt(const std::vector<double>& phase, const std::vector<double>& flow, double at) {
  const auto count = static_cast<int>(phase.size());
  const auto x = [&](int i) { return phase[(i + count) % count] + std::floor(double(i) / count); };
  const auto y = [&](int i) { return flow[(i + count) % count]; };
  const auto after = static_cast<int>(std::upper_bound(phase.begin(), phase.end(), at) - phase.begin());
  const int i = after - 1;
  const auto slope = [&](int k) { return (y(k + 1) - y(k - 1)) / (x(k + 1) - x(k - 1)); };
  const double width = x(i + 1) - x(i), t = (at - x(i)) / width;
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * y(i) + (t3 - 2 * t2 + t) * width * slope(i) + (3 * t2 - 2 * t3) * y(i + 1) +
         (t3 - t2) * width * slope(i + 1);
}

Waveform waveformOf(const Json& json) {
  constexpr int kSteps = 720;
  const std::vector<double> phase = json.at("phase"), flow = json.at("flow");
  Waveform wave{json.at("name"), std::vector<std::complex<double>>(Waveform::kHarmonics)};
  double mean = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double at = (step + 0.5) / kSteps, value = flowAt(phase, flow, at) / kSteps;
    mean += value;
    for (int n = 1; n <= Waveform::kHarmonics; ++n)
      wave.harmonic[n - 1] += 2 * value * std::polar(1.0, -2 * std::numbers::pi * n * at);
  }
  for (std::complex<double>& c : wave.harmonic) c /= mean;
  wave.breathing = json.value("breathing", 1.0);
  return wave;
}

FlowTable tableOf(const Json& json) {
  FlowTable table;
  for (const Json& wave : json.at("waveforms")) table.waveforms.push_back(waveformOf(wave));
  const auto waveform = [&](const std::string& name) {
    return static_cast<int>(std::ranges::find(table.waveforms, name, &Waveform::name) - table.waveforms.begin());
  };
  constexpr double kMm3psPerMlpm = 1000.0 / 60;
  for (const Json& vessel : json.at("vessels"))
    table.vessels.push_back({vessel.at("vessel"), vessel.at("flow_mlPerMin").get<double>() * kMm3psPerMlpm,
                             waveform(vessel.at("waveform"))});
  table.arteryShear_perS = json.at("shearRate_perS").at("artery").at("value");
  table.veinShear_perS = json.at("shearRate_perS").at("vein").at("value");
  table.arteryWaveform = waveform(json.at("otherWaveforms").at("artery"));
  table.veinWaveform = waveform(json.at("otherWaveforms").at("vein"));
  table.breathing_permmHg = json.at("breathing").at("value");
  return table;
}

}  // namespace

const FlowTable& adultFlowTable() {
  static const FlowTable table = tableOf(Json::parse(embedded::flow::files().front().text));
  return table;
}

}  // namespace insonate

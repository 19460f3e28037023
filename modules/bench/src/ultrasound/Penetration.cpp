#include <insonate/bench/UltrasoundBench.h>
#include <insonate/ultrasound/Machine.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kShownRange_dB = 120;  ///< range of the gray values; 0.5 dB a gray
constexpr int kSeeds = 3;

/// Effects that determine how far echoes and noise differ.
ImagingSettings bareSettings(ImagingSettings settings, double depth_mm) {
  settings.depth_mm = depth_mm;
  settings.samples = 2000, settings.scanlines = 128, settings.elevationPlanes = 1;
  settings.width = 400, settings.height = 800;
  settings.looks = settings.compoundingAngles = 1;
  settings.gain_dB = settings.speckleReduction = settings.edgeEnhancement = settings.persistence = 0;
  settings.tgc_dB = settings.lateralGain_dB = {};
  settings.dynamicRange_dB = kShownRange_dB, settings.grayMap = GrayMap::Linear;
  settings.conformingContact = false;
  settings.effects = Effects::none();
  settings.effects.scattering = settings.effects.speckle = settings.effects.attenuation = true;
  settings.effects.beam = settings.effects.noise = true;
  return settings;
}

/// A phantom of one tissue, whose attenuation the built-in TGC compensates.
Result<std::shared_ptr<const AcousticScene>> evenPhantom(const Probe& probe, const ImagingSettings& settings) {
  constexpr double kSpacing_mm = 8;
  AcousticTable table;
  for (AcousticTissue& tissue : table.tissues) tissue.attenuation_dBpcmMHz = kTgc_dBpcmMHz / 2;  // one way
  const Region region = regionOf(probe, settings, {});
  CtVolume ct;
  for (int a = 0; a < 3; ++a) {
    ct.geometry.size[a] = int((region.high_mm[a] - region.low_mm[a]) / kSpacing_mm) + 6;
    ct.geometry.spacing_mm[a] = kSpacing_mm;
    ct.geometry.origin_mm[a] = region.low_mm[a] - 2 * kSpacing_mm;
  }
  LabelMap labels;
  labels.geometry = ct.geometry;
  ct.voxels.assign(ct.geometry.voxelCount(), 0);
  labels.voxels.assign(ct.geometry.voxelCount(), kSoftTissue);
  return AcousticScene::make(ct, labels, table, region);
}

/// Ratio of the power of echoes to that of noise, by range in steps of 1 mm, over all scanlines. A gray value is a
/// logarithm, whose mean lies 2.5 dB below that of the power both with echoes and without: the difference of the means
/// is that of the levels.
Result<std::vector<double>> echoOverNoise(const Probe& probe, const ImagingSettings& settings) {
  const auto scene = evenPhantom(probe, settings);
  if (!scene) return tl::unexpected(scene.error());
  auto engine = makeEngine("cpu");
  if (!engine) return tl::unexpected(engine.error());
  (*engine)->prepare(probe, settings);
  EnvelopeFrame echoes;
  (*engine)->render(**scene, {}, echoes);
  EnvelopeFrame silence = echoes;
  std::ranges::fill(silence.amplitude, 0.0F);
  Display display(probe, settings);
  const BeamGrid grid(probe, settings);
  const auto rows = static_cast<std::size_t>(settings.depth_mm);
  std::vector<double> gray(rows), noiseGray(rows), count(rows);
  BModeImage image, noise;
  for (int seed = 0; seed < kSeeds; ++seed) {
    display.process(echoes, image, std::uint32_t(seed));
    display.process(silence, noise, std::uint32_t(seed + kSeeds));
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const auto place = grid.locate(image.left_mm + x * image.pixel_mm, image.top_mm + y * image.pixel_mm);
        const auto z = static_cast<std::size_t>(std::max(0.0, grid.range_mm(place.sample)));
        if (!place.inside || z >= rows) continue;
        const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
        gray[z] += image.gray[at], noiseGray[z] += noise.gray[at];
        ++count[z];
      }
  }
  std::vector<double> ratio(rows);
  for (std::size_t z = 0; z < ratio.size(); ++z) {
    const double level_dB = (gray[z] - noiseGray[z]) / std::max(1.0, count[z]) * kShownRange_dB / 255;
    ratio[z] = std::max(0.0, std::pow(10, level_dB / 10) - 1);
  }
  return ratio;
}

/// Mean over some millimeters, in which speckle averages out.
double around(const std::vector<double>& ratio, int z_mm) {
  constexpr int kReach_mm = 3;
  double sum = 0, count = 0;
  for (int z = std::max(0, z_mm - kReach_mm); z <= std::min(int(ratio.size()) - 1, z_mm + kReach_mm); ++z)
    sum += std::log(std::max(ratio[std::size_t(z)], 1e-3)), ++count;
  return std::exp(sum / count);
}

/// Deepest depth at which echoes are as strong as the noise; 0 if they never are.
double penetrationOf(const std::vector<double>& ratio) {
  for (int z = int(ratio.size()) - 1; z > 0; --z) {
    const double deeper = around(ratio, z), here = around(ratio, z - 1);
    // Cells are 1 mm deep; between their middles the logarithm of the ratio is taken as linear.
    if (here >= 1 && deeper < 1) return z - 0.5 + std::log(here) / std::log(here / deeper);
  }
  return 0;
}

/// Mean loss where both stand clear of the noise and the aperture is full.
double loss_dB(const std::vector<double>& without, const std::vector<double>& with) {
  constexpr double kClear = 4;
  double sum = 0, count = 0;
  for (int z = int(without.size()) / 10; z < int(without.size()); ++z)
    if (const double a = around(without, z), b = around(with, z); a > kClear && b > kClear)
      sum += 10 * std::log10(a / b), ++count;
  return count > 0 ? sum / count : std::nan("");
}

}  // namespace

Result<PenetrationRow> measurePenetration(const Probe& probe, const ImagingSettings& own) {
  PenetrationRow row{.machine = {}, .probe = probe.name, .frequency_MHz = own.frequency_MHz};
  row.expected_mm = -10 * own.noise_dB / (kTgc_dBpcmMHz * own.frequency_MHz);
  const double depth_mm = std::clamp(1.3 * row.expected_mm, probe.minDepth_mm, probe.maxDepth_mm);
  ImagingSettings settings = bareSettings(own, depth_mm);
  settings.harmonic = false;
  const auto without = echoOverNoise(probe, settings);
  if (!without) return tl::unexpected(without.error());
  settings.harmonic = true;
  const auto with = echoOverNoise(probe, settings);
  if (!with) return tl::unexpected(with.error());
  row.penetration_mm = penetrationOf(*without), row.harmonic_mm = penetrationOf(*with);
  row.loss_dB = loss_dB(*without, *with);
  return row;
}

Result<std::vector<PenetrationRow>> penetrationRows(const Progress& progress) {
  std::vector<PenetrationRow> rows;
  const double all = double(machines().size() * probePresetNames().size());
  for (const Machine& machine : machines())
    for (const std::string& name : probePresetNames()) {
      if (!report(progress, "measuring penetration", double(rows.size()) / all)) return fail(std::string(kCancelled));
      const auto probe = loadProbe(name);
      if (!probe) return tl::unexpected(probe.error());
      const auto settings = settingsOf(machine.name, *probe, settingsFor(*probe));
      if (!settings) return tl::unexpected(settings.error());
      auto row = measurePenetration(*probe, *settings);
      if (!row) return tl::unexpected(row.error());
      row->machine = machine.name;
      rows.push_back(std::move(*row));
    }
  return rows;
}

}  // namespace insonate

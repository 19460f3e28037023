#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <algorithm>
#include <cmath>

namespace insonate::test {
namespace {

class ConnectiveTissue : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(ConnectiveTissue);

/// Probe over the side of a neck, whose muscle fibers run along z: its image shows their cross-section, or their
/// length.
Transform acrossFibers() {
  return {{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}}, {}};
}
Transform alongFibers() {
  return {{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}, {}};
}

/// Bright places of an image: those 12 dB above its median.
struct BrightParts {
  double share = 0;                  ///< of the image
  double long_mm = 0, thick_mm = 0;  ///< lengths of their runs across scanlines and along them
};

/// Length of the runs of true values, in values: the mean over the values, so that specks count little.
template <class IsBright>
double runLength(int rows, int columns, const IsBright& isBright) {
  double values = 0, weighted = 0, run = 0;
  const auto close = [&] { values += run, weighted += run * run, run = 0; };
  for (int row = 0; row < rows; ++row, close())
    for (int column = 0; column < columns; ++column)
      if (isBright(row, column))
        ++run;
      else
        close();
  return values > 0 ? weighted / values : 0;
}

struct Bench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = speckleSettings(probe, 192, 900, 3);
  AcousticTable table = plainTable();

  Bench(Texture texture, double strength_dB) {
    settings.effects.texture = true;
    for (AcousticTissue& tissue : table.tissues) tissue.texture = texture, tissue.textureStrength_dB = strength_dB;
  }

  /// Autocorrelation of the level in dB at a distance across scanlines. Speckle reaches less than a millimeter, so that
  /// beyond it only structure is left.
  double correlationAcrossLines(const std::string& engine, const Transform& pose, double distance_mm) const {
    const ScenePtr scene = evenScene(probe, settings, table, pose);
    const EnvelopeFrame frame = renderWith(engine, probe, settings, *scene, pose);
    const int first = frame.samples / 8, lines = frame.scanlines;
    std::vector<double> level_dB = valuesIn(frame, {first, frame.samples - first, 0, lines});
    for (double& value : level_dB) value = 10 * std::log10(std::max(value, 1e-12));
    const double middle = mean(level_dB), deviation = standardDeviation(level_dB);
    const int shift = int(std::lround(distance_mm / BeamGrid(probe, settings).scanlineSpacing_mm(0)));
    double sum = 0;
    std::size_t pairs = 0;
    for (std::size_t n = 0; n + shift < level_dB.size(); ++n)
      if (int(n % lines) + shift < lines) sum += (level_dB[n] - middle) * (level_dB[n + shift] - middle), ++pairs;
    return sum / double(pairs) / (deviation * deviation);
  }

  BrightParts brightParts(const std::string& engine, const Transform& pose) const {
    const ScenePtr scene = evenScene(probe, settings, table, pose);
    const EnvelopeFrame frame = renderWith(engine, probe, settings, *scene, pose);
    const int first = frame.samples / 8, rows = frame.samples - 2 * first, lines = frame.scanlines;
    std::vector<double> values = valuesIn(frame, {first, first + rows, 0, lines});
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    const double bright = 4 * *middle;
    const auto at = [&](int row, int line) { return frame.look(0)[std::size_t(first + row) * lines + line] > bright; };
    const BeamGrid grid(probe, settings);
    BrightParts parts;
    for (int row = 0; row < rows; ++row)
      for (int line = 0; line < lines; ++line) parts.share += at(row, line);
    parts.share /= double(rows) * lines;
    parts.long_mm = runLength(rows, lines, at) * grid.scanlineSpacing_mm(0);
    parts.thick_mm = runLength(lines, rows, [&](int line, int row) { return at(row, line); }) * grid.step_mm();
    return parts;
  }
};

TEST_P(ConnectiveTissue, SpeckleAloneHasNoLines) {
  EXPECT_LT(Bench(Texture::None, 0).brightParts(GetParam(), acrossFibers()).share, 1e-3);
}

/// In short axis a muscle shows short thin bright lines, which cover little of it.
TEST_P(ConnectiveTissue, MuscleShowsSeptaAcrossItsFibers) {
  const BrightParts septa = Bench(Texture::Septa, 36).brightParts(GetParam(), acrossFibers());
  record("share of septa", septa.share);
  record("length of septa, mm", septa.long_mm);
  record("thickness of septa, mm", septa.thick_mm);
  EXPECT_GT(septa.share, 0.02);
  EXPECT_LT(septa.share, 0.12);
  EXPECT_GT(septa.long_mm, 0.8);
  EXPECT_LT(septa.thick_mm, 0.5);
}

TEST_P(ConnectiveTissue, SeptaAreLongerAlongTheFibers) {
  const Bench bench(Texture::Septa, 36);
  const double along = bench.correlationAcrossLines(GetParam(), alongFibers(), 6);
  const double across = bench.correlationAcrossLines(GetParam(), acrossFibers(), 6);
  record("correlation at 6 mm along the fibers", along);
  record("correlation at 6 mm across them", across);
  EXPECT_GT(along, 0.04);
  EXPECT_GT(along, 2 * across);
}

TEST_P(ConnectiveTissue, FatAndLooseTissueShowStrands) {
  for (const Texture texture : {Texture::Lobules, Texture::Sheets}) {
    const BrightParts strands = Bench(texture, 30).brightParts(GetParam(), acrossFibers());
    record("length of strands, mm", strands.long_mm);
    record("thickness of strands, mm", strands.thick_mm);
    EXPECT_GT(strands.share, 0.02);
    EXPECT_LT(strands.share, 0.15);
    EXPECT_GT(strands.long_mm, 1.8 * strands.thick_mm) << "speckle cuts each strand into pieces";
  }
}

/// Across a nerve, dark fascicles of half a millimeter lie in bright tissue: its image varies more than speckle.
TEST_P(ConnectiveTissue, ANerveIsAHoneycomb) {
  const auto variation = [&](Texture texture) {
    Bench bench(texture, 16);
    const ScenePtr scene = evenScene(bench.probe, bench.settings, bench.table, acrossFibers());
    const EnvelopeFrame frame = renderWith(GetParam(), bench.probe, bench.settings, *scene, acrossFibers());
    const std::vector<double> values = valuesIn(frame, {300, 600, 20, 170});
    return standardDeviation(values) / mean(values);
  };
  EXPECT_GT(variation(Texture::Bundles), 1.15 * variation(Texture::None));
}

}  // namespace
}  // namespace insonate::test

#include "pointspread/ArrayField.h"
#include "pointspread/Cysts.h"
#include "pointspread/Spread.h"

#include <insonate/bench/PointSpreadBench.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Engine.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate {
namespace {

using bench::ArrayField;
using bench::Spread;

constexpr std::array kDepths_mm{5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0};
constexpr double kAcross_mm = 6, kAlong_mm = 1.5, kSlice_mm = 4;  ///< either way
constexpr double kFromEnd_mm = 1.2;
constexpr double kSmall_mm = 4, kLarge_mm = 8, kAnechoic_dB = -150;

Spread emptySpread() {
  Spread spread;
  spread.z_mm = ArrayField::kStep_mm;
  const auto both = [](double reach_mm, double step_mm) { return 2 * int(std::lround(reach_mm / step_mm)) + 1; };
  spread.across = both(kAcross_mm, spread.x_mm), spread.along = both(kAlong_mm, spread.z_mm);
  spread.echo.resize(std::size_t(spread.across) * spread.along);
  spread.slice.resize(both(kSlice_mm, spread.y_mm));
  spread.endAcross.resize(both(kFromEnd_mm + kAcross_mm, spread.x_mm));
  return spread;
}

double peakOf(const std::vector<std::complex<double>>& echo) {
  double top = 0;
  for (const auto& value : echo) top = std::max(top, std::abs(value));
  return top;
}

double offsetOf(int index, std::size_t count, double step_mm) {
  return (index - int(count) / 2) * step_mm;
}

/// The field of the array. A point that is moved under a scanline replaces the scanline that is moved the other way.
Spread fieldSpread(const Probe& probe, const ImagingSettings& settings, double depth_mm) {
  Spread spread = emptySpread();
  const ArrayField middle(probe, settings, probe.width_mm / 2);
  tbb::parallel_for(0, spread.across, [&](int x) {
    const auto echo = middle.echo({offsetOf(x, std::size_t(spread.across), spread.x_mm), 0, depth_mm}, depth_mm);
    std::copy(echo.begin(), echo.end(), spread.echo.begin() + std::ptrdiff_t(x) * spread.along);
  });
  tbb::parallel_for(0, int(spread.slice.size()), [&](int y) {
    spread.slice[y] = peakOf(middle.echo({0, offsetOf(y, spread.slice.size(), spread.y_mm), depth_mm}, depth_mm));
  });
  // The point lies kFromEnd_mm from the end of the array; each scanline uses the part of its aperture that exists.
  tbb::parallel_for(0, int(spread.endAcross.size()), [&](int x) {
    const double line_mm = offsetOf(x, spread.endAcross.size(), spread.x_mm), end_mm = kFromEnd_mm + line_mm;
    if (end_mm < 0) return;
    spread.endAcross[x] = peakOf(ArrayField(probe, settings, end_mm).echo({-line_mm, 0, depth_mm}, depth_mm));
  });
  return spread;
}

/// Images of one point, or of cysts in speckle, by an engine.
class Camera {
 public:
  static Result<Camera> make(const Probe& probe, const ImagingSettings& settings, std::string_view engine) {
    auto made = makeEngine(engine);
    if (!made) return tl::unexpected(made.error());
    Camera camera(probe, settings, std::move(*made));
    camera.engine_->prepare(probe, settings);
    return camera;
  }

  Result<Spread> spreadAt(double depth_mm) {
    Spread spread = emptySpread();
    if (auto ok = shoot(0, 0, depth_mm); !ok) return tl::unexpected(ok.error());
    const BeamGrid grid(probe_, settings_);
    for (int x = 0; x < spread.across; ++x)
      for (int z = 0; z < spread.along; ++z)
        spread.echo[std::size_t(x) * spread.along + z] =
            valueAt(grid, offsetOf(x, std::size_t(spread.across), spread.x_mm),
                    depth_mm + offsetOf(z, std::size_t(spread.along), spread.z_mm));
    const double end_mm = probe_.width_mm / 2 - kFromEnd_mm;
    if (auto ok = shoot(end_mm, 0, depth_mm); !ok) return tl::unexpected(ok.error());
    for (int x = 0; x < int(spread.endAcross.size()); ++x)
      spread.endAcross[x] = peakNear(grid, end_mm - offsetOf(x, spread.endAcross.size(), spread.x_mm), depth_mm);
    for (int y = 0; y < int(spread.slice.size()); ++y) {
      if (auto ok = shoot(0, offsetOf(y, spread.slice.size(), spread.y_mm), depth_mm); !ok)
        return tl::unexpected(ok.error());
      spread.slice[y] = peakNear(grid, 0, depth_mm);
    }
    return spread;
  }

  /// Measures cysts of 4 and 8 mm side by side, cylinders perpendicular to the image, at places of independent speckle.
  Result<void> addCysts(double depth_mm, PointSpreadFigures& figures) {
    constexpr double kSpeckles = 6, kApart_mm = 6;
    const Vec3 small{-10, 0, depth_mm}, large{8, 0, depth_mm};
    AcousticTable table = table_;
    table.tissues[kVein].echogenicity_dB = kAnechoic_dB;
    Region region = regionOf(probe_, settings_, {});
    region.high_mm.y += kSpeckles * kApart_mm;
    const LabelMap labels = cystLabels(region, small, large);
    CtVolume ct;
    ct.geometry = labels.geometry;
    ct.voxels.assign(ct.geometry.voxelCount(), 0);
    const auto scene = AcousticScene::make(ct, labels, table, region);
    if (!scene) return tl::unexpected(scene.error());
    ImagingSettings settings = settings_;
    settings.effects.scattering = settings.effects.speckle = true;
    engine_->prepare(probe_, settings);
    const BeamGrid grid(probe_, settings);
    bench::CystEchoes ofSmall, ofLarge;
    for (int n = 0; n < kSpeckles; ++n) {
      engine_->render(**scene, {{}, {0, n * kApart_mm, 0}}, {}, nullptr, frame_);
      addCyst(frame_, grid, small, kSmall_mm, ofSmall);
      addCyst(frame_, grid, large, kLarge_mm, ofLarge);
    }
    engine_->prepare(probe_, settings_);
    addCystFigures(ofSmall, ofLarge, figures);
    return {};
  }

 private:
  static LabelMap cystLabels(const Region& region, Vec3 small, Vec3 large) {
    const Vec3 spacing_mm{0.4, 3, 0.4};
    LabelMap labels;
    for (int a = 0; a < 3; ++a) {
      labels.geometry.size[a] = int((region.high_mm[a] - region.low_mm[a]) / spacing_mm[a]) + 6;
      labels.geometry.spacing_mm[a] = spacing_mm[a];
      labels.geometry.origin_mm[a] = region.low_mm[a] - 2 * spacing_mm[a];
    }
    const auto [columns, rows, slices] = labels.geometry.size;
    labels.voxels.assign(labels.geometry.voxelCount(), kSoftTissue);
    for (int k = 0; k < slices; ++k)
      for (int i = 0; i < columns; ++i) {
        const double x_mm = labels.geometry.origin_mm.x + i * spacing_mm.x;
        const double z_mm = labels.geometry.origin_mm.z + k * spacing_mm.z;
        if (std::hypot(x_mm - small.x, z_mm - small.z) > kSmall_mm / 2 &&
            std::hypot(x_mm - large.x, z_mm - large.z) > kLarge_mm / 2)
          continue;
        for (int j = 0; j < rows; ++j) labels.voxels[(std::size_t(k) * rows + j) * columns + i] = kVein;
      }
    return labels;
  }

  Camera(const Probe& probe, const ImagingSettings& settings, std::unique_ptr<Engine> engine)
      : probe_(probe), settings_(settings), engine_(std::move(engine)) {
    for (AcousticTissue& tissue : table_.tissues) tissue.attenuation_dBpcmMHz = 0;
    const Region region = regionOf(probe, settings, {});
    constexpr double kSpacing_mm = 5;
    for (int a = 0; a < 3; ++a) {
      ct_.geometry.size[a] = int((region.high_mm[a] - region.low_mm[a]) / kSpacing_mm) + 6;
      ct_.geometry.spacing_mm[a] = kSpacing_mm;
      ct_.geometry.origin_mm[a] = region.low_mm[a] - 2 * kSpacing_mm;
    }
    labels_.geometry = ct_.geometry;
    ct_.voxels.assign(ct_.geometry.voxelCount(), 0);
    labels_.voxels.assign(labels_.geometry.voxelCount(), kSoftTissue);
  }

  Result<void> shoot(double x_mm, double y_mm, double depth_mm) {
    const auto scene =
        AcousticScene::make(ct_, labels_, table_, regionOf(probe_, settings_, {}), {}, {{{x_mm, y_mm, depth_mm}, 1}});
    if (!scene) return tl::unexpected(scene.error());
    engine_->render(**scene, {}, {}, nullptr, frame_);
    return {};
  }
  /// Interpolates between samples and scanlines; 0 outside the image.
  double valueAt(const BeamGrid& grid, double x_mm, double depth_mm) const {
    const auto at = grid.locate(x_mm, depth_mm);
    const int line = int(std::floor(at.scanline)), sample = int(std::floor(at.sample));
    if (line < 0 || sample < 0 || line + 1 >= frame_.scanlines || sample + 1 >= frame_.samples) return 0;
    const float* corner = frame_.amplitude.data() + std::size_t(sample) * frame_.scanlines + line;
    const double across = at.scanline - line, down = at.sample - sample;
    const double upper = corner[0] + across * (corner[1] - corner[0]);
    const float* below = corner + frame_.scanlines;
    return upper + down * (below[0] + across * (below[1] - below[0]) - upper);
  }
  double peakNear(const BeamGrid& grid, double x_mm, double depth_mm) const {
    double top = 0;
    for (double z_mm = depth_mm - 1; z_mm <= depth_mm + 1; z_mm += 0.01) top = std::max(top, valueAt(grid, x_mm, z_mm));
    return top;
  }

  Probe probe_;
  ImagingSettings settings_;
  std::unique_ptr<Engine> engine_;
  AcousticTable table_;
  CtVolume ct_;
  LabelMap labels_;
  EnvelopeFrame frame_;
};

}  // namespace

Result<PointSpreadBench> runPointSpreadBench(const Probe& probe, std::string_view engine, const Progress& progress) {
  if (probe.shape != ProbeShape::Linear)
    return fail("The probe \"" + probe.name +
                "\" is not linear: the field is that of a straight array. Choose one that is.");
  PointSpreadBench bench{probe, settingsFor(probe), std::string(engine), {}};
  ImagingSettings& settings = bench.settings;
  settings.depth_mm = 48, settings.samples = 2400, settings.looks = 1;
  settings.elevationPlanes = 1, settings.conformingContact = false;
  settings.effects = Effects::none();
  settings.effects.beam = true;
  if (auto ok = validate(settings, probe); !ok) return tl::unexpected(ok.error());
  auto camera = Camera::make(probe, settings, engine);
  if (!camera) return tl::unexpected(camera.error());
  for (const double depth_mm : kDepths_mm) {
    if (!report(progress, "imaging points", double(bench.rows.size()) / double(kDepths_mm.size())))
      return fail(std::string(kCancelled));
    const auto ours = camera->spreadAt(depth_mm);
    if (!ours) return tl::unexpected(ours.error());
    const Spread field = fieldSpread(probe, settings, depth_mm);
    PointSpreadRow row{depth_mm, bench::figuresOf(*ours), bench::figuresOf(field)};
    if (auto ok = camera->addCysts(depth_mm, row.ours); !ok) return tl::unexpected(ok.error());
    addCystFigures(bench::cystOf(field, kSmall_mm), bench::cystOf(field, kLarge_mm), row.field);
    bench.rows.push_back(row);
  }
  return bench;
}

}  // namespace insonate

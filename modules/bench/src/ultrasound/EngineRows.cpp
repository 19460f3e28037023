#include "ultrasound/EngineRows.h"

#include "ultrasound/FrameTimer.h"

#include <insonate/bench/ImageMeasures.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/FrameCost.h>
#include <insonate/ultrasound/Frames.h>

#include <tbb/info.h>

#include <algorithm>
#include <cmath>

namespace insonate::bench {
namespace {

/// Differences of frames of one size, pooled: RMS of the difference over RMS of the truth, all looks.
class EnvelopeError {
 public:
  void add(const EnvelopeFrame& frame, const EnvelopeFrame& truth);
  double percent() const;

 private:
  double difference2_ = 0, truth2_ = 0;
};

void EnvelopeError::add(const EnvelopeFrame& frame, const EnvelopeFrame& truth) {
  for (std::size_t i = 0; i < truth.amplitude.size(); ++i) {
    const double t = truth.amplitude[i], d = frame.amplitude[i] - t;
    difference2_ += d * d, truth2_ += t * t;
  }
}

double EnvelopeError::percent() const {
  return truth2_ > 0 ? 100 * std::sqrt(difference2_ / truth2_) : 0;
}

/// First look of a frame on other beams of the same probe and depth, bilinear.
EnvelopeFrame resampled(const EnvelopeFrame& frame, const BeamGrid& from, const BeamGrid& to) {
  EnvelopeFrame out;
  out.resize(to.scanlines(), to.samples(), 1);
  const auto before = [](double at, int size) { return std::clamp(static_cast<int>(at), 0, size - 2); };
  for (int k = 0; k < to.samples(); ++k)
    for (int l = 0; l < to.scanlines(); ++l) {
      const Vec3 point_mm = to.origin(l) + to.direction(l) * to.range_mm(k);
      const BeamGrid::Location at = from.locate(point_mm.x, point_mm.z);
      const int line = before(at.scanline, frame.scanlines), sample = before(at.sample, frame.samples);
      const double x = std::clamp(at.scanline - line, 0.0, 1.0), z = std::clamp(at.sample - sample, 0.0, 1.0);
      const float* p = frame.look(0) + std::size_t(sample) * frame.scanlines + line;
      const float* q = p + frame.scanlines;
      out.amplitude[std::size_t(k) * to.scanlines() + l] =
          static_cast<float>((1 - z) * ((1 - x) * p[0] + x * p[1]) + z * ((1 - x) * q[0] + x * q[1]));
    }
  return out;
}

constexpr std::string_view kReference = "reference";

Result<Imager> makeImager(ImagingSetup setup, const ImagingSettings& settings, std::string_view engine) {
  setup.settings = settings;
  setup.engine = engine;
  return Imager::make(setup);
}

ImagingSettings withoutSpeckle(ImagingSettings settings) {
  settings.effects.speckle = false;
  settings.looks = 1;  // looks differ in their speckle only
  return settings;
}

std::vector<ImagingSettings> sweep(const UltrasoundBenchPlan& plan) {
  const ImagingSettings& own = plan.setup.settings;
  std::vector<ImagingSettings> all{own};
  const auto vary = [&](const std::vector<int>& values, int ImagingSettings::*field) {
    for (const int value : values) {
      ImagingSettings changed = own;
      changed.*field = value;
      if (changed.*field != own.*field) all.push_back(changed);
    }
  };
  vary(plan.scanlines, &ImagingSettings::scanlines);
  vary(plan.samples, &ImagingSettings::samples);
  vary(plan.elevationPlanes, &ImagingSettings::elevationPlanes);
  if (plan.thesisLook && own.look != Look::Thesis) {
    all.push_back(own);
    all.back().look = Look::Thesis;
  }
  return all;
}

/// The number of samples at which gates have the smallest distance that the model uses.
int samplesWithFinestGates(const Probe& probe, ImagingSettings settings) {
  int best = settings.samples;
  double min_mm = gateDistance_mm(probe, settings);
  for (const int candidate : {250, 375, 500, 625, 750, 875, 900, 1000, 1250, 1500, 1750, 1800, 2000}) {
    settings.samples = candidate;
    if (const double gate_mm = gateDistance_mm(probe, settings); gate_mm < min_mm) min_mm = gate_mm, best = candidate;
  }
  return best;
}

/// The face 3 mm in the tissue, which moves to the sides, on the lattice of a solver.
PlaneDisplacement pressedTissue(const Probe& probe, const ImagingSettings& settings) {
  constexpr double kStep_mm = 0.5, kIndentation_mm = 3, kReach_mm = 20;
  const BeamGrid grid(probe, settings);
  PlaneDisplacement d{.left_mm = grid.minLateral_mm(),
                      .top_mm = grid.minAxial_mm(),
                      .step_mm = kStep_mm,
                      .columns = 0,
                      .rows = 0,
                      .restFromDisplayed = {},
                      .lung = {}};
  d.columns = 1 + static_cast<int>(std::ceil((grid.maxLateral_mm() - grid.minLateral_mm()) / kStep_mm));
  d.rows = 1 + static_cast<int>(std::ceil((grid.maxAxial_mm() - grid.minAxial_mm()) / kStep_mm));
  for (int k = 0; k < d.rows; ++k)
    for (int i = 0; i < d.columns; ++i) {
      const double depth_mm = std::max(0.0, d.top_mm + k * kStep_mm), left = std::exp(-depth_mm / kReach_mm);
      const double x_mm = d.left_mm + i * kStep_mm;
      d.restFromDisplayed.push_back({static_cast<float>(-kIndentation_mm * left * x_mm / (2 * kReach_mm)),
                                     static_cast<float>(-kIndentation_mm * left)});
    }
  return d;
}

UltrasoundBenchRow rowOf(const Probe& probe, const ImagingSettings& s, std::string_view engine, int threads) {
  UltrasoundBenchRow row;
  row.engine = engine, row.threads = threads;
  row.look = s.look == Look::Thesis ? "thesis" : "coherent";
  row.scanlines = s.scanlines, row.samples = s.samples, row.elevationPlanes = s.elevationPlanes;
  row.width = s.width, row.height = s.height;
  row.gate_mm = gateDistance_mm(probe, s);
  return row;
}

}  // namespace

EngineRows::EngineRows(const UltrasoundBenchPlan& plan, const AcousticScene& scene, std::span<const Transform> path)
    : plan_(&plan),
      scene_(&scene),
      path_(path.begin(), path.end()),
      settings_(sweep(plan)),
      denseSettings_(withoutSpeckle(plan.setup.settings)) {
  denseSettings_.scanlines = plan.denseScanlines;
  denseSettings_.elevationPlanes = plan.densePlanes;
  denseSettings_.samples = samplesWithFinestGates(plan.setup.probe, denseSettings_);
}

Result<EngineRows> EngineRows::make(const UltrasoundBenchPlan& plan, const AcousticScene& scene,
                                    std::span<const Transform> path) {
  EngineRows rows(plan, scene, path);
  if (auto ok = rows.renderDenseReference(); !ok) return tl::unexpected(ok.error());
  return rows;
}

Result<void> EngineRows::renderDenseReference() {
  auto imager = makeImager(plan_->setup, denseSettings_, kReference);
  if (!imager) return tl::unexpected(imager.error());
  imager->render(*scene_, path_.front(), dense_);
  return {};
}

Result<void> EngineRows::addDiscretisation(const ImagingSettings& settings, const PlaneContents& contents,
                                           UltrasoundBenchRow& row) const {
  if (settings.look == Look::Thesis || contents.needle || !contents.displacement.empty()) {
    row.discretisationError_percent = row.discretisationSsim = NAN;
    return {};
  }
  const ImagingSettings quiet = withoutSpeckle(settings);
  auto imager = makeImager(plan_->setup, quiet, row.engine);
  if (!imager) return tl::unexpected(imager.error());
  ImagingFrame frame;
  imager->render(*scene_, path_.front(), frame);
  const Probe& probe = plan_->setup.probe;
  EnvelopeError error;
  error.add(frame.envelope, resampled(dense_.envelope, BeamGrid(probe, denseSettings_), BeamGrid(probe, quiet)));
  row.discretisationError_percent = error.percent();
  row.discretisationSsim = structuralSimilarity(frame.image, dense_.image);
  return {};
}

Result<void> EngineRows::measureOwn(const PlaneContents& contents, const char* what,
                                    std::vector<UltrasoundBenchRow>& rows) const {
  const std::size_t before = rows.size();
  auto ok = measure(settings_.front(), contents, rows);
  for (std::size_t r = before; r < rows.size(); ++r) rows[r].look += what;
  return ok;
}

Result<void> EngineRows::measureDisplaced(std::vector<UltrasoundBenchRow>& rows) const {
  return measureOwn({pressedTissue(plan_->setup.probe, settings_.front()), {}}, ", displaced", rows);
}

/// A needle from the left to the middle of the image, at 45 degrees.
Result<void> EngineRows::measureNeedle(std::vector<UltrasoundBenchRow>& rows) const {
  constexpr double kTipDepth_mm = 18;
  Needle needle;
  needle.tip_mm = {0, 0, kTipDepth_mm};
  needle.direction = normalized({1, 0, 1}), needle.bevelNormal = {0, 0, -1};
  return measureOwn({{}, needle}, ", needle", rows);
}

Result<void> EngineRows::measure(const ImagingSettings& settings, const PlaneContents& contents,
                                 std::vector<UltrasoundBenchRow>& rows) const {
  auto truthImager = makeImager(plan_->setup, settings, kReference);
  if (!truthImager) return tl::unexpected(truthImager.error());
  const std::size_t poses = std::clamp<std::size_t>(plan_->poses, 1, path_.size());
  const auto poseAt = [&](std::size_t i) -> const Transform& { return path_[i * (path_.size() - 1) / poses]; };
  std::vector<ImagingFrame> truths(poses);
  UltrasoundBenchRow reference = rowOf(plan_->setup.probe, settings, kReference, 1);
  const Patience once{.warmUp = 0, .least = static_cast<int>(poses), .most = static_cast<int>(poses), .seconds = 0};
  reference.times = timeFrames(once, [&](int i) { contents.render(*truthImager, *scene_, poseAt(i), truths[i]); });
  for (const ImagingFrame::Stage& stage : truths[0].stages)
    reference.stages.push_back({stage.name, stage.ms, stage.ms});
  if (auto ok = addDiscretisation(settings, contents, reference); !ok) return ok;

  for (const std::string& engine : engineNames()) {
    // The notes name the engines that are missing on this machine.
    if (engine == kReference || !makeEngine(engine)) continue;
    auto imager = makeImager(plan_->setup, settings, engine);
    if (!imager) return tl::unexpected(imager.error());
    UltrasoundBenchRow row = rowOf(plan_->setup.probe, settings, engine, 1);
    EnvelopeError error;
    ImagingFrame frame;
    row.ssim = 0;
    for (std::size_t i = 0; i < poses; ++i) {
      contents.render(*imager, *scene_, poseAt(i), frame);
      error.add(frame.envelope, truths[i].envelope);
      row.ssim += structuralSimilarity(frame.image, truths[i].image) / double(poses);
    }
    row.envelopeError_percent = error.percent();
    if (auto ok = addDiscretisation(settings, contents, row); !ok) return ok;
    // The number of threads does not limit a graphics card or its software replacement.
    const int all = tbb::info::default_concurrency();
    std::vector<int> threads{engine == "glsl" ? all : 1};
    if (all > threads.back()) threads.push_back(all);
    for (const int n : threads) {
      row.threads = n;
      TimedFrames timed = timeImager(*imager, *scene_, path_, contents, n, {.seconds = plan_->secondsPerRow});
      row.times = timed.times, row.stages = std::move(timed.stages);
      rows.push_back(row);
    }
  }
  rows.push_back(std::move(reference));
  return {};
}

}  // namespace insonate::bench

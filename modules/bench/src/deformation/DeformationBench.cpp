#include "ultrasound/FrameTimer.h"

#include <insonate/bench/DeformationBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/PlaneTissue.h>

#include <malloc.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

using bench::Patience;
using Row = DeformationBenchRow;

constexpr std::uint64_t kPhantomSeed = 1;
constexpr double kPress_mm = 4;
constexpr int kLiveIterations = 4;
constexpr int kPathFrames = 48;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The built-in neck, with a probe that just touches it.
struct Bench {
  PatientCase patient;
  ImagingSetup setup;
  Transform touching;
  std::shared_ptr<const AcousticScene> scene;
};

Transform movedBy(const Transform& pose, double lateral_mm, double axial_mm) {
  Transform moved = pose;
  moved.offset = pose * Vec3{lateral_mm, 0, axial_mm};
  return moved;
}

Result<Bench> prepareBench(const Progress& progress) {
  Bench bench;
  auto patient = makePhantom(phantomVariants().front().name, kPhantomSeed, progress);
  if (!patient) return tl::unexpected(patient.error());
  bench.patient = std::move(*patient);
  auto probe = loadProbe("linear");
  auto tissues = loadAcousticTable("neck");
  const auto start = autoStartPose(bench.patient);
  if (!probe) return tl::unexpected(probe.error());
  if (!tissues) return tl::unexpected(tissues.error());
  if (!start) return tl::unexpected(start.error());
  bench.setup = {.probe = *probe,
                 .settings = settingsFor(*probe),
                 .tissues = std::move(*tissues),
                 .engine = "cpu",
                 .mechanics = {}};
  const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
  if (!pose) return tl::unexpected(pose.error());
  const auto onSkin = poseOnSkin(bench.patient.labels, probeFaceOf(*probe, bench.setup.mechanics), *pose);
  if (!onSkin) return tl::unexpected(onSkin.error());
  Region region = sceneRegion(bench.setup, *onSkin, 20);
  for (double* low : {&region.low_mm.x, &region.low_mm.y, &region.low_mm.z}) *low -= 8;
  for (double* high : {&region.high_mm.x, &region.high_mm.y, &region.high_mm.z}) *high += 8;
  auto scene = makeScene(bench.patient, bench.setup, region, progress);
  if (!scene) return tl::unexpected(scene.error());
  bench.scene = *scene;
  auto pressed = CompressedTissue::make(bench.setup.probe, bench.setup.settings, bench.setup.mechanics);
  if (!pressed) return tl::unexpected(pressed.error());
  const auto travel = pressed->travelRange(*bench.scene, *onSkin);
  if (!travel) return fail("The built-in neck's start pose does not meet the skin.");
  bench.touching = movedBy(*onSkin, 0, travel->touch_mm);
  return bench;
}

Result<CompressedTissue> makeModel(const Bench& bench, const std::string& model, double mesh_mm, int maxIterations) {
  TissueMechanics mechanics = bench.setup.mechanics;
  mechanics.model = model;
  mechanics.settings.mesh_mm = mesh_mm;
  return CompressedTissue::make(bench.setup.probe, bench.setup.settings, mechanics, maxIterations, true);
}

/// Poses of a hand that compresses, releases and slides back and forth.
std::vector<Transform> pressingPath(const Transform& touching, double slide_mm) {
  std::vector<Transform> path;
  double lateral_mm = 0, axial_mm = kPress_mm;
  for (int i = 0; i < kPathFrames; ++i) {
    path.push_back(movedBy(touching, lateral_mm, axial_mm));
    axial_mm += i / 6 % 2 == 0 ? 0.25 : -0.25;
    lateral_mm += i / 12 % 2 == 0 ? slide_mm : -slide_mm;
  }
  return path;
}

double shareOf(const Deformation& d, std::uint8_t label) {
  for (const LumenArea& l : d.lumens)
    if (l.label == label) return l.area_mm2 / l.rest_mm2;
  return 1;
}

/// Errors of one answer against the reference's at the same pose.
struct Errors {
  double sum = 0, max_mm = 0, force_percent = 0, area = 0;
  int points = 0, poses = 0;

  void add(const Bench& bench, const Transform& pose, const Deformation& answer, const Deformation& exact) {
    std::vector<PlanePoint> seen, rest;
    const auto half = static_cast<float>(bench.setup.probe.width_mm / 2);
    const auto depth = static_cast<float>(bench.setup.settings.depth_mm);
    for (float z = 0.25F; z < depth; z += 0.5F)
      for (float x = -half; x <= half; x += 0.5F) {
        const Vec3 shift = shiftAt(exact.displacement, x, z);
        seen.push_back({x, z});
        rest.push_back({static_cast<float>(x + shift.x), static_cast<float>(z + shift.z)});
      }
    PlaneSamples tissue;
    samplePlane(*bench.scene, pose, rest, tissue);
    constexpr float kWall_mm = 0.3F;  // near a wall the piecewise linear answer has a bend
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (tissue.toArtery_mm[k] < kWall_mm || tissue.toVein_mm[k] < kWall_mm || tissue.toBone_mm[k] < 0) continue;
      const Vec3 shift = shiftAt(answer.displacement, seen[k].x_mm, seen[k].z_mm);
      const double off = std::hypot(seen[k].x_mm + shift.x - rest[k].x_mm, seen[k].z_mm + shift.z - rest[k].z_mm);
      sum += off * off;
      max_mm = std::max(max_mm, off);
      ++points;
    }
    force_percent += 100 * std::abs(answer.force_N / exact.force_N - 1);
    area = std::max(area, std::abs(shareOf(answer, kVein) - shareOf(exact, kVein)));
    ++poses;
  }
  void writeTo(Row& row) const {
    row.displacementRms_mm = std::sqrt(sum / std::max(points, 1));
    row.displacementMax_mm = max_mm;
    row.forceError_percent = force_percent / std::max(poses, 1);
    row.lumenAreaError = area;
  }
};

/// A path with the reference's answers at some of its frames.
struct Path {
  std::string state;
  std::vector<Transform> poses;
  std::vector<std::pair<int, Deformation>> exact;
};

Result<std::vector<Path>> pathsWithAnswers(const Bench& bench, bool quick, const Progress& progress) {
  std::vector<Path> paths{{"cold", {movedBy(bench.touching, 0, kPress_mm)}, {}},
                          {"warm", pressingPath(bench.touching, 0), {}},
                          {"moving", pressingPath(bench.touching, 0.3), {}},
                          {"static", {movedBy(bench.touching, 0, kPress_mm)}, {}},
                          {"untouched", {movedBy(bench.touching, 0, -1)}, {}}};
  auto model = makeModel(bench, "reference", 0.5, 0);
  if (!model) return tl::unexpected(model.error());
  const BloodPressure pressure = bloodPressure({}, bench.setup.mechanics.tissues);
  for (Path& path : paths) {
    if (path.state == "untouched") continue;
    std::vector<int> frames{0};
    if (path.poses.size() > 1)
      frames = quick ? std::vector<int>{kPathFrames - 1} : std::vector<int>{9, 22, 35, kPathFrames - 1};
    for (const int f : frames) {
      if (!report(progress, "Computing what others are measured against", 0)) return fail("Cancelled.");
      model->release();
      model->hold(*bench.scene, path.poses[f], pressure);
      path.exact.emplace_back(f, model->deformation());
    }
  }
  return paths;
}

Row measure(const Bench& bench, const Path& path, CompressedTissue& model, bool cold, double seconds) {
  Row row;
  row.state = path.state;
  const BloodPressure pressure = bloodPressure({}, bench.setup.mechanics.tissues);
  int iterations = 0, calls = 0;
  const auto go = [&](int frame) {
    if (cold) model.release();
    model.hold(*bench.scene, path.poses[frame % path.poses.size()], pressure);
    iterations += model.deformation().iterations;
    ++calls;
  };
  model.release();
  Errors errors;
  // The first lap measures errors, with the live solution carried from frame to frame; the second lap measures times.
  for (int f = 0; f < static_cast<int>(path.poses.size()); ++f) {
    go(f);
    for (const auto& [frame, exact] : path.exact)
      if (frame == f) errors.add(bench, path.poses[f], model.deformation(), exact);
  }
  if (errors.poses > 0)
    errors.writeTo(row);
  else
    row.displacementRms_mm = row.displacementMax_mm = row.forceError_percent = row.lumenAreaError = kNone;
  row.unknowns = 2 * model.deformation().meshColumns * model.deformation().meshRows;
  iterations = calls = 0;
  const FrameTimes times = bench::timeFrames({.warmUp = 2, .least = 3, .most = 400, .seconds = seconds}, go);
  row.frames = times.frames;
  row.median_ms = times.median_ms, row.p95_ms = times.p95_ms, row.min_ms = times.min_ms;
  row.iterations = calls > 0 ? double(iterations) / calls : 0;
  return row;
}

struct Wanted {
  std::string model;
  double mesh_mm;
  int threads = 1;  ///< with more, what a live probe does: the rest is known from one
};

Result<std::vector<Row>> rowsOf(const Bench& bench, const std::vector<Path>& paths, const Wanted& wanted,
                                double seconds) {
  const auto& [name, mesh_mm, threads] = wanted;
  std::vector<Row> rows;
  tbb::task_arena arena(threads);
  for (const Path& path : paths) {
    const bool cold = path.state == "cold";
    if (name == "reference" && !cold) continue;
    if (threads > 1 && path.state != "warm" && path.state != "moving") continue;
    const double before = static_cast<double>(::mallinfo2().uordblks);
    auto model = makeModel(bench, name, mesh_mm, cold || path.state == "static" ? 0 : kLiveIterations);
    if (!model) return tl::unexpected(model.error());
    Row row = arena.execute([&] { return measure(bench, path, *model, cold, seconds); });
    row.model = name;
    row.mesh_mm = mesh_mm;
    row.threads = threads;
    row.memory_MB = (static_cast<double>(::mallinfo2().uordblks) - before) / 1e6;
    rows.push_back(row);
  }
  return rows;
}

Result<CompressionCurve> curveAt(const Bench& bench, double venous_mmHg, double step_mm) {
  CompressionCurve curve{.venousPressure_mmHg = venous_mmHg, .points = {}};
  auto model = makeModel(bench, "elastic", 0.5, 0);
  if (!model) return tl::unexpected(model.error());
  Physiology physiology;
  physiology.centralVenous_mmHg = venous_mmHg;
  const BloodPressure pressure = bloodPressure(physiology, bench.setup.mechanics.tissues);
  for (double depth_mm = 0; depth_mm <= 12; depth_mm += step_mm) {
    model->hold(*bench.scene, movedBy(bench.touching, 0, depth_mm), pressure);
    const Deformation& d = model->deformation();
    curve.points.push_back({d.force_N, depth_mm, shareOf(d, kVein), shareOf(d, kArtery)});
  }
  return curve;
}

}  // namespace

Result<DeformationBench> runDeformationBench(bool quick, const Progress& progress) {
  const auto bench = prepareBench(progress);
  if (!bench) return tl::unexpected(bench.error());
  const auto paths = pathsWithAnswers(*bench, quick, progress);
  if (!paths) return tl::unexpected(paths.error());
  std::vector<Wanted> wanted{{"elastic", 0.5}, {"column", 0.5}};
  if (const int all = tbb::info::default_concurrency(); all > 1)
    wanted.insert(wanted.end(), {{"elastic", 0.5, all}, {"column", 0.5, all}});
  if (!quick)
    wanted.insert(wanted.end(),
                  {{"elastic", 1}, {"elastic", 0.7}, {"elastic", 0.35}, {"column", 1}, {"reference", 0.5}});
  DeformationBench result;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!report(progress, "Measuring models", double(i) / double(wanted.size()))) return fail("Cancelled.");
    auto rows = rowsOf(*bench, *paths, wanted[i], quick ? 0.5 : 2);
    if (!rows) return tl::unexpected(rows.error());
    result.rows.insert(result.rows.end(), rows->begin(), rows->end());
  }
  for (const double venous_mmHg : quick ? std::vector<double>{4} : std::vector<double>{1, 4, 8, 12}) {
    if (!report(progress, "Pressing vessels shut", 0)) return fail("Cancelled.");
    auto curve = curveAt(*bench, venous_mmHg, quick ? 2 : 0.5);
    if (!curve) return tl::unexpected(curve.error());
    result.curves.push_back(std::move(*curve));
  }
  result.notes = {
      "No model uses more than one thread, so that the others make the image: rows of all cores differ from those of "
      "one by what the machine's clock does. A frame includes looking up the tissue in the scene and the inverse map.",
      "Errors are against `reference` (cells of half the size, double precision, converged) at the same poses, of a "
      "solution that went on from frame to frame with at most " +
          std::to_string(kLiveIterations) +
          " steps each; cold "
          "ones are converged.",
      "`untouched` and `static` are what is saved where nothing touches and where nothing changes; `cold` against "
      "`warm` is "
      "what carrying the last solution over saves.",
      "Times are of a machine that others may have used meanwhile: the least says more than the median there."};
  return result;
}

}  // namespace insonate

#include "Benchmark.h"

#include <insonate/cases/CropCase.h>
#include <insonate/cases/Phantom.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/prepare/PrepareBenchmark.h>
#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/train/TrainBenchmark.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace insonate::app {
namespace {

constexpr int kPatience_ms = 180'000;
/// Surfaces and what is computed ahead of need are there after this.
constexpr int kSettle_ms = 12'000;
constexpr int kSettlePrepare_ms = 60'000;
constexpr int kLook_ms = 100;
constexpr std::array<int, 3> kLarge{512, 512, 300}, kQuick{64, 64, 40};
constexpr int kRepeats = 15;
constexpr int kJumps = 200;

/// A line of proc(5), /proc/self/status, e.g. "VmRSS".
double memory_MB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size() + 1)) / 1024;
  return 0;
}

/// From here on, "VmHWM" is of what comes: proc(5), clear_refs.
void forgetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// The textbook neck with contrast on a grid of this size.
Result<std::shared_ptr<const PatientCase>> neckOf(const std::array<int, 3>& size, const Progress& progress) {
  auto neck = makePhantom("textbook", 1, progress, CtContrast::kArterial);
  if (!neck) return tl::unexpected(neck.error());
  const VolumeGeometry& grid = neck->ct.geometry;
  Vec3 spacing_mm = grid.spacing_mm;
  for (int axis = 0; axis < 3; ++axis) spacing_mm[axis] *= double(grid.size[axis]) / size[axis];
  auto large = cropCase(*neck, {boxOf(grid), spacing_mm}, progress);
  if (!large) return tl::unexpected(large.error());
  return std::make_shared<const PatientCase>(std::move(*large));
}

}  // namespace

Benchmark::Benchmark(ui::MainWindow& window, train::TrainWorkspace& train, prepare::PrepareWorkspace& prepare,
                     BenchmarkPlan plan, std::function<void(const QString&)> done)
    : window_(window), train_(train), prepare_(prepare), plan_(std::move(plan)), done_(std::move(done)) {
  double load[1] = {0};
  if (getloadavg(load, 1) != 1) load[0] = -1;
  add(QStringLiteral("logical_cores"), std::thread::hardware_concurrency(), {});
  add(QStringLiteral("load_average_at_start"), load[0], {});
  timeStarts();
  empty_MB_ = memory_MB("VmRSS");
  first_ = std::make_unique<FirstImage>(window_, [this] { opened(); });
  opening_.start();
}

/// Each in a process of its own, since loading the program counts; the first one has to make the built-in neck, but
/// where there is no time to.
void Benchmark::timeStarts() {
  const QTemporaryDir cache;
  const bool withCase = plan_.quick && !plan_.caseFolder.empty();
  const double cold_ms = startOnce(cache.path(), withCase);
  const double warm_ms = withCase ? cold_ms : startOnce(cache.path(), false);
  add(QStringLiteral("start_to_first_image_cold"), cold_ms, QStringLiteral("ms"));
  add(QStringLiteral("start_to_first_image_warm"), warm_ms, QStringLiteral("ms"));
  const double case_ms = withCase || plan_.caseFolder.empty() ? warm_ms : startOnce(cache.path(), true);
  add(QStringLiteral("start_to_first_image_case"), case_ms, QStringLiteral("ms"));
}

double Benchmark::startOnce(const QString& cache, bool withCase) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("XDG_CACHE_HOME"), cache);
  program.setProcessEnvironment(environment);
  QStringList arguments{QStringLiteral("--until-image")};
  if (withCase) arguments << QString::fromStdString(plan_.caseFolder);
  program.start(QCoreApplication::applicationFilePath(), arguments);
  if (!program.waitForFinished(kPatience_ms)) {
    program.kill();
    program.waitForFinished();
  }
  bool understood = false;
  const double ms = program.readAllStandardOutput().trimmed().toDouble(&understood);
  if (!understood) error_ = tr("The window took too long to show its first image; run the benchmark again.");
  return ms;
}

void Benchmark::opened() {
  add(QStringLiteral("open_case"), double(opening_.nsecsElapsed()) / 1e6, QStringLiteral("ms"));
  QTimer::singleShot(plan_.quick ? 0 : kSettle_ms, this, [this] { measureLive(false); });
}

void Benchmark::measureLive(bool follows) {
  train_.benchmark().measureLive(plan_.quick ? 0.5 : 6, follows, [this, follows](const train::LiveRates& rates) {
    const QString name = follows ? QStringLiteral("live_3d_follows_%1") : QStringLiteral("live_3d_idle_%1");
    add(name.arg(QStringLiteral("images_per_second")), rates.imagesPerSecond, QStringLiteral("1/s"));
    add(name.arg(QStringLiteral("latency_median")), rates.median_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("latency_p95")), rates.p95_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("processor_per_image")), rates.cpu_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("window_thread_per_image")), rates.window_ms, QStringLiteral("ms"));
    QTimer::singleShot(0, this, [this, follows] { follows ? measureJumps() : measureLive(true); });
  });
}

void Benchmark::measureJumps() {
  train_.benchmark().measureJumps(plan_.quick ? 2 : kJumps, [this](const train::JumpRates& rates) {
    add(QStringLiteral("jumps"), rates.jumps, {});
    for (const auto& [name, times] :
         {std::pair{"jump_to_first_image_%1", rates.firstImage}, {"jump_to_full_quality_%1", rates.fullQuality}}) {
      add(QString::fromLatin1(name).arg(QStringLiteral("median")), times.median_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("p95")), times.p95_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("longest")), times.longest_ms, QStringLiteral("ms"));
    }
    add(QStringLiteral("jump_coarse_difference_median"), rates.differenceMedian, QStringLiteral("gray levels"));
    add(QStringLiteral("jump_coarse_difference_p95"), rates.differenceP95, QStringLiteral("gray levels"));
    QTimer::singleShot(0, this, [this] { measureHands(); });
  });
}

void Benchmark::measureHands() {
  train_.benchmark().measureHands(plan_.quick ? 0.5 : 6, [this](const train::HandRates& rates) {
    add(QStringLiteral("hands_images_per_second"), rates.imagesPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("servo_ticks"), rates.ticks, {});
    add(QStringLiteral("servo_ticks_late"), rates.late, {});
    add(QStringLiteral("servo_tick_median"), rates.p50_us, QStringLiteral("us"));
    add(QStringLiteral("servo_tick_p99"), rates.p99_us, QStringLiteral("us"));
    add(QStringLiteral("servo_tick_p99.9"), rates.p999_us, QStringLiteral("us"));
    add(QStringLiteral("servo_tick_longest"), rates.max_us, QStringLiteral("us"));
    QTimer::singleShot(0, this, [this] { measureOrbit(); });
  });
}

void Benchmark::measureOrbit() {
  const train::OrbitRates rates = train_.benchmark().measureOrbit(plan_.quick ? 4 : 60);
  add(QStringLiteral("orbit_frames_per_second"), rates.framesPerSecond, QStringLiteral("1/s"));
  add(QStringLiteral("orbit_median"), rates.median_ms, QStringLiteral("ms"));
  add(QStringLiteral("orbit_p95"), rates.p95_ms, QStringLiteral("ms"));
  graphics_ = rates.graphics;
  // From its own event, as all that is measured by events.
  QTimer::singleShot(0, this, [this] { measureVolume(); });
}

void Benchmark::measureVolume() {
  train_.benchmark().measureVolume(plan_.quick ? 0.5 : 4, [this](const train::VolumeRates& rates) {
    add(QStringLiteral("volume_orbit_frames_per_second"), rates.orbitPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("volume_zoom_frames_per_second"), rates.zoomPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("volume_probe_frames_per_second"), rates.followPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("volume_exact_after"), rates.exact_ms, QStringLiteral("ms"));
    for (const auto& [name, holds] :
         {std::pair{"volume_hold_moving_%1", rates.moving}, {"volume_hold_at_rest_%1", rates.rest}}) {
      add(QString::fromLatin1(name).arg(QStringLiteral("median")), holds.median_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("least")), holds.min_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("longest")), holds.longest_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("processor_longest")), holds.processor_ms, QStringLiteral("ms"));
    }
    // Not from within what is being measured.
    QTimer::singleShot(0, this, [this] { measureMemory(); });
  });
}

/// Measures Train, and Prepare with its own ultrasound while Train is hidden.
void Benchmark::measureMemory() {
  add(QStringLiteral("memory_train"), memory_MB("VmRSS"), QStringLiteral("MB"));
  window_.showWorkspace(QStringLiteral("prepare"));
  QTimer::singleShot(plan_.quick ? 0 : kSettlePrepare_ms, this, [this] {
    add(QStringLiteral("memory_prepare"), memory_MB("VmRSS"), QStringLiteral("MB"));
    add(QStringLiteral("memory_peak"), memory_MB("VmHWM"), QStringLiteral("MB"));
    openLarge();
  });
}

/// In every workspace, as any case.
void Benchmark::openLarge() {
  using Made = std::shared_ptr<const PatientCase>;
  window_.tasks().run<Made>(
      tr("Generating a large neck case"),
      [size = plan_.quick ? kQuick : kLarge](const Progress& progress) { return neckOf(size, progress); },
      [this](Result<Made> made) {
        if (!made) {
          error_ = QString::fromStdString(made.error().message);
          return write();
        }
        forgetPeakMemory();
        Q_EMIT prepare_.caseMade(*made);
        whenReady([this] {
          prepare_.benchmark().measureLabeling(plan_.quick ? 2 : kRepeats,
                                               [this](const auto& times) { labeled(times); });
        });
      });
}

void Benchmark::whenReady(std::function<void()> go) {
  QTimer::singleShot(kLook_ms, this, [this, go = std::move(go)] { prepare_.isReady() ? go() : whenReady(go); });
}

void Benchmark::labeled(const std::vector<prepare::LabelingTime>& times) {
  for (const prepare::LabelingTime& time : times) {
    const QString name = QStringLiteral("labelling_%1_%2").arg(time.name);
    add(name.arg(QStringLiteral("median")), time.median_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("longest")), time.longest_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("window_pause")), time.pause_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("window_work")), time.work_ms, QStringLiteral("ms"));
  }
  const PatientCase& patient = *window_.current().patient;
  const double volumes_MB =
      double(patient.ct.voxels.size() * sizeof(std::int16_t) + patient.labels.voxels.size()) / (1 << 20);
  const double held_MB = memory_MB("VmHWM") - empty_MB_;
  add(QStringLiteral("memory_labelling_volumes"), volumes_MB, QStringLiteral("MB"));
  add(QStringLiteral("memory_labelling_peak"), held_MB, QStringLiteral("MB"));
  add(QStringLiteral("memory_labelling_times_volumes"), held_MB / volumes_MB, {});
  // Not from within what was measured.
  QTimer::singleShot(0, this, [this] { write(); });
}

void Benchmark::write() {
  QJsonArray rows;
  std::string csv = "name,value,unit\n";
  for (const Row& row : rows_) {
    rows.append(QJsonObject{{"name", row.name}, {"value", row.value}, {"unit", row.unit}});
    csv += row.name.toStdString() + "," + std::to_string(row.value) + "," + row.unit.toStdString() + "\n";
    std::printf("%-40s %10.1f %s\n", qPrintable(row.name), row.value, qPrintable(row.unit));
  }
  std::printf("%-40s %s\n", "graphics", qPrintable(graphics_));
  std::fflush(stdout);
  const QByteArray json = QJsonDocument(QJsonObject{{"version", 1}, {"graphics", graphics_}, {"rows", rows}}).toJson();
  std::error_code ignored;
  std::filesystem::create_directories(plan_.folder, ignored);
  for (const auto& [name, text] : {std::pair{"window.json", json.toStdString()}, std::pair{"window.csv", csv}})
    if (const auto written = writeAtomically(plan_.folder / name, text); !written)
      error_ = QString::fromStdString(written.error().message);
  done_(error_);
}

}  // namespace insonate::app

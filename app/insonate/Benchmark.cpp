#include "Benchmark.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/MainWindow.h>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
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

/// A line of proc(5), /proc/self/status, e.g. "VmRSS".
double memory_MB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size() + 1)) / 1024;
  return 0;
}

}  // namespace

Benchmark::Benchmark(ui::MainWindow& window, train::TrainWorkspace& train, BenchmarkPlan plan,
                     std::function<void(const QString&)> done)
    : window_(window), train_(train), plan_(std::move(plan)), done_(std::move(done)) {
  double load[1] = {0};
  if (getloadavg(load, 1) != 1) load[0] = -1;
  add(QStringLiteral("logical_cores"), std::thread::hardware_concurrency(), {});
  add(QStringLiteral("load_average_at_start"), load[0], {});
  timeStarts();
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
  if (!understood) trouble_ = tr("The window did not show a picture in time when it was started by itself.");
  return ms;
}

void Benchmark::opened() {
  add(QStringLiteral("open_case"), double(opening_.nsecsElapsed()) / 1e6, QStringLiteral("ms"));
  QTimer::singleShot(plan_.quick ? 0 : kSettle_ms, this, [this] { measureLive(false); });
}

void Benchmark::measureLive(bool follows) {
  train_.measureLive(plan_.quick ? 0.5 : 6, follows, [this, follows](const train::LiveRates& rates) {
    const QString name = follows ? QStringLiteral("live_3d_follows_%1") : QStringLiteral("live_3d_idle_%1");
    add(name.arg(QStringLiteral("images_per_second")), rates.imagesPerSecond, QStringLiteral("1/s"));
    add(name.arg(QStringLiteral("latency_median")), rates.median_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("latency_p95")), rates.p95_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("processor_per_image")), rates.cpu_ms, QStringLiteral("ms"));
    add(name.arg(QStringLiteral("window_thread_per_image")), rates.window_ms, QStringLiteral("ms"));
    QTimer::singleShot(0, this, [this, follows] { follows ? measureHands() : measureLive(true); });
  });
}

void Benchmark::measureHands() {
  train_.measureHands(plan_.quick ? 0.5 : 6, [this](const train::HandRates& rates) {
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
  const train::OrbitRates rates = train_.measureOrbit(plan_.quick ? 4 : 60);
  add(QStringLiteral("orbit_frames_per_second"), rates.framesPerSecond, QStringLiteral("1/s"));
  add(QStringLiteral("orbit_median"), rates.median_ms, QStringLiteral("ms"));
  add(QStringLiteral("orbit_p95"), rates.p95_ms, QStringLiteral("ms"));
  graphics_ = rates.graphics;
  // From its own event, as all that is measured by events.
  QTimer::singleShot(0, this, [this] { measureVolume(); });
}

void Benchmark::measureVolume() {
  train_.measureVolume(plan_.quick ? 0.5 : 4, [this](const train::VolumeRates& rates) {
    add(QStringLiteral("volume_orbit_frames_per_second"), rates.orbitPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("volume_zoom_frames_per_second"), rates.zoomPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("volume_probe_frames_per_second"), rates.followPerSecond, QStringLiteral("1/s"));
    add(QStringLiteral("volume_exact_after"), rates.exact_ms, QStringLiteral("ms"));
    for (const auto& [name, holds] :
         {std::pair{"volume_hold_moving_%1", rates.moving}, {"volume_hold_at_rest_%1", rates.rest}}) {
      add(QString::fromLatin1(name).arg(QStringLiteral("median")), holds.median_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("least")), holds.least_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("longest")), holds.longest_ms, QStringLiteral("ms"));
      add(QString::fromLatin1(name).arg(QStringLiteral("processor_longest")), holds.processor_ms, QStringLiteral("ms"));
    }
    // Not from within what is being measured.
    QTimer::singleShot(0, this, [this] { measureMemory(); });
  });
}

/// Of Train, and of Prepare with its own ultrasound while Train is hidden.
void Benchmark::measureMemory() {
  add(QStringLiteral("memory_train"), memory_MB("VmRSS"), QStringLiteral("MB"));
  window_.showWorkspace(QStringLiteral("prepare"));
  QTimer::singleShot(plan_.quick ? 0 : kSettlePrepare_ms, this, [this] {
    add(QStringLiteral("memory_prepare"), memory_MB("VmRSS"), QStringLiteral("MB"));
    add(QStringLiteral("memory_peak"), memory_MB("VmHWM"), QStringLiteral("MB"));
    write();
  });
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
      trouble_ = QString::fromStdString(written.error().message);
  done_(trouble_);
}

}  // namespace insonate::app

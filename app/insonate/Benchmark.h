#pragma once

#include "FirstImage.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace insonate::prepare {
class PrepareWorkspace;
struct LabelingTime;
}  // namespace insonate::prepare
namespace insonate::train {
class TrainWorkspace;
}
namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

struct BenchmarkPlan {
  std::filesystem::path folder;  ///< folder for the results: window.json and window.csv
  std::string caseFolder;        ///< case to open; empty: the built-in neck
  /// True: measurements are too short for meaningful values; for testing that the benchmark runs.
  bool quick = false;
};

/// Benchmark of the program's window: time to the first image, rate of live images, time to the image after a jump
/// of the probe, frame rate of 3D with and without
/// the volume-rendered CT, memory, and speed of labeling a CT of 512 x 512 x 300 voxels. Writes and prints a table.
class Benchmark : public QObject {
 public:
  /// Starts the benchmark. The window must already show the workspace Train without a case; the benchmark opens the
  /// case. `done` receives an empty string or, if no table was written, an error message.
  Benchmark(ui::MainWindow& window, train::TrainWorkspace& train, prepare::PrepareWorkspace& prepare,
            BenchmarkPlan plan, std::function<void(const QString& error)> done);

 private:
  struct Row {
    QString name, unit;
    double value;
  };
  void timeStarts();
  double startOnce(const QString& cache, bool withCase);
  void opened();
  void measureLive(bool follows);
  void measureJumps();
  void measureHands();
  void measureOrbit();
  void measureVolume();
  void measureMemory();
  void openLarge();
  void whenReady(std::function<void()> go);
  void labeled(const std::vector<prepare::LabelingTime>& times);
  void add(const QString& name, double value, const QString& unit) { rows_.push_back({name, unit, value}); }
  void write();

  ui::MainWindow& window_;
  train::TrainWorkspace& train_;
  prepare::PrepareWorkspace& prepare_;
  const BenchmarkPlan plan_;
  std::function<void(const QString&)> done_;
  QElapsedTimer opening_;
  double empty_MB_ = 0;  ///< memory of the process without a case
  std::unique_ptr<FirstImage> first_;
  std::vector<Row> rows_;
  QString graphics_, error_;
};

}  // namespace insonate::app

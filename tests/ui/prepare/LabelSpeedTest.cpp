#include "ToolsWindow.h"

#include <insonate/core/ProcessorTime.h>

#include <malloc.h>
#include <ui/support/Pauses.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

namespace insonate::prepare {
namespace {

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
  return values[values.size() / 2];
}

/// "VmRSS" or "VmHWM" of this process.
double memory_MB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size() + 1)) / 1024;
  return 0;
}

/// A body of soft tissue with a core that is as bright as bone, as large as CTs are.
std::shared_ptr<const PatientCase> large() {
  VolumeGeometry grid;
  grid.size = {512, 512, 300};
  grid.spacing_mm = {0.5, 0.5, 0.7};
  auto made = std::make_shared<PatientCase>(PatientCase{{}, CtVolume(grid, -1000), LabelMap(grid)});
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 60; j < 452; ++j)
      for (int i = 60; i < 452; ++i) {
        const bool core = i > 230 && i < 280 && j > 230 && j < 280;
        made->ct.at(i, j, k) = std::int16_t(core ? 900 : 40 + (i * 7 + j * 13 + k * 5) % 31);
        made->labels.at(i, j, k) = core ? kBone : kSoftTissue;
      }
  return made;
}

class LabelSpeed : public Tools {
 protected:
  void SetUp() override { PrepareWindow::SetUp(); }
  int renderings() { return child<ui::ViewWidget>("Axial slice")->renderings(); }
  /// Processor time until the slices show what an action has changed.
  template <class Action>
  double cost_ms(Action action) {
    QTest::qWait(30);
    const int before = renderings();
    const double start_ms = processTime_ms();
    action();
    EXPECT_TRUE(QTest::qWaitFor([&] { return renderings() > before; }, kPatience_ms));
    return processTime_ms() - start_ms;
  }
};

TEST_F(LabelSpeed, OfALargeCase) {
  const double before_MB = memory_MB("VmRSS:");
  const auto patient = large();
  const double volumes_MB = double(patient->ct.voxels.size()) * 3 / (1 << 20);
  workspace_->setCase(patient);
  // Surfaces and ultrasound have tables of their own.
  workspace_->stop();
  shared_->structures.add(kArtery);
  QTest::qWait(500);
  const Vec3 middle = patient->ct.geometry.center_mm();
  std::vector<double> slices, dabs;
  for (int n = 1; n <= 30; ++n)
    slices.push_back(cost_ms([&] { shared_->crosshair.moveTo(middle + Vec3{0.5 * n, -0.5 * n, 0.7 * n}); }));
  key(Qt::Key_1);
  const auto at = [&](int n) { return pointOf(shared_->crosshair.position_mm() + Vec3{-30.0 + 1.5 * n, 10, 0}); };
  QWidget* axialCanvas = canvas("Axial slice");
  QTest::qWait(500);
  const double first = cost_ms([&] { QTest::mousePress(axialCanvas, Qt::LeftButton, {}, at(0)); });
  for (int n = 1; n < 30; ++n)
    dabs.push_back(cost_ms([&] {
      QMouseEvent move(QEvent::MouseMove, at(n), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(axialCanvas, &move);
    }));
  QTest::mouseRelease(axialCanvas, Qt::LeftButton, {}, at(29));
  EXPECT_GT(count(kArtery), 1000u);
  key(Qt::Key_5);
  std::vector<double> previews;
  auto& preview = shared_->labeling.preview();
  ASSERT_TRUE(QTest::qWaitFor([&] { return preview.proposal() != nullptr; }, kPatience_ms));
  for (int n = 0; n < 9; ++n) {
    QTest::qWait(1500);
    const auto shown = preview.proposal();
    const double start_ms = processTime_ms();
    child<QSpinBox>("tool-from")->setValue(300 + 5 * n);
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview.proposal() != shown; }, kPatience_ms));
    previews.push_back(processTime_ms() - start_ms);
  }
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  std::printf(
      "512x512x300, processor time: change of all slices %.0f ms, first dab %.0f ms, dab %.0f ms, threshold "
      "preview %.0f ms; memory %.1f times the volumes\n",
      median(slices), first, median(dabs), median(previews), (memory_MB("VmHWM:") - before_MB) / volumes_MB);
}

/// Ten tools that shape what is labeled, one after the other.
std::vector<LabelTool> filters() {
  return {step::Median{1},      step::Opening{1},
          step::Closing{1},     step::Gaussian{1},
          step::Margin{1},      step::Margin{-1},
          step::Hollow{1},      step::Closing{2},
          step::KeepLargest{1}, step::SmoothTogether{1, {kBone, kArtery}}};
}

/// Everything that follows edits is on.
class LongEditing : public LabelSpeed {
 protected:
  void SetUp() override {
    // As the program has it: what is large is the system's again at once.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    LabelSpeed::SetUp();
  }
  void stroke(int number) {
    const auto at = [&](int n) {
      return pointOf(shared_->crosshair.position_mm() +
                     Vec3{-50 + 5.0 * (number % 20) + n, -30 + 6.0 * (number / 20), 0});
    };
    QWidget* axialCanvas = canvas("Axial slice");
    QTest::mousePress(axialCanvas, Qt::LeftButton, {}, at(0));
    for (int n = 1; n < kDabs; ++n) {
      QMouseEvent move(QEvent::MouseMove, at(n), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(axialCanvas, &move);
      QTest::qWait(5);
    }
    QTest::mouseRelease(axialCanvas, Qt::LeftButton, {}, at(kDabs - 1));
  }
  void filter(const LabelTool& tool) {
    LabelStep step;
    step.tool = tool;
    step.label = kArtery;
    shared_->labeling.run(step, "filter");
    ASSERT_TRUE(done());
    QTest::qWait(1000);
  }
  /// Times the volumes, once surfaces, image and check have followed.
  double held(double volumes_MB) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
    return memory_MB("VmRSS:") / volumes_MB;
  }

 private:
  static constexpr int kDabs = 5;
};

TEST_F(LongEditing, KeepsItsMemory) {
  constexpr int kStrokes = 200, kUndos = 50;
  const auto patient = large();
  const double volumes_MB = double(patient->ct.voxels.size()) * 3 / (1 << 20);
  openCase(patient);
  shared_->structures.add(kArtery);
  key(Qt::Key_1);
  const double opened = held(volumes_MB);
  test::Pauses pauses;
  for (int n = 0; n < kStrokes / 2; ++n) stroke(n);
  const double early = held(volumes_MB);
  for (int n = kStrokes / 2; n < kStrokes; ++n) stroke(n);
  const double painted = held(volumes_MB), strokes_ms = pauses.longest_ms();
  for (int n = 0; n < kUndos; ++n) {
    shared_->openCase.undoStack().undo();
    QTest::qWait(20);
  }
  const double undone = held(volumes_MB), undos_ms = pauses.longest_ms();
  EXPECT_GT(count(kArtery), 1000u);
  for (const LabelTool& tool : filters()) filter(tool);
  const double end = held(volumes_MB), filters_ms = pauses.longest_ms();
  const double undo_MB = double(shared_->labeling.undoBytes()) / (1 << 20);
  std::printf(
      "512x512x300, longest work of the window's thread: %d strokes %.0f ms, %d undos %.0f ms, ten filters %.0f ms; "
      "memory in times the volumes: opened %.1f, after 100 strokes %.1f, 200 %.1f, undone %.1f, filtered %.1f, at "
      "most %.1f; undo %.1f MB\n",
      kStrokes, strokes_ms, kUndos, undos_ms, filters_ms, opened, early, painted, undone, end,
      memory_MB("VmHWM:") / volumes_MB, undo_MB);
  // A map that was kept by each tool would make it 3.3 more.
  // The program and its libraries are counted, too, which take 0.6; a map more is 0.3.
  EXPECT_LT(std::max({early, painted, undone, end}), 4);
}

}  // namespace
}  // namespace insonate::prepare

#include "ToolsWindow.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

namespace insonate::prepare {
namespace {

/// Processor time of all threads, ms: others may be at work beside this.
double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + double(now.tv_nsec) / 1e6;
}

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
    const double start_ms = processor_ms();
    action();
    EXPECT_TRUE(QTest::qWaitFor([&] { return renderings() > before; }, kPatience_ms));
    return processor_ms() - start_ms;
  }
};

TEST_F(LabelSpeed, OfALargeCase) {
  const double before_MB = memory_MB("VmRSS:");
  const auto patient = large();
  const double volumes_MB = double(patient->ct.voxels.size()) * 3 / (1 << 20);
  workspace_->setCase(patient);
  // Surfaces and ultrasound have tables of their own.
  session_->stop();
  session_->addStructure(kArtery);
  QTest::qWait(500);
  const Vec3 middle = patient->ct.geometry.centre_mm();
  std::vector<double> slices, dabs;
  for (int n = 1; n <= 30; ++n)
    slices.push_back(cost_ms([&] { session_->setCrosshair(middle + Vec3{0.5 * n, -0.5 * n, 0.7 * n}); }));
  key(Qt::Key_1);
  const auto at = [&](int n) { return pointOf(session_->crosshair_mm() + Vec3{-30.0 + 1.5 * n, 10, 0}); };
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
  auto& preview = session_->labelling().preview();
  ASSERT_TRUE(QTest::qWaitFor([&] { return preview.proposal() != nullptr; }, kPatience_ms));
  for (int n = 0; n < 9; ++n) {
    QTest::qWait(1500);
    const auto shown = preview.proposal();
    const double start_ms = processor_ms();
    child<QSpinBox>("tool-from")->setValue(300 + 5 * n);
    ASSERT_TRUE(QTest::qWaitFor([&] { return preview.proposal() != shown; }, kPatience_ms));
    previews.push_back(processor_ms() - start_ms);
  }
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  std::printf(
      "512x512x300, processor time: change of all slices %.0f ms, first dab %.0f ms, dab %.0f ms, threshold "
      "preview %.0f ms; memory %.1f times the volumes\n",
      median(slices), first, median(dabs), median(previews), (memory_MB("VmHWM:") - before_MB) / volumes_MB);
}

}  // namespace
}  // namespace insonate::prepare

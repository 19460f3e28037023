#include "Neck.h"
#include "ui/support/Screen.h"

#include <insonate/surface/ExtractSurface.h>
#include <insonate/tissue/Labels.h>
#include <insonate/views/DrawingThread.h>
#include <insonate/views/SceneTiming.h>
#include <insonate/views/SceneView.h>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <semaphore>
#include <set>
#include <thread>

namespace insonate::views {
namespace {

using namespace std::chrono_literals;
using test::Picture;
using test::Screen;

/// Counts its images, each of which waits until it is let go.
class Slow final : public View {
 public:
  bool canDrawOnThread() const override { return true; }
  int told = 0;
  std::vector<int> drawn;  ///< what was told with each
  std::atomic<int> begun{0};
  std::counting_semaphore<> go{0};

 protected:
  void layout() override {}
  void publishState() override { handed_ = told; }
  void adoptState() override { taken_ = handed_; }
  void draw() override {
    ++begun;
    go.acquire();
    drawn.push_back(taken_);
    View::draw();
  }

 private:
  int handed_ = 0, taken_ = 0;
};

bool waitFor(const auto& condition) {
  const auto end = std::chrono::steady_clock::now() + 60s;
  while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
  return condition();
}

TEST(DrawingThread, NobodyWaitsAndTheLatestWishCounts) {
  Slow view;
  view.resize(40, 30);
  std::atomic<int> heard{0};
  DrawingThread thread(view, [&] { ++heard; });
  view.told = 1;
  EXPECT_EQ(thread.requestFrame(), 1U);
  ASSERT_TRUE(waitFor([&] { return view.begun == 1; }));
  for (view.told = 2; view.told < 9; ++view.told) thread.requestFrame();
  DrawingThread::Drawn drawn;
  EXPECT_FALSE(thread.takeFrame(drawn)) << "nothing is there yet";
  view.go.release();
  ASSERT_TRUE(waitFor([&] { return heard == 1; }));
  ASSERT_TRUE(thread.takeFrame(drawn));
  EXPECT_EQ(drawn.wish, 1U);
  EXPECT_EQ(drawn.pixels.width, 40);
  EXPECT_EQ(drawn.pixels.height, 30);
  EXPECT_FALSE(thread.takeFrame(drawn)) << "each picture once";
  view.go.release();
  ASSERT_TRUE(waitFor([&] { return heard == 2; }));
  ASSERT_TRUE(thread.takeFrame(drawn));
  EXPECT_EQ(drawn.wish, 8U);
  EXPECT_EQ(view.drawn, (std::vector{1, 8}));
}

std::set<int> threads() {
  std::set<int> ids;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task"))
    ids.insert(std::stoi(entry.path().filename()));
  return ids;
}

TEST(DrawingThread, ItsThreadsComeBehindTheWindowsWhereAsked) {
  const std::set<int> before = threads();
  Slow view;
  view.lowerThreadPriority();
  DrawingThread thread(view, [] {});
  view.go.release();
  view.render();
  int more = 0;
  for (const int id : threads()) {
    if (before.contains(id)) continue;
    ++more;
    EXPECT_GT(getpriority(PRIO_PROCESS, id_t(id)), getpriority(PRIO_PROCESS, id_t(gettid()))) << id;
  }
  EXPECT_GE(more, 1);
}

TEST(DrawingThread, RenderingWaitsForIt) {
  Slow view;
  DrawingThread thread(view, [] {});
  view.go.release(2);
  view.told = 5;
  view.render();
  EXPECT_EQ(view.drawn, std::vector{5});
  view.told = 6;
  view.render();
  EXPECT_EQ(view.drawn, (std::vector{5, 6}));
}

void addNeck(SceneView& view) {
  const PatientCase& patient = *test::neck().patient;
  view.setCase(test::neck().shown);
  for (const Label label : {kArtery, kVein, kThyroid}) {
    const Mesh mesh = extractSurface(patient.labels, label, {4, 1.5}).value();
    view.setSurface(label, {mesh.points_mm, mesh.normals, mesh.triangles});
  }
  view.setProbe(test::neck().setup.probe, test::neck().setup.settings);
  view.setProbePose(test::neck().patientFromProbe);
  view.setImage(test::neck().image);
}

/// Number of pixels that differ by more than a little.
int differing(const Picture& a, const Pixels& b) {
  if (a.width != b.width || a.height != b.height) return -1;
  int count = 0;
  for (std::size_t k = 0; k < b.argb.size(); ++k)
    for (int channel = 0; channel < 3; ++channel)
      count += std::abs(int(a.rgb[3 * k + std::size_t(channel)]) - int(b.argb[k] >> (16 - 8 * channel) & 255)) > 8;
  return count;
}

TEST(DrawingThread, AScenesPictureIsTheSame) {
  SceneView here, there;
  addNeck(here), addNeck(there);
  Screen screen(here, 200, 160);
  there.resize(200, 160);
  DrawingThread thread(there, [] {});
  DrawingThread::Drawn drawn;
  const auto same = [&] {
    thread.drawNow();
    return thread.takeFrame(drawn) && differing(screen.picture(), drawn.pixels) == 0;
  };
  EXPECT_TRUE(same());
  for (SceneView* view : {&here, &there}) view->orbit(30, 20);
  EXPECT_TRUE(same()) << "turned";
  for (SceneView* view : {&here, &there}) view->setClipping({ClippingKind::Axial, 3, true});
  EXPECT_TRUE(same()) << "cut open";
  for (SceneView* view : {&here, &there}) view->setColor(kVein, {250, 250, 0}), view->setVisible(kArtery, false);
  EXPECT_TRUE(same()) << "coloured";
  for (SceneView* view : {&here, &there}) view->setSurface(kThyroid, {}), view->setProbe(std::nullopt);
  EXPECT_TRUE(same()) << "less of it";
  for (SceneView* view : {&here, &there}) view->setStereo(Stereo::Anaglyph);
  EXPECT_TRUE(same()) << "for two eyes";
  EXPECT_FALSE(there.rendererName().empty());
  EXPECT_TRUE(there.isExact());
}

TEST(DrawingThread, ASceneIsToldThingsWhileItIsDrawn) {
  SceneView view;
  addNeck(view);
  view.resize(160, 120);
  view.setCtVisible(true);
  std::atomic<int> heard{0};
  {
    DrawingThread thread(view, [&] { ++heard; });
    const Vec3 vein = test::neck().patient->manifest.targets.front().position_mm;
    for (int step = 0; step < 300 || heard < 5; ++step) {
      view.setMoving(step % 20 < 12);
      view.orbit(2, 0.5);
      view.setColor(kVein, {std::uint8_t(step % 200), 10, 200});
      view.setImage(test::neck().image);
      view.setClipping({ClippingKind::Axial, double(step % 9), step % 2 == 0});
      if (step % 50 == 7) view.setCase(step % 100 == 7 ? nullptr : test::neck().shown);
      EXPECT_TRUE(std::isfinite(view.displayFromPatient(vein).x));
      view.pick({80, 60});
      thread.requestFrame();
      std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(timeOrbit(view, 2).moving_ms.size(), 2U);
  }
  Screen screen(view, 160, 120);
  EXPECT_EQ(screen.picture().width, 160) << "after that it is drawn by who likes";
}

}  // namespace
}  // namespace insonate::views

#include "Waiting.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/views/View.h>

#include <gtest/gtest.h>
#include <vtkRenderWindow.h>

#include <QGridLayout>
#include <QImage>
#include <QSplitter>
#include <QTimer>
#include <QWheelEvent>
#include <QtTest/QTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <semaphore>
#include <vector>

namespace {

using namespace insonate;
using test::waitUntil;

/// Remembers what it was told and paints itself green.
class FakeView final : public views::View {
 public:
  bool pressed(const views::Pointer& p) override { return pointers.push_back(p), true; }
  bool moved(const views::Pointer& p) override { return last = p, true; }
  bool released(const views::Pointer& p) override { return pointers.push_back(p), true; }
  bool wheel(const views::Pointer&, double notches) override { return turned += notches, true; }
  bool key(views::Key key) override { return keys.push_back(key), key == views::Key::G; }
  void want() { changed(); }

  std::vector<views::Pointer> pointers;
  views::Pointer last;
  std::vector<views::Key> keys;
  double turned = 0;
  int layouts = 0;

 protected:
  void layout() override {
    ++layouts;
    renderer()->SetBackground(0, 1, 0);
  }
};

class ViewWidget : public testing::Test {
 protected:
  ViewWidget() {
    auto* grid = new QGridLayout(&room);
    view = std::make_shared<FakeView>();
    widget = new ui::ViewWidget(view, "Axial");
    neighbor = new ui::ViewWidget(std::make_shared<FakeView>(), "Coronal");
    grid->addWidget(widget, 0, 0);
    grid->addWidget(neighbor, 0, 1);
    room.resize(600, 300);
    room.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&room));
    EXPECT_TRUE(waitUntil([this] { return view->layouts > 0; }));
  }
  QWidget* canvas(QWidget* of) { return of->focusProxy(); }

  QWidget room;
  std::shared_ptr<FakeView> view;
  ui::ViewWidget *widget, *neighbor;
};

TEST_F(ViewWidget, ShowsNothingOfWhatWasThereBefore) {
  const auto green = [this](QPoint at) { return widget->grab().toImage().pixelColor(at).green() > 200; };
  const auto black = [this](QPoint at) { return widget->grab().toImage().pixelColor(at) == QColor(Qt::black); };
  const QPoint middle = widget->rect().center();
  ASSERT_TRUE(waitUntil([&] { return green(middle); }));
  widget->forget();
  EXPECT_TRUE(black(middle)) << "at once, before it is drawn again";
  EXPECT_TRUE(waitUntil([&] { return green(middle); }));
  room.layout()->setEnabled(false);
  widget->resize(widget->size() + QSize(80, 40));
  EXPECT_TRUE(black(widget->rect().bottomRight() - QPoint(20, 10))) << "where no picture is yet";
}

TEST_F(ViewWidget, ShowsWhatChangedWhileItWasHidden) {
  QTest::qWait(100);
  room.hide();
  view->want();
  QTest::qWait(60);
  const int before = widget->renderings();
  room.show();
  EXPECT_TRUE(waitUntil([&] { return widget->renderings() > before; }, 2000));
}

TEST_F(ViewWidget, ShowsWhatTheViewDraws) {
  const QImage seen = room.grab().toImage();
  EXPECT_EQ(seen.pixelColor(widget->geometry().center()), QColor(0, 255, 0));
}

TEST_F(ViewWidget, TellsTheSizeInDevicePixels) {
  const double ratio = widget->devicePixelRatioF();
  EXPECT_EQ(view->width_px(), int(std::lround(canvas(widget)->width() * ratio)));
  EXPECT_EQ(view->height_px(), int(std::lround(canvas(widget)->height() * ratio)));
}

TEST_F(ViewWidget, HandsOnMouseWheelAndKeys) {
  const double ratio = widget->devicePixelRatioF();
  QTest::mousePress(canvas(widget), Qt::RightButton, Qt::ShiftModifier, {10, 20});
  QTest::mouseRelease(canvas(widget), Qt::RightButton, Qt::ShiftModifier, {12, 20});
  ASSERT_EQ(view->pointers.size(), 2U);
  EXPECT_EQ(view->pointers[0].button, views::Button::Right);
  EXPECT_TRUE(view->pointers[0].shift);
  EXPECT_FALSE(view->pointers[0].control);
  EXPECT_NEAR(view->pointers[0].at.x, 10.5 * ratio, 1e-9);
  EXPECT_NEAR(view->pointers[1].at.x, 12.5 * ratio, 1e-9);
  QWheelEvent wheel({5, 5}, {5, 5}, {}, {0, -60}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(canvas(widget), &wheel);
  EXPECT_EQ(view->turned, -0.5);
  QTest::keyClick(canvas(widget), Qt::Key_G);
  QTest::keyClick(canvas(widget), Qt::Key_PageDown);
  QTest::keyClick(canvas(widget), Qt::Key_G, Qt::ControlModifier);
  EXPECT_EQ(view->keys, (std::vector{views::Key::G, views::Key::PageDown}));
}

TEST_F(ViewWidget, CollectsWishesToBeRendered) {
  QTest::qWait(100);
  const int before = widget->renderings();
  for (int i = 0; i < 1000; ++i) view->want();
  ASSERT_TRUE(waitUntil([&] { return widget->renderings() > before; }));
  EXPECT_EQ(widget->renderings(), before + 1);
}

TEST_F(ViewWidget, AfterARestItIsRenderedAtOnce) {
  const auto* timer = widget->findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_TRUE(timer);
  ASSERT_TRUE(waitUntil([&] { return !timer->isActive(); }));
  QTest::qWait(300);
  view->want();
  EXPECT_TRUE(timer->isActive());
  EXPECT_EQ(timer->interval(), 0) << "the rest of a frame that is long over";
}

TEST_F(ViewWidget, DoubleClickFillsTheRoomAndGivesItBack) {
  QTest::mouseDClick(canvas(widget), Qt::LeftButton, {}, {50, 50});
  EXPECT_TRUE(widget->isMaximized());
  EXPECT_FALSE(neighbor->isVisible());
  QTest::keyClick(canvas(widget), Qt::Key_Escape);
  EXPECT_FALSE(widget->isMaximized());
  EXPECT_TRUE(neighbor->isVisible());
  QTest::keyClick(canvas(widget), Qt::Key_M);
  EXPECT_FALSE(neighbor->isVisible());
}

TEST_F(ViewWidget, FillsTheMarkedRoomThroughSplitters) {
  QSplitter outer;
  ui::setMaximizeArea(&outer);
  auto* inner = new QSplitter(Qt::Vertical);
  outer.addWidget(inner);
  outer.addWidget(neighbor);
  auto* below = new QWidget;
  inner->addWidget(widget);
  inner->addWidget(below);
  outer.resize(600, 300);
  outer.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&outer));
  widget->setMaximized(true);
  EXPECT_FALSE(neighbor->isVisible());
  EXPECT_FALSE(below->isVisible());
  widget->setMaximized(false);
  EXPECT_TRUE(neighbor->isVisible());
  EXPECT_TRUE(below->isVisible());
}

TEST_F(ViewWidget, TheViewOutlivesItsWidget) {
  delete widget;
  view->want();
  view->render();
  QTest::qWait(50);
}

/// Drawn by a thread: in the color it was told, once it is let go.
class SlowView final : public views::View {
 public:
  bool canDrawOnThread() const override { return true; }
  void show(double color) {
    told_ = color;
    changed();
  }
  std::atomic<int> begun{0};
  std::atomic<bool> open{false};  ///< nothing is held any more
  std::counting_semaphore<> go{0};

 protected:
  void layout() override {}
  void publishState() override { handed_ = told_; }
  void adoptState() override { taken_ = handed_; }
  void draw() override {
    ++begun;
    while (!open && !go.try_acquire_for(std::chrono::milliseconds(5))) continue;
    renderer()->SetBackground(0, taken_, 0);
    View::draw();
  }

 private:
  double told_ = 1, handed_ = 0, taken_ = 0;
};

class ThreadedViewWidget : public testing::Test {
 protected:
  ThreadedViewWidget() {
    widget->resize(200, 160);
    widget->show();
    EXPECT_TRUE(waitUntil([this] { return view->begun == 1; }));
  }
  ~ThreadedViewWidget() override {
    view->open = true;
    widget.reset();
  }
  QColor middle() { return widget->grab().toImage().pixelColor(100, 80); }

  std::shared_ptr<SlowView> view = std::make_shared<SlowView>();
  std::unique_ptr<ui::ViewWidget> widget = std::make_unique<ui::ViewWidget>(view, "3D");
};

TEST_F(ThreadedViewWidget, TheWindowGoesOnWhileItIsDrawn) {
  EXPECT_TRUE(widget->isDrawing());
  EXPECT_EQ(middle().green(), 0);
  view->show(0.6);
  view->show(0.4);
  QTest::qWait(60);
  EXPECT_EQ(view->begun, 1) << "one at a time";
  view->go.release();
  ASSERT_TRUE(waitUntil([&] { return middle().green() == 255; })) << "as it was when the picture was begun";
  ASSERT_TRUE(waitUntil([&] { return view->begun == 2; }));
  view->go.release();
  ASSERT_TRUE(waitUntil([&] { return middle().green() == 102; })) << "what was told last, and nothing in between";
  EXPECT_TRUE(waitUntil([&] { return !widget->isDrawing(); }));
  EXPECT_EQ(view->begun, 2);
}

TEST_F(ThreadedViewWidget, APictureOnItsWayIsNotAskedForAgain) {
  EXPECT_EQ(middle(), QColor(Qt::black)) << "it is painted before it is there";
  view->go.release();
  ASSERT_TRUE(waitUntil([&] { return middle().green() == 255; }));
  QTest::qWait(60);
  EXPECT_EQ(view->begun, 1);
}

TEST_F(ThreadedViewWidget, APictureOfWhatIsForgottenIsNotShown) {
  widget->forget();
  view->show(0.4);
  view->go.release();
  ASSERT_TRUE(waitUntil([&] { return view->begun == 2; }));
  EXPECT_EQ(middle(), QColor(Qt::black));
  view->go.release();
  EXPECT_TRUE(waitUntil([&] { return middle().green() == 102; }));
}

TEST_F(ThreadedViewWidget, GoesWithAPictureInWork) {
  view->go.release();
  widget.reset();
  view->show(0.5);
  view->render();
  EXPECT_EQ(view->begun, 1) << "without a window there is nothing to draw";
}

}  // namespace

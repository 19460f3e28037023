#include "TrainWindow.h"
#include "image/ScaledPicture.h"

#include <QAction>

namespace insonate::train {
namespace {

/// Measurements are part of the saved image.
class SavedPicture : public TrainWindow {
 protected:
  /// 400 x 300 pixels of 0.1 mm, all gray; the probe's axis in the middle.
  static LiveFrame evenFrame() {
    LiveFrame frame;
    frame.image = {400, 300, 0.1, -20, 0, {}};
    frame.image.gray.assign(std::size_t(400) * 300, 60);
    frame.setup = std::make_shared<ImagingSetup>();
    return frame;
  }
  static int lightness(const QImage& picture, const BModeImage& image, double lateral_mm, double axial_mm) {
    const QPoint at(int(std::lround((lateral_mm - image.left_mm) / image.pixel_mm)),
                    int(std::lround((axial_mm - image.top_mm) / image.pixel_mm)));
    return qGray(picture.pixel(pictureOrigin(image) + at));
  }
};

TEST_F(SavedPicture, HasCalipersWhereTheyWereAndWhatTheyMeasureBelow) {
  const LiveFrame frame = evenFrame();
  const BModeImage& image = frame.image;
  const views::Caliper distance{views::CaliperKind::Distance, {{{-10, 5}, {-10, 15}}}};
  const views::Caliper ellipse{views::CaliperKind::Ellipse, {{{5, 20}, {15, 20}, {10, 23}}}};
  const views::Caliper angle{views::CaliperKind::Angle, {{{0, 5}, {0, 12}, {8, 12}}}};
  const QImage plain = scaledPicture(frame), measured = scaledPicture(frame, std::array{distance, ellipse, angle});
  EXPECT_EQ(plain.width(), measured.width());
  EXPECT_GT(measured.height(), plain.height() + 30) << "a line each";
  for (const auto& [x, z] :
       {std::pair(-10.0, 5.0), {-10.0, 15.0}, {10.0, 23.0}, {10.0, 17.0}, {4.0, 12.0}, {0.0, 8.0}}) {
    EXPECT_EQ(lightness(plain, image, x, z), 60);
    EXPECT_GT(lightness(measured, image, x, z), 180) << x << ", " << z;
  }
  EXPECT_EQ(lightness(measured, image, -16, 27), 60) << "else it is the picture";
  int written = 0;
  for (int y = plain.height(); y < measured.height(); ++y)
    for (int x = 0; x < measured.width(); ++x) written += qGray(measured.pixel(x, y)) > 120;
  EXPECT_GT(written, 100);
}

TEST_F(SavedPicture, HasTheScaleAndTheMarkerAtTheEdgesOfTheFieldOfView) {
  LiveFrame frame = evenFrame();
  auto setup = std::make_shared<ImagingSetup>();
  setup->probe = *loadProbe("linear");
  frame.setup = setup;
  const BeamGrid field(setup->probe, setup->settings);
  const double black_mm = field.minLateral_mm() - frame.image.left_mm;
  ASSERT_GT(black_mm, 0.5) << "else the test shows nothing";
  frame.image.gray.assign(frame.image.gray.size(), 0);
  const QImage picture = scaledPicture(frame);
  const QPoint origin = pictureOrigin(frame.image);
  const int left_px = origin.x() + int(std::lround(black_mm / 0.1));
  const int right_px = origin.x() + int(std::lround((field.maxLateral_mm() - frame.image.left_mm) / 0.1));
  int scale_px = 0, marker_px = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      if (qGray(picture.pixel(x, y)) < 60) continue;
      if (x < picture.width() / 2) scale_px = std::max(scale_px, x);
      marker_px = std::max(marker_px, x);
    }
  EXPECT_NEAR(scale_px, left_px - 5, 2);
  EXPECT_NEAR(marker_px, right_px, 2);
}

/// Saving a frozen image of a case.
class SavedFromTheWindow : public SavedPicture {
 protected:
  void SetUp() override {
    TrainWindow::SetUp();
    QObject::connect(workspace_.get(), &ui::Workspace::written, [this] { ++written_; });
    openCase();
    key(Qt::Key_Space);  // one and the same image
    plain_ = scaledPicture(*model_->live.shown());
  }
  void measure() {
    key(Qt::Key_L);
    const QPoint middle = canvas_->rect().center();
    drag(Qt::LeftButton, middle, middle + QPoint(60, 20));
  }
  using Save = void (TrainWorkspace::*)(const std::filesystem::path&);
  std::filesystem::path saved(const char* name, Save save) {
    const int before = written_;
    (*workspace_.*save)(folder_ / name);
    EXPECT_TRUE(QTest::qWaitFor([&] { return written_ > before; }, kPatience_ms)) << name;
    return folder_ / name;
  }
  QImage picture(const char* name) { return read(saved(name, &TrainWorkspace::saveImage)); }
  static QImage read(const std::filesystem::path& file) { return QImage(QString::fromStdString(file.string())); }

  test::TemporaryFolder folder_;
  int written_ = 0;
  QImage plain_;
};

TEST_F(SavedFromTheWindow, PictureHasTheMeasurementsUnlessTheyAreNotRequested) {
  EXPECT_EQ(picture("plain.png"), plain_);
  measure();
  const QImage measured = picture("measured.png");
  EXPECT_GT(measured.height(), plain_.height());
  EXPECT_NE(measured.copy(plain_.rect()), plain_);
  child<QAction>("withMeasurements")->trigger();
  EXPECT_EQ(picture("without.png"), plain_);
  child<QAction>("withMeasurements")->trigger();
  EXPECT_EQ(picture("with.png"), measured);
  key(Qt::Key_Delete);
  EXPECT_EQ(picture("again.png"), plain_);
}

TEST_F(SavedFromTheWindow, EveryPictureOfAClipHasTheMeasurementsUnlessTheyAreNotRequested) {
  measure();
  const QImage measured = picture("measured.png");
  for (const bool wanted : {true, false}) {
    const auto clip = saved(wanted ? "with" : "without", &TrainWorkspace::saveClip);
    const auto& frames = model_->live.cine();
    for (std::size_t n = 0; n < frames.size(); ++n) {
      char name[24];
      std::snprintf(name, sizeof name, "picture-%04d.png", int(n) + 1);
      const QImage frame = read(clip / name), without = scaledPicture(*frames[n]);
      EXPECT_EQ(frame == without, !wanted) << name;
      EXPECT_EQ(frame.height(), (wanted ? measured : without).height()) << name;
    }
    child<QAction>("withMeasurements")->trigger();
  }
}

TEST_F(SavedFromTheWindow, ScreenHasWhatStandsOverThePictureAndTheCtBesideIt) {
  const auto screen = [this](const char* name) { return read(saved(name, &TrainWorkspace::saveScreen)); };
  const QImage alone = screen("alone.png");
  EXPECT_EQ(alone.size(), canvas_->parentWidget()->size() * canvas_->devicePixelRatioF());
  measure();
  QTest::qWait(100);  // until it is drawn
  EXPECT_NE(screen("measured.png"), alone);
  key(Qt::Key_C);
  auto* beside = child<ui::ViewWidget>("ctBeside");
  ASSERT_TRUE(QTest::qWaitFor([&] { return beside->isVisible() && beside->renderings() > 0; }, kPatience_ms));
  const QImage both = screen("both.png");
  const QPoint slice = beside->geometry().center() * both.devicePixelRatioF();
  EXPECT_GT(qGray(both.pixel(slice)), 20) << "tissue of the CT";
}

}  // namespace
}  // namespace insonate::train

#include "TrainWindow.h"
#include "files/ScaledPicture.h"

namespace insonate::train {
namespace {

/// What is measured goes into the saved picture.
class SavedPicture : public TrainWindow {
 protected:
  /// 400 x 300 pixels of 0.1 mm, all grey; the probe's axis in the middle.
  static BModeImage evenImage() {
    BModeImage image{400, 300, 0.1, -20, 0, {}};
    image.grey.assign(std::size_t(400) * 300, 60);
    return image;
  }
  static int lightness(const QImage& picture, const BModeImage& image, double lateral_mm, double axial_mm) {
    const QPoint at(int(std::lround((lateral_mm - image.left_mm) / image.pixel_mm)),
                    int(std::lround((axial_mm - image.top_mm) / image.pixel_mm)));
    return qGray(picture.pixel(pictureOrigin(image) + at));
  }
};

TEST_F(SavedPicture, HasCallipersWhereTheyWereAndWhatTheyMeasureBelow) {
  const BModeImage image = evenImage();
  const views::Calliper distance{views::CalliperKind::Distance, {{{-10, 5}, {-10, 15}}}};
  const views::Calliper ellipse{views::CalliperKind::Ellipse, {{{5, 20}, {15, 20}, {10, 23}}}};
  const views::Calliper angle{views::CalliperKind::Angle, {{{0, 5}, {0, 12}, {8, 12}}}};
  const QImage plain = scaledPicture(image), measured = scaledPicture(image, std::array{distance, ellipse, angle});
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

TEST_F(SavedPicture, IsWrittenWithTheMeasurementsOfTheView) {
  test::TemporaryFolder folder;
  int written = 0;
  QObject::connect(workspace_.get(), &ui::Workspace::written, [&] { ++written; });
  openCase();
  key(Qt::Key_Space);  // one and the same picture
  const auto saved = [&](const char* name) {
    const int before = written;
    workspace_->savePicture(folder / name);
    EXPECT_TRUE(QTest::qWaitFor([&] { return written > before; }, kPatience_ms));
    return QImage(QString::fromStdString((folder / name).string()));
  };
  const QImage plain = saved("plain.png");
  EXPECT_EQ(plain, scaledPicture(session_->shown()->image));
  key(Qt::Key_L);
  const QPoint middle = canvas_->rect().center();
  drag(Qt::LeftButton, middle, middle + QPoint(60, 20));
  const QImage measured = saved("measured.png");
  EXPECT_GT(measured.height(), plain.height());
  EXPECT_NE(measured.copy(plain.rect()), plain);
  key(Qt::Key_Delete);
  EXPECT_EQ(saved("again.png"), plain);
}

}  // namespace
}  // namespace insonate::train

#include "TrainWindow.h"
#include "image/CineBar.h"
#include "image/ClipExport.h"
#include "image/ScaledPicture.h"
#include "unit/video/WebmReader.h"

#include <gdcmImageReader.h>
#include <gdcmSequenceOfItems.h>
#include <gmock/gmock.h>
#include <support/FullDisk.h>

#include <QFileDialog>
#include <QTimer>
#include <cstring>

namespace insonate::train {
namespace {

using testing::HasSubstr;

/// A DICOM clip as GDCM reads it.
struct ReadClip {
  explicit ReadClip(const std::filesystem::path& file) {
    reader.SetFileName(file.c_str());
    EXPECT_TRUE(reader.Read()) << file;
    const gdcm::Image& image = reader.GetImage();
    width = int(image.GetDimension(0)), height = int(image.GetDimension(1));
    frames = image.GetNumberOfDimensions() == 3 ? int(image.GetDimension(2)) : 1;
    bytes.resize(image.GetBufferLength());
    EXPECT_TRUE(image.GetBuffer(bytes.data()));
    channels = int(bytes.size() / (std::size_t(width) * std::size_t(height) * std::size_t(frames)));
  }
  /// Number of the ultrasound region.
  template <class T>
  T ofRegion(std::uint16_t element) const {
    const auto regions = reader.GetFile().GetDataSet().GetDataElement(gdcm::Tag(0x0018, 0x6011)).GetValueAsSQ();
    T value{};
    const auto* text = regions->GetItem(1).GetNestedDataSet().GetDataElement(gdcm::Tag(0x0018, element)).GetByteValue();
    std::memcpy(&value, text->GetPointer(), sizeof value);
    return value;
  }
  std::uint8_t at(int frame, int x, int y, int channel = 0) const {
    const std::size_t row = std::size_t(frame) * std::size_t(height) + std::size_t(y);
    const std::size_t pixel = row * std::size_t(width) + std::size_t(x);
    return std::uint8_t(bytes.at(pixel * std::size_t(channels) + std::size_t(channel)));
  }

  gdcm::ImageReader reader;
  int width = 0, height = 0, frames = 0, channels = 0;
  std::vector<char> bytes;
};

/// Images of 399 x 301 pixels of 0.1 mm; image n has the gray value 50 + 20 n.
class SavedClipTest : public testing::Test {
 protected:
  static std::shared_ptr<const LiveFrame> frameOf(int index, double time_s, double pixel_mm = 0.1) {
    auto frame = std::make_shared<LiveFrame>();
    frame->image = {399, 301, pixel_mm, -20, 0, {}};
    frame->image.gray.assign(std::size_t(399) * 301, std::uint8_t(50 + 20 * index));
    frame->time_s = time_s;
    auto setup = std::make_shared<ImagingSetup>();
    setup->probe.name = "linear";
    frame->setup = setup;
    return frame;
  }
  static SavedClip clipOf(std::vector<views::Caliper> calipers = {}) {
    return {{frameOf(0, 2), frameOf(1, 2.1), frameOf(2, 2.5)},
            std::move(calipers),
            std::make_shared<const PatientCase>(test::smallCase()),
            "seed"};
  }

  static std::string refusal(const std::filesystem::path& target, const Progress& progress = {}) {
    const auto written = writeClip(clipOf(), target, progress);
    return written ? "It was written." : written.error().message;
  }

  test::TemporaryFolder folder_;
};

TEST_F(SavedClipTest, AVideoShowsTheScaledImagesAtTheirTimes) {
  ASSERT_TRUE(writeClip(clipOf(), folder_ / "clip.webm", {}));
  const test::WebmReader read(folder_ / "clip.webm");
  const QSize size = scaledPicture(*frameOf(0, 0)).size();
  EXPECT_EQ(size, scaledPictureSize(frameOf(0, 0)->image, 0));
  EXPECT_EQ(read.width, size.width() + size.width() % 2);
  EXPECT_EQ(read.height, size.height() + size.height() % 2);
  ASSERT_EQ(read.frames.size(), 16U) << "half a second, and the last image";
  EXPECT_NEAR(read.duration_ms, 533, 1);
  const QPoint at = pictureOrigin(frameOf(0, 0)->image) + QPoint(200, 150);
  for (const auto& [frame, gray] : {std::pair<std::size_t, int>{1, 50}, {4, 70}, {14, 70}, {15, 90}})
    EXPECT_NEAR(read.frames[frame].luma[std::size_t(at.y() * read.width + at.x())], gray, 3) << frame;
}

TEST_F(SavedClipTest, ADicomClipHasTheGrayValuesAndTheScale) {
  ASSERT_EQ(writeClip(clipOf(), folder_ / "clip.dcm", {}), 3);
  const ReadClip read(folder_ / "clip.dcm");
  EXPECT_EQ(read.width, 399);
  EXPECT_EQ(read.height, 301);
  EXPECT_EQ(read.channels, 1);
  ASSERT_EQ(read.frames, 3);
  for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(read.at(frame, 398, 300), 50 + 20 * frame);
  EXPECT_EQ(read.ofRegion<std::uint16_t>(0x6024), 3) << "cm";
  EXPECT_DOUBLE_EQ(read.ofRegion<double>(0x602c), 0.01);
  EXPECT_DOUBLE_EQ(read.ofRegion<double>(0x602e), 0.01);
}

TEST_F(SavedClipTest, AMeasuredDistanceIsAsLongInTheDicomClip) {
  const views::Caliper distance{views::CaliperKind::Distance, {{{-10, 5}, {-10, 15}}}};
  ASSERT_TRUE(writeClip(clipOf({distance}), folder_ / "clip.dcm", {}));
  const ReadClip read(folder_ / "clip.dcm");
  EXPECT_EQ(QSize(read.width, read.height), scaledPictureSize(frameOf(0, 0)->image, 1));
  EXPECT_EQ(read.channels, 3);
  const QImage expected = scaledPicture(*frameOf(1, 0), std::array{distance});
  for (const QPoint at : {QPoint(0, 0), QPoint(70, 90), QPoint(read.width - 1, read.height - 1)})
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_EQ(read.at(1, at.x(), at.y(), channel),
                QColor(expected.pixel(at)).toRgb().rgb() >> (16 - 8 * channel) & 255);
  const double delta_mm = 10 * read.ofRegion<double>(0x602c);
  const auto columnOf = [&](double lateral_mm) {
    const double ofRegion_mm = lateral_mm - 10 * read.ofRegion<double>(0x6028);
    return int(std::lround(read.ofRegion<std::uint32_t>(0x6018) + ofRegion_mm / delta_mm));
  };
  const auto rowOf = [&](double depth_mm) {
    const double ofRegion_mm = depth_mm - 10 * read.ofRegion<double>(0x602a);
    return int(std::lround(read.ofRegion<std::uint32_t>(0x601a) + ofRegion_mm / delta_mm));
  };
  EXPECT_GT(read.at(0, columnOf(-10), rowOf(5), 1), 180) << "the ends of the caliper";
  EXPECT_GT(read.at(0, columnOf(-10), rowOf(15), 1), 180);
  EXPECT_NEAR((rowOf(15) - rowOf(5)) * delta_mm, 10, delta_mm);
  EXPECT_EQ(read.at(0, columnOf(10), rowOf(10), 1), 50) << "the image";
}

TEST_F(SavedClipTest, ADicomClipBeginsAfterTheLastChangeOfTheScale) {
  SavedClip clip = clipOf();
  clip.frames.insert(clip.frames.begin(), frameOf(3, 1.9, 0.2));
  ASSERT_EQ(writeClip(clip, folder_ / "clip.dcm", {}), 3);
  EXPECT_EQ(ReadClip(folder_ / "clip.dcm").frames, 3);
  clip.frames.push_back(frameOf(3, 2.6, 0.2));
  ASSERT_EQ(writeClip(clip, folder_ / "one.dcm", {}), 1) << "one image is a clip, too";
  const ReadClip one(folder_ / "one.dcm");
  EXPECT_EQ(one.frames, 1);
  EXPECT_DOUBLE_EQ(one.ofRegion<double>(0x602c), 0.02);
  ASSERT_EQ(writeClip(clip, folder_ / "all.webm", {}), 5);
  EXPECT_EQ(test::WebmReader(folder_ / "all.webm").frames.size(), 22U);
}

TEST_F(SavedClipTest, NothingIsLeftAfterAFailure) {
  for (const char* name : {"clip.webm", "clip.dcm", "clip"}) {
    const auto stop = [](std::string_view, double fraction) { return fraction < 0.3; };
    EXPECT_EQ(refusal(folder_ / name, stop), kCancelled) << name;
    {
      const test::FullDisk full(100);
      EXPECT_THAT(refusal(folder_ / name), HasSubstr("disk is full")) << name;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << name;
    if (std::string(name) == "clip") continue;
    EXPECT_THAT(refusal(folder_ / "none" / name), HasSubstr("does not exist")) << name;
  }
}

class SavedClipFromTheWindow : public TrainWindow {
 protected:
  test::TemporaryFolder folder_;
};

/// The user chooses the format by the filter or by the ending of the name.
TEST_F(SavedClipFromTheWindow, TheDialogOffersTheFormats) {
  QString written, place;
  QObject::connect(workspace_.get(), &ui::Workspace::written,
                   [&](const QString& what, const QString& where) { written = what, place = where; });
  openCase();
  const auto save = [&](const QString& filter, const QString& name) {
    written.clear();
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&] {
      auto* dialog = workspace_->findChild<QFileDialog*>();
      if (!dialog || !dialog->isVisible()) return;
      answer.stop();
      EXPECT_THAT(dialog->nameFilters().join("|").toStdString(),
                  "Video (*.webm)|DICOM ultrasound clip (*.dcm)|Images (*.png)");
      if (!filter.isEmpty()) {
        dialog->selectNameFilter(filter);
        Q_EMIT dialog->filterSelected(filter);
      }
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString((folder_ / "").string()) + name);
      QMetaObject::invokeMethod(dialog, "accept");
    });
    answer.start(20);
    Q_EMIT workspace_->findChild<CineBar*>()->saveClip();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !written.isEmpty(); }, kPatience_ms)) << name.toStdString();
  };
  save("DICOM ultrasound clip (*.dcm)", "first");
  EXPECT_EQ(written, "Clip saved as first.dcm.");
  EXPECT_EQ(ReadClip(folder_ / "first.dcm").frames, int(model_->live.cine().size()));
  EXPECT_EQ(place, QString::fromStdString(folder_.path().string()));
  save("", "second");
  EXPECT_EQ(written, "Clip saved as second.dcm.") << "the last format is offered again";
  save("", "third.webm");
  EXPECT_GE(test::WebmReader(folder_ / "third.webm").frames.size(), 1U);
  save("Video (*.webm)", "neck 2.5");
  EXPECT_EQ(written, "Clip saved as neck 2.5.webm.");
  save("Images (*.png)", "fifth");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "fifth" / "picture-0001.png"));
}

}  // namespace
}  // namespace insonate::train

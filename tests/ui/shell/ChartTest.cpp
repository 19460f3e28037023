#include <insonate/ui/Chart.h>

#include <gtest/gtest.h>
#include <qwt_plot.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest/QTest>
#include <algorithm>

namespace insonate::ui {
namespace {

using Tone = ChartContents::Tone;

ChartContents rising() {
  ChartContents picture;
  picture.title = QStringLiteral("<b>Path</b> & \"way\"");
  picture.xTitle = QStringLiteral("attempt"), picture.yTitle = QStringLiteral("mm");
  picture.bands.push_back({QStringLiteral("expert"), {{1, 0}, {9, 0}}, {{1, 20}, {9, 20}}, Tone::Good});
  picture.lines.push_back({QStringLiteral("<i>A</i>"), {{1, 80}, {5, 50}, {9, 30}}, Tone::Danger, Qt::SolidLine, true});
  return picture;
}

int pixelsOf(const QImage& image, const QColor& color) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor one = image.pixelColor(x, y);
      count += std::abs(one.red() - color.red()) + std::abs(one.green() - color.green()) +
                   std::abs(one.blue() - color.blue()) <
               24;
    }
  return count;
}

class ChartTest : public testing::Test {
 protected:
  QTemporaryDir folder_;
};

TEST_F(ChartTest, IsSavedAsPictureDrawingAndPage) {
  Chart chart;
  chart.show(rising());
  const QSignalSpy written(&chart, &Chart::written);
  for (const char* ending : {"png", "svg", "PDF"})
    chart.save(folder_.filePath(QStringLiteral("plot.") + QLatin1String(ending)));
  ASSERT_EQ(written.count(), 3);
  const QImage image(folder_.filePath("plot.png"));
  EXPECT_EQ(image.size(), QSize(1600, 1000));
  EXPECT_EQ(image.pixelColor(2, 2), QColor(Qt::white)) << "paper";
  EXPECT_GT(pixelsOf(image, QColor(0xb3, 0x26, 0x1e)), 1500) << "the line in paper's red";
  QFile svg(folder_.filePath("plot.svg"));
  ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&svg);
  int texts = 0;
  while (!xml.atEnd()) texts += xml.readNext() == QXmlStreamReader::StartElement && xml.name() == "text";
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  EXPECT_GT(texts, 5) << "letters, not outlines";
  QFile pdf(folder_.filePath("plot.PDF"));
  ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
  EXPECT_TRUE(pdf.readAll().startsWith("%PDF"));
}

TEST_F(ChartTest, WhatCannotBeSavedSaysWhy) {
  Chart chart;
  chart.show(rising());
  const QSignalSpy failed(&chart, &Chart::failed);
  chart.save(folder_.filePath("plot.doc"));
  chart.save(folder_.filePath("nowhere/plot.png"));
  ASSERT_EQ(failed.count(), 2);
  EXPECT_TRUE(failed[0][0].toString().contains("'plot.doc'. Choose a name that ends in .png, .svg or .pdf"))
      << failed[0][0].toString().toStdString();
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

TEST_F(ChartTest, WithoutValuesItSaysWhyAndCannotBeSaved) {
  Chart chart;
  ChartContents nothing;
  nothing.title = QStringLiteral("needle path");
  nothing.words = QStringLiteral("n/a: there are no attempts yet that count toward levels.");
  chart.show(nothing);
  ASSERT_EQ(chart.actions().size(), 1);
  EXPECT_FALSE(chart.actions().first()->isEnabled());
  EXPECT_EQ(chart.accessibleDescription(), nothing.words);
  chart.show(rising());
  EXPECT_TRUE(chart.actions().first()->isEnabled());
}

TEST_F(ChartTest, LinesAreWhereTheirNumbersAre) {
  // A line on its own from corner to corner, on paper of 400 x 300: it leaves the left below and ends at the right
  // above.
  ChartContents picture;
  picture.lines.push_back({{}, {{0, 0}, {10, 100}}, Tone::Danger, Qt::SolidLine});
  QImage image(400, 300, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintChart(painter, QRectF(0, 0, 400, 300), 1, picture);
  painter.end();
  const auto height = [&](int x) {
    for (int y = 0; y < image.height(); ++y)
      if (image.pixelColor(x, y).red() > 2 * image.pixelColor(x, y).green()) return y;
    return -1;
  };
  EXPECT_GT(height(120), height(250));
  EXPECT_GT(height(250), height(370));
  EXPECT_GE(height(370), 0);
}

TEST_F(ChartTest, BoxesStandOverTheirNames) {
  ChartContents picture;
  picture.categories = QStringList{QStringLiteral("2025"), QStringLiteral("2026")};
  picture.boxes.push_back({0, {1, 2, 3, 4, 5, {9}}, Tone::Accent});
  picture.boxes.push_back({1, {11, 12, 13, 14, 15, {}}, Tone::Danger});
  QImage image(400, 300, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  paintChart(painter, QRectF(0, 0, 400, 300), 1, picture);
  painter.end();
  EXPECT_GT(pixelsOf(image.copy(30, 0, 185, 300), QColor(0x1b, 0x6a, 0xa5)), 100);
  EXPECT_EQ(pixelsOf(image.copy(30, 0, 185, 300), QColor(0xb3, 0x26, 0x1e)), 0);
  EXPECT_GT(pixelsOf(image.copy(215, 0, 185, 150), QColor(0xb3, 0x26, 0x1e)), 100) << "higher values are above";
}

TEST_F(ChartTest, OfAnySizeBoxesStandOverTheirNames) {
  Chart chart;
  chart.resize(300, 200);
  ChartContents picture;
  picture.categories = QStringList{QStringLiteral("A class with quite a long name"), QStringLiteral("Another")};
  picture.boxes.push_back({0, {1, 2, 3, 4, 5, {}}, Tone::Caution});
  picture.boxes.push_back({1, {1, 2, 3, 4, 5, {}}, Tone::Accent});
  chart.show(picture);
  chart.QWidget::show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart));
  auto& plot = *chart.findChild<QwtPlot*>();
  const QWidget& axis = *plot.axisWidget(QwtPlot::xBottom);
  for (const int width : {300, 1400, 700}) {
    chart.resize(width, 500);
    ASSERT_TRUE(QTest::qWaitFor([&] { return plot.width() > width - 20 && plot.width() < width; }));
    for (const double x : {0.0, 1.0})
      EXPECT_NEAR(plot.transform(QwtPlot::xBottom, x) + plot.canvas()->x(),
                  plot.axisScaleDraw(QwtPlot::xBottom)->scaleMap().transform(x) + axis.x(), 1)
          << "of " << width << " px";
  }
}

}  // namespace
}  // namespace insonate::ui

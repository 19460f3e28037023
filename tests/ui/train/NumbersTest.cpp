#include "AttemptWindow.h"

#include <insonate/review/ReviewWorkspace.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/TaskBar.h>

#include <QRegularExpression>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <variant>

namespace insonate::train {
namespace {

/// The same number in the panel while the attempt is made, in its events, its metrics and in Review's result, each to
/// the digits that are shown; on a block whose skin is the plane y = 0, so that the answers are plain geometry.
class TrainNumbers : public AttemptWindow {
 protected:
  /// Text of the metric in the panel's table.
  QString panel(Metric metric) {
    const QRegularExpression row(
        QString("<td>%1</td><td[^>]*>(?:&nbsp;)*([^<]*)</td>").arg(QRegularExpression::escape(ui::titleOf(metric))));
    return row.match(text("attemptNumbers")).captured(1);
  }
  struct Reviewed {
    QString hands;                         ///< the read-out beside Play, at the end
    std::map<QString, QString> metrics{};  ///< the result's table
  };
  Reviewed reviewed() {
    ui::TaskBar tasks;
    review::ReviewWorkspace review(tasks);
    review.resize(1200, 760);
    review.show();
    review.setCase(model_->patientCase.patient());
    review.openAttempt(attempt_->file());
    auto* table = review.findChild<QTableWidget*>("metrics");
    auto* timeline = review.findChild<QWidget*>("timeline");
    // The attempt has no metrics of a line.
    const auto rows =
        std::ranges::count_if(metricTable(), [](const MetricDefinition& one) { return !isOfLine(one.metric); });
    EXPECT_TRUE(waitFor([&] { return table->rowCount() == rows && review.isReady(); }));
    QTest::keyClick(timeline, Qt::Key_End);
    auto* hands = review.findChild<QLabel*>("handsNow");
    EXPECT_TRUE(waitFor([&] { return hands->text().contains("inserted"); })) << hands->text().toStdString();
    Reviewed all{hands->text()};
    for (int row = 0; row < table->rowCount(); ++row)
      all.metrics[table->item(row, 0)->text()] = table->item(row, 1)->text();
    return all;
  }
  static std::vector<AttemptEvent> eventsOf(const AttemptRecording& recording, Label wall) {
    std::vector<AttemptEvent> all;
    EXPECT_TRUE(recording.play(std::numeric_limits<std::int64_t>::max(), [&](const RecordingSegment::Entry& entry) {
      const auto* event = std::get_if<AttemptEvent>(&entry);
      if (event && event->kind == AttemptEventKind::Entered && event->wall == wall) all.push_back(*event);
    }));
    return all;
  }
  static QString digits(double value) { return QString::number(value, 'f', 1); }
};

/// Time with the tip under the skin and the needle free, and of that the time with the tip within the linear probe's
/// rectangle and one slice thickness off its plane, as the glossary has it.
double sharePlainly(const AttemptRecording& recording) {
  const ImageField field = recording.header().picture;
  double all_us = 0, shown_us = 0;
  std::optional<std::int64_t> last_us;
  bool inSkin = false, frozen = false;
  EXPECT_TRUE(recording.play(std::numeric_limits<std::int64_t>::max(), [&](const RecordingSegment::Entry& entry) {
    if (const auto* event = std::get_if<AttemptEvent>(&entry)) {
      inSkin |= event->kind == AttemptEventKind::Entered && event->wall == kSkin;
      frozen |= event->kind == AttemptEventKind::Frozen;
      return;
    }
    const auto& sample = std::get<AttemptSample>(entry);
    if (!inSkin || frozen || !sample.needleDepth_mm) return last_us.reset();
    const Vec3 tip = inverted(*sample.patientFromProbe) * sample.patientFromNeedle->offset;
    const double off_mm = tip.z - field.elevationFocus_mm;
    const double thickness_mm = std::hypot(
        2 * field.sliceHalf_mm, off_mm * (off_mm < 0 ? field.elevationDivergence : field.elevationDivergenceBehind));
    const bool shown = std::abs(tip.x) <= field.width_mm / 2 && tip.z >= 0 && tip.z <= sample.imageDepth_mm &&
                       std::abs(tip.y) <= thickness_mm;
    if (last_us) all_us += double(sample.time_us - *last_us);
    if (last_us && shown) shown_us += double(sample.time_us - *last_us);
    last_us = sample.time_us;
  }));
  return 100 * shown_us / all_us;
}

/// An advance of 16 mm at 30 degrees ends 8 mm deep; the probe looks away from the tip for a while.
TEST_F(TrainNumbers, AreTheSameInPanelEventsMetricsAndReview) {
  openWide();
  model_->motion.typed(HandAxis::Press, 0);
  start();
  key(Qt::Key_I);
  type("needle_angle", "30");
  EXPECT_TRUE(child<QLineEdit>("needle_angle")->text().startsWith("30.0"));
  type("needle_depth", "16");
  // An oblique needle drags the skin along before it gives: the hole lies a little nearer to the tip than the entry.
  const auto inserted = [&] { return QString("in soft tissue, inserted %1\u00a0mm").arg(digits(lying().depth_mm)); };
  EXPECT_TRUE(waitFor([&] {
    return lying().depth_mm > 15 && text("needleWords").startsWith(inserted() + ", depth 8.0\u00a0mm");
  })) << text("needleWords").toStdString();
  EXPECT_NEAR(lying().depth_mm, 16, 0.6);
  EXPECT_TRUE(child<QLineEdit>("needle_depth")->text().startsWith("16.0"));
  QTest::qWait(600);
  model_->motion.moveTo({0, 0, 12});
  QTest::qWait(900);
  model_->motion.moveTo({0, 0, 0});
  QTest::qWait(300);
  key(Qt::Key_Space);
  ASSERT_TRUE(model_->live.isFrozen());
  EXPECT_TRUE(waitFor([&] { return panel(Metric::InsertionAngle) == "30.0°"; }))
      << panel(Metric::InsertionAngle).toStdString();
  QTest::qWait(500);  // the share stands still
  const QString length = digits(lying().depth_mm);
  EXPECT_TRUE(text("needleWords").startsWith(inserted() + ", depth 8.0\u00a0mm")) << text("needleWords").toStdString();
  const QString inImage = panel(Metric::TipInImage);
  finish();

  const auto recording = recorded();
  ASSERT_TRUE(recording) << recording.error().message;
  const auto skin = eventsOf(*recording, kSkin);
  ASSERT_EQ(skin.size(), 1U);
  EXPECT_NEAR(skin.front().axis.y, 0.5, 0.001) << "the sine of 30 degrees";
  ASSERT_TRUE(skin.front().outward);
  EXPECT_EQ(digits(std::asin(-dot(skin.front().axis, *skin.front().outward)) * 180 / std::numbers::pi), "30.0");
  const MetricValues metrics = *recording->metricsUntil();
  EXPECT_EQ(ui::valueOf(Metric::InsertionAngle, metrics[Metric::InsertionAngle]), "30.0°");
  const double share = sharePlainly(*recording);
  EXPECT_GT(share, 20);
  EXPECT_LT(share, 90);
  EXPECT_EQ(inImage, digits(share) + " %");
  EXPECT_EQ(ui::valueOf(Metric::TipInImage, metrics[Metric::TipInImage]), inImage);

  const Reviewed result = reviewed();
  EXPECT_TRUE(result.hands.startsWith(QString("inserted %1\u00a0mm   depth 8.0\u00a0mm").arg(length)))
      << result.hands.toStdString();
  for (int i = 0; i < int(Metric::Preparations); ++i)
    EXPECT_EQ(result.metrics.at(ui::titleOf(Metric(i))), ui::valueOf(Metric(i), attempt_->view().metrics[Metric(i)]))
        << definitionOf(Metric(i)).id;
  EXPECT_EQ(result.metrics.at(ui::titleOf(Metric::InsertionAngle)), "30.0°");
  EXPECT_EQ(result.metrics.at(ui::titleOf(Metric::TipInImage)), inImage);
}

/// Square over a vein 12 mm beside the image's plane: advance, insertion length and depth are the same 12 mm.
TEST_F(TrainNumbers, OfTheVeinAreTheSameWhereverTheyAreTold) {
  openWide();
  model_->motion.typed(HandAxis::Press, 0);
  start();
  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  ASSERT_TRUE(waitFor([&] { return heard("insertion length") == 1; }));
  const QString said = said_.filter("insertion length").front();
  EXPECT_TRUE(waitFor([&] { return text("needleWords").contains("inserted 12.0\u00a0mm, depth 12.0\u00a0mm"); }))
      << text("needleWords").toStdString();
  EXPECT_TRUE(waitFor([&] { return panel(Metric::InsertionAngle) == "90.0°"; }));
  EXPECT_TRUE(waitFor([&] { return panel(Metric::TipInImage) == "0.0 %"; })) << panel(Metric::TipInImage).toStdString();
  finish();
  const auto recording = recorded();
  ASSERT_TRUE(recording) << recording.error().message;
  const auto vein = eventsOf(*recording, kVein);
  ASSERT_EQ(vein.size(), 1U);
  EXPECT_NEAR(vein.front().depth_mm, 8, 2) << "the near wall, which bends before it gives";
  double inserted_mm = 0;
  EXPECT_TRUE(recording->play(std::numeric_limits<std::int64_t>::max(), [&](const RecordingSegment::Entry& entry) {
    const auto* sample = std::get_if<AttemptSample>(&entry);
    if (sample && sample->time_us <= vein.front().time_us) inserted_mm = sample->needleDepth_mm.value_or(0);
  }));
  EXPECT_GT(inserted_mm, vein.front().depth_mm + 0.5);
  const double told_mm = said.section("insertion length ", 1).section(QChar(0xa0), 0, 0).toDouble();
  EXPECT_NEAR(told_mm, inserted_mm, 0.3) << "as the panel says: that of the tip, not the place of the wall";
  const Reviewed result = reviewed();
  EXPECT_TRUE(result.hands.startsWith("inserted 12.0\u00a0mm   depth 12.0\u00a0mm")) << result.hands.toStdString();
  EXPECT_EQ(result.metrics.at(ui::titleOf(Metric::InsertionAngle)), "90.0°");
  EXPECT_EQ(result.metrics.at(ui::titleOf(Metric::TipInImage)), "0.0 %");
  EXPECT_EQ(result.metrics.at(ui::titleOf(Metric::VeinPunctures)), "1");
}

}  // namespace
}  // namespace insonate::train

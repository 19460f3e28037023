#include "ReviewWindow.h"
#include "attempt/AttemptDigest.h"
#include "list/AttemptList.h"
#include "replay/ReplayScene.h"
#include "result/PlanePlot.h"
#include "result/ResultPage.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <QFile>
#include <QImage>
#include <QPainter>
#include <algorithm>

namespace insonate::review {
namespace {

using testing::HasSubstr;

class Digest : public testing::Test {
 protected:
  QString file(const char* name) const { return home_.filePath(name); }
  static std::shared_ptr<const AttemptDigest> digest(const QString& name) {
    auto made = digestOf(name.toStdString());
    if (!made) throw std::runtime_error(made.error().message);
    return *made;
  }
  static void cut(const QString& name, double share) {
    QFile whole(name);
    ASSERT_TRUE(whole.resize(qint64(double(whole.size()) * share)));
  }
  static void damage(const QString& name, double at) {
    QFile whole(name);
    ASSERT_TRUE(whole.open(QIODevice::ReadWrite));
    whole.seek(qint64(double(whole.size()) * at));
    whole.write(QByteArray(40, '\x55'));
  }

  QTemporaryDir home_;
};

/// 5 mm to the skin at 10 mm/s, 22 mm on, and back; then 17 mm in again. A wall bends before it gives, so that the tip
/// is some millimeters deeper than the wall when it does.
TEST_F(Digest, TellsWhatTheHandsDidAndWhen) {
  const auto attempt = digest(recorded(file("two")));
  EXPECT_NEAR(double(attempt->end_us) * 1e-6, 2.7 + 2.7 + 1.7 + 1.5 + 0.5, 0.01);
  EXPECT_NEAR(double(attempt->track.size()), 9.1 * kTrack_Hz, 3);
  const auto at = [&](double s) -> const TrackPoint& {
    return *std::ranges::lower_bound(attempt->track, std::int64_t(s * 1e6), {}, &TrackPoint::time_us);
  };
  EXPECT_FALSE(at(0.3).needleDepth_mm);
  EXPECT_NEAR(at(2.0).needleDepth_mm.value(), 15, 0.5);
  EXPECT_NEAR(at(2.0).tip_probe->z, 15, 0.5) << "the probe looks along y from the skin at 0";
  EXPECT_NEAR(at(2.0).tip_probe->x, 0, 0.1);
  EXPECT_FALSE(at(1.0).aspirating);
  EXPECT_TRUE(at(7.5).aspirating);
  EXPECT_FALSE(at(8.9).tip_probe) << "the probe is lifted";
  EXPECT_EQ(attempt->placeAt(200'000).place, NeedlePlace::Clean);
  EXPECT_EQ(attempt->placeAt(1'300'000).place, NeedlePlace::UnderSkin);
  EXPECT_EQ(attempt->placeAt(1'900'000).place, NeedlePlace::Vein);
  EXPECT_EQ(attempt->placeAt(2'690'000).place, NeedlePlace::WrongPlace);
  EXPECT_EQ(attempt->placeAt(5'300'000).place, NeedlePlace::Used);
  ASSERT_TRUE(attempt->score);
  EXPECT_EQ(attempt->score->metrics[int(Metric::VeinPunctures)].value, 2);
  EXPECT_EQ(attempt->score->metrics[int(Metric::UsedNeedleInsertions)].value, 1);
  EXPECT_TRUE(std::ranges::is_sorted(attempt->moments, {}, &AttemptMoment::time_us));
  EXPECT_TRUE(std::ranges::any_of(attempt->moments, [](const auto& m) { return m.severity == Severity::Major; }));
  EXPECT_TRUE(attempt->errors.empty());
}

TEST_F(Digest, NamesTheVesselThatTheTipIsIn) {
  const auto attempt = digest(recorded(file("named"), kTwoPasses, namedBlock()));
  EXPECT_EQ(attempt->placeAt(1'300'000).vessel, "");
  EXPECT_EQ(attempt->placeAt(1'900'000).vessel, "right internal jugular vein");
  EXPECT_EQ(attempt->placeAt(2'690'000).vessel, "") << "behind it";
  EXPECT_EQ(attempt->placeAt(5'300'000).vessel, "");
  EXPECT_TRUE(std::ranges::any_of(attempt->moments, [](const AttemptMoment& m) {
    return m.description == "The right internal jugular vein is reached.";
  }));
}

TEST_F(Digest, ItsNumbersAreThoseOfTheRecording) {
  const auto attempt = digest(recorded(file("two")));
  const auto metrics = attempt->recording->metricsUntil();
  ASSERT_TRUE(metrics);
  for (const MetricScore& score : attempt->score->metrics) EXPECT_EQ(score.value, (*metrics)[score.metric]);
}

TEST_F(Digest, ThePathHasTheColorsOfWhereTheTipWas) {
  const auto paths = pathOf(*digest(recorded(file("two"))));
  const auto length_mm = [&](views::Color color) {
    double sum = 0;
    for (const views::ScenePath& path : paths)
      for (std::size_t i = 1; i < path.points_mm.size() && path.color == color; ++i)
        sum += norm(path.points_mm[i] - path.points_mm[i - 1]);
    return sum;
  };
  // Both ways through the vein's 9 mm and then 4 in, less what its walls bend; beyond the back wall 4 mm on and back.
  EXPECT_NEAR(length_mm(views::theme::kGood), 9 + 9 + 4 - 3, 3);
  EXPECT_NEAR(length_mm(views::theme::kDanger), 8, 2);
  EXPECT_GT(length_mm(views::theme::kText), 8 + 3) << "out by the whole way; in from where the skin gave";
}

TEST_F(Digest, SignsTellThePiecesOfThePathApartWithoutColors) {
  const auto signs = signsOf(*digest(recorded(file("two"))));
  const auto count = [&](views::Color color, std::size_t points) {
    return std::ranges::count_if(
        signs, [&](const auto& sign) { return sign.color == color && sign.points_mm.size() == points; });
  };
  EXPECT_GE(count(views::theme::kGood, 25), 2) << "circles where the vein is entered";
  EXPECT_GE(count(views::theme::kDanger, 4), 1) << "a triangle behind the vein";
}

TEST_F(Digest, ThePlaneShowsTheVeinUnderTheTip) {
  const auto attempt = digest(recorded(file("two")));
  const PlaneSection section = sectionOf(*attempt, block().get());
  EXPECT_NEAR(double(section.time_us) * 1e-6, 1.35, 0.3) << "as the vein is reached";
  const auto shade = [&](double lateral_mm, double deep_mm) {
    const QPointF at = QPointF(lateral_mm, deep_mm) - section.place_mm.topLeft();
    const QSizeF scale(section.structures.width() / section.place_mm.width(),
                       section.structures.height() / section.place_mm.height());
    return section.structures.pixelColor(int(at.x() * scale.width()), int(at.y() * scale.height()));
  };
  EXPECT_GT(shade(0, 12).blue(), shade(0, 12).red()) << "the vein is blue";
  EXPECT_EQ(shade(10, 12).alpha(), 0) << "muscle is left out";
  EXPECT_TRUE(sectionOf(*attempt, nullptr).structures.isNull());
}

TEST_F(Digest, ThePathInThePlaneTellsPlacesApartWithoutColors) {
  const auto attempt = digest(recorded(file("two")));
  const PlaneSection section = sectionOf(*attempt, nullptr);
  ui::Ink ink;
  ink.text = ink.quiet = ink.line = ink.good = ink.caution = ink.danger = Qt::black;
  const auto painted = [&](const AttemptDigest& shown) {
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintPlane(painter, image.rect(), shown, section, ink);
    return image;
  };
  AttemptDigest plain = *attempt;
  for (TrackPoint& point : plain.track) point.place = NeedlePlace::UnderSkin;
  EXPECT_NE(painted(*attempt), painted(plain));
}

TEST_F(Digest, CutShortItIsReadToItsLastSecondAndSaysSo) {
  const QString name = recorded(file("cut"));
  cut(name, 0.85);
  const auto attempt = digest(name);
  EXPECT_EQ(attempt->recording->status(), AttemptStatus::CutShort);
  EXPECT_GT(attempt->end_us, 4'000'000);
  EXPECT_LT(attempt->end_us, 9'000'000);
  ASSERT_FALSE(attempt->errors.empty());
  EXPECT_THAT(attempt->errors.front(), HasSubstr("stopped early, so the attempt counts as abandoned"));
  EXPECT_TRUE(attempt->score) << "what is there is whole";
  EXPECT_EQ(attemptsIn(home_.path()).size(), 1u);
}

TEST_F(Digest, DamagedItGivesTheRestAndNoNumbers) {
  const QString name = recorded(file("damaged"));
  damage(name, 0.75);
  const auto attempt = digest(name);
  ASSERT_FALSE(attempt->errors.empty());
  EXPECT_THAT(attempt->errors.front(), HasSubstr("damaged"));
  EXPECT_FALSE(attempt->score);
  EXPECT_FALSE(attempt->moments.empty());
  EXPECT_GT(attempt->end_us, 8'000'000);
}

TEST_F(Digest, GarbageAndNothingAreRefusedWithASentence) {
  QFile garbage(file("garbage.attempt"));
  ASSERT_TRUE(garbage.open(QIODevice::WriteOnly));
  garbage.write(QByteArray(5000, 'x'));
  garbage.close();
  const auto read = digestOf(garbage.fileName().toStdString());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("is not a recording of an attempt"));
  EXPECT_FALSE(digestOf(file("none").toStdString()));
  EXPECT_EQ(digestOf(recorded(file("two")).toStdString(), [](auto, double) { return false; }).error().message,
            kCancelled);
}

TEST_F(Digest, AnAttemptInWhichNothingHappenedIsEmpty) {
  auto recorder = AttemptRecorder::start(file("empty").toStdString(), {});
  ASSERT_TRUE(recorder && (*recorder)->finish(AttemptStatus::Abandoned));
  const auto attempt = digest(file("empty"));
  EXPECT_EQ(attempt->end_us, 0);
  EXPECT_TRUE(attempt->track.empty() && attempt->moments.empty() && pathOf(*attempt).empty());
  EXPECT_THAT(attempt->errors.front(), HasSubstr("Steps and rules are not shown"));
  EXPECT_TRUE(sectionOf(*attempt, block().get()).place_mm.isEmpty());
}

/// The tip rests in the vein and blood comes, which succeeds where the attempt is finished.
TEST_F(Digest, AnAbandonedAttemptIsCalledSoAndNoSuccess) {
  std::string script = R"({"acts": [{"tilt_deg": 15}, {"probe": "auto"},
    {"needle": {"from_mm": [0, -5, 0], "to": "vein"}}, {"aspirate": true}, {"advance_mm": 17}, {"wait_s": 1.5}]})";
  const auto finished = digest(recorded(file("finished"), script.c_str()));
  ASSERT_TRUE(finished->score && finished->score->succeeded);
  EXPECT_EQ(pointsNoteOf(*finished), "of 100 points. The attempt succeeded: the tip was placed in the vein.");
  script.insert(1, "\"abandoned\": true, ");
  const auto abandoned = digest(recorded(file("abandoned"), script.c_str()));
  ASSERT_TRUE(abandoned->score);
  EXPECT_FALSE(abandoned->score->succeeded);
  EXPECT_EQ(
      pointsNoteOf(*abandoned),
      "of 100 points for what was done. The attempt was abandoned: it did not succeed, and its points do not count.");
}

TEST_F(Digest, TheListHasTheLatestFirst) {
  for (const auto& [name, begun] : {std::pair{"a.attempt", "2026-11-01T10:00:00Z"},
                                    {"b.attempt", "2026-11-20T10:00:00Z"},
                                    {"c.attempt", "2026-11-05T10:00:00Z"}}) {
    AttemptHeader header;
    header.begun = begun;
    ASSERT_TRUE((*AttemptRecorder::start(file(name).toStdString(), header))->finish(AttemptStatus::Completed));
  }
  QFile other(file("notes.txt"));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  const auto all = attemptsIn(home_.path());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].file.endsWith("b.attempt"));
  EXPECT_TRUE(all[2].file.endsWith("a.attempt"));
  EXPECT_TRUE(attemptsIn(home_.filePath("none")).empty());
}

}  // namespace
}  // namespace insonate::review

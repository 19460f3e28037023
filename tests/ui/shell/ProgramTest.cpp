#include "Waiting.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <cmath>

namespace {

using namespace insonate;

struct Outcome {
  int status = -1;
  QString errors;
};

/// The program itself, on this process's screen and with its settings.
Outcome run(const QStringList& arguments, const QString& display = qEnvironmentVariable("DISPLAY")) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("DISPLAY", display);
  program.setProcessEnvironment(environment);
  program.start(INSONATE_PROGRAM, arguments);
  // The benchmark takes a minute and a half on a machine that is busy with other tests.
  if (!program.waitForFinished(4 * test::kPatience_ms)) program.kill();
  if (program.exitStatus() != QProcess::NormalExit) return {-1, "It did not end by itself."};
  return {program.exitCode(), QString::fromUtf8(program.readAllStandardError())};
}

class Program : public testing::Test {
 protected:
  QTemporaryDir home;
};

TEST_F(Program, TakesAScreenshotOfTheWindowWithACase) {
  const QString file = home.filePath("window.png");
  for (const char* workspace : {"prepare", "train", "review"}) {
    const Outcome outcome = run(
        {test::writtenSmallCase(home, "block"), "--workspace", workspace, "--screenshot", file, "--size", "1366x768"});
    ASSERT_EQ(outcome.status, 0) << workspace << ": " << outcome.errors.toStdString();
    const QImage picture(file);
    EXPECT_EQ(picture.size(), QSize(1366, 768));
    EXPECT_EQ(picture.pixelColor(2, 2), QColor(0x1b, 0x1f, 0x24)) << "the header";
    QFile::remove(file);
  }
}

TEST_F(Program, TheSizeOfAScreenshotIsInDevicePixels) {
  qputenv("QT_SCALE_FACTOR", "2");
  const QString file = home.filePath("window.png");
  const Outcome outcome = run(
      {test::writtenSmallCase(home, "block"), "--workspace", "review", "--screenshot", file, "--size", "2400x1400"});
  qunsetenv("QT_SCALE_FACTOR");
  ASSERT_EQ(outcome.status, 0) << outcome.errors.toStdString();
  EXPECT_EQ(QImage(file).size(), QSize(2400, 1400));
}

TEST_F(Program, MeasuresItsSpeed) {
  const QString folder = home.filePath("speed");
  const Outcome outcome = run({test::writtenSmallCase(home, "block"), "--benchmark", folder, "--quick"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors.toStdString();
  QFile file(folder + "/window.json");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QJsonObject table = QJsonDocument::fromJson(file.readAll()).object();
  EXPECT_FALSE(table["graphics"].toString().isEmpty());
  QStringList names;
  for (const QJsonValue& row : table["rows"].toArray()) {
    names << row["name"].toString();
    EXPECT_TRUE(std::isfinite(row["value"].toDouble(NAN))) << names.back().toStdString();
  }
  for (const char* name : {"logical_cores",
                           "load_average_at_start",
                           "start_to_first_image_cold",
                           "start_to_first_image_warm",
                           "start_to_first_image_case",
                           "open_case",
                           "live_3d_idle_images_per_second",
                           "live_3d_idle_latency_median",
                           "live_3d_idle_latency_p95",
                           "live_3d_follows_images_per_second",
                           "live_3d_follows_latency_median",
                           "live_3d_follows_latency_p95",
                           "hands_images_per_second",
                           "servo_ticks_late",
                           "servo_tick_p99.9",
                           "orbit_frames_per_second",
                           "orbit_median",
                           "orbit_p95",
                           "volume_orbit_frames_per_second",
                           "volume_zoom_frames_per_second",
                           "labelling_slice_change_median",
                           "labelling_brush_stroke_longest",
                           "labelling_threshold_slices_median",
                           "labelling_threshold_with_3d_median",
                           "labelling_growing_on_region_median",
                           "labelling_level_set_on_region_median",
                           "labelling_automatic_part_median",
                           "memory_labelling_times_volumes",
                           "volume_probe_frames_per_second",
                           "volume_exact_after",
                           "volume_hold_moving_median",
                           "volume_hold_moving_least",
                           "volume_hold_moving_longest",
                           "volume_hold_moving_processor_longest",
                           "volume_hold_at_rest_median",
                           "volume_hold_at_rest_least",
                           "volume_hold_at_rest_longest",
                           "volume_hold_at_rest_processor_longest",
                           "memory_train",
                           "memory_prepare",
                           "memory_peak"})
    EXPECT_EQ(names.count(name), 1) << name;
  QFile csv(folder + "/window.csv");
  ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
  EXPECT_EQ(csv.readAll().count('\n'), names.size() + 1);
}

TEST_F(Program, RefusesWrongUsageWithTwo) {
  EXPECT_EQ(run({"--workspace", "kitchen"}).status, 2);
  EXPECT_EQ(run({"--size", "800x600"}).status, 2);
  EXPECT_EQ(run({"--screenshot", "x.png", "--size", "800"}).status, 2);
  EXPECT_EQ(run({"--colour", "pink"}).status, 2);
  EXPECT_EQ(run({"--quick"}).status, 2);
  EXPECT_EQ(run({"--benchmark", home.path(), "--until-image"}).status, 2);
  EXPECT_EQ(run({"--help"}).status, 0);
}

TEST_F(Program, OpensNoDatabaseOfAServer) {
  Outcome outcome = run({"--database", "postgresql://me@nowhere/db", "--until-image"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(outcome.errors.contains("Ask the administrator of your site")) << outcome.errors.toStdString();
  qputenv("INSONATE_DATABASE", "postgres://me@nowhere/db");
  outcome = run({"--until-image"});
  qunsetenv("INSONATE_DATABASE");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(outcome.errors.contains("https://")) << outcome.errors.toStdString();
}

TEST_F(Program, SaysWhyACaseCannotBeReadAndLeavesWhereNobodyLooks) {
  const QString broken = test::writtenSmallCase(home, "broken"), picture = home.filePath("window.png");
  ASSERT_TRUE(QFile::resize(broken + "/ct.nrrd", 700));
  const QList<QStringList> ways{{"--screenshot", picture}, {"--until-image"}};
  for (const QStringList& way : ways) {
    Outcome outcome = run(QStringList{home.filePath("nothing")} + way);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.errors.contains("There is no file or folder")) << outcome.errors.toStdString();
    outcome = run(QStringList{broken} + way);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.errors.contains("ct.nrrd")) << outcome.errors.toStdString();
  }
  EXPECT_FALSE(QFile::exists(picture));
}

TEST_F(Program, SaysWhyAnAttemptCannotBeOpened) {
  QFile file(home.filePath("garbage.attempt"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("words");
  file.close();
  const Outcome outcome = run({file.fileName(), "--screenshot", home.filePath("window.png")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.errors.contains("garbage.attempt is not a recording of an attempt"))
      << outcome.errors.toStdString();
}

TEST_F(Program, OpensItsWindowForACaseThatIsNotThere) {
  QProcess program;
  program.start(INSONATE_PROGRAM, {home.filePath("nothing")});
  QByteArray errors;
  ASSERT_TRUE(test::waitUntil([&] { return (errors += program.readAllStandardError()).contains("There is no file"); }))
      << errors.toStdString();
  EXPECT_FALSE(program.waitForFinished(1000)) << "the window stays, with the reason in it";
  program.kill();
  program.waitForFinished();
}

TEST_F(Program, SaysThatThereIsNoDisplay) {
  for (const char* display : {"", ":9871"}) {
    const Outcome outcome = run({}, display);
    EXPECT_EQ(outcome.status, 1) << display;
    EXPECT_TRUE(outcome.errors.contains("There is no display")) << outcome.errors.toStdString();
  }
}

TEST_F(Program, SaysThatAScreenshotCannotBeWritten) {
  const Outcome outcome = run({test::writtenSmallCase(home, "block"), "--workspace", "review", "--screenshot",
                               home.filePath("no/such/folder/x.png")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.errors.contains("could not be written")) << outcome.errors.toStdString();
}

}  // namespace

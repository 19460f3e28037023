#include "TrainWindow.h"
#include "link/LinkFeature.h"
#include "link/TrackerDialog.h"
#include "unit/igtlink/PlainSocket.h"

#include <insonate/ui/Commands.h>

#include <gmock/gmock.h>

#include <QAction>
#include <QLabel>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <chrono>
#include <future>

namespace insonate::train {
namespace {

using insonate::test::PlainSocket;
using testing::HasSubstr;

class TrainLink : public TrainWindow {
 protected:
  LinkFeature& link() { return *workspace_->findChild<LinkFeature*>(); }
  QAction& action() { return *workspace_->commands().action("train.link.send"); }

  template <class Done>
  bool waitFor(const Done& done) {
    return QTest::qWaitFor(done, kPatience_ms);
  }

  /// Sends a command, and returns the text of the reply.
  std::string reply(const PlainSocket& client, const std::string& content) {
    const std::string text = "<Command Name=" + content + "</Command>";
    EXPECT_TRUE(client.write(
        insonate::test::message(2, "STRING", "CMD_7", insonate::test::extendedBody(insonate::test::stringBody(text)))));
    // Read on another thread, since the window's thread performs the command.
    auto reading = std::async(std::launch::async, [&client] { return client.readMessage("STRING"); });
    EXPECT_TRUE(waitFor([&] { return reading.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }));
    const auto message = reading.get();
    return message ? message->device + " " + message->text() : "";
  }
};

TEST_F(TrainLink, IsOffUntilItIsSwitchedOn) {
  openCase();
  EXPECT_FALSE(link().isOn());
  EXPECT_FALSE(action().isChecked());
  action().trigger();
  ASSERT_TRUE(link().isOn());
  EXPECT_TRUE(action().isChecked());
  const int port = link().port();
  EXPECT_THAT(action().text().toStdString(), HasSubstr("127.0.0.1:" + std::to_string(port) + ", 0 programs"));
  EXPECT_TRUE(PlainSocket::connectedTo(port).isOpen());
  action().trigger();
  EXPECT_FALSE(link().isOn());
  EXPECT_FALSE(PlainSocket::connectedTo(port).isOpen());
  EXPECT_EQ(action().text(), "Send Images by OpenIGTLink");
}

TEST_F(TrainLink, SendsTheImageOnDisplayAndPerformsCommands) {
  openCase();
  action().trigger();
  ASSERT_TRUE(link().isOn());
  const PlainSocket client = PlainSocket::connectedTo(link().port());
  const auto probe = client.readMessage("TRANSFORM"), image = client.readMessage("IMAGE");
  ASSERT_TRUE(probe && image);
  EXPECT_EQ(probe->device, "ProbeToReference");
  EXPECT_EQ(image->device, "Image_Reference");
  EXPECT_TRUE(image->crcFits);
  const BModeImage& shown = model_->live.shown()->image;
  EXPECT_EQ(image->body.size(), 72 + shown.gray.size());
  EXPECT_TRUE(waitFor([&] { return action().text().contains("1 program)"); }));

  const std::string set = reply(
      client, "\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"55\"/><Parameter Name=\"GainDb\" Value=\"6\"/>");
  EXPECT_THAT(set, HasSubstr("ACK_7 <CommandReply Status=\"SUCCESS\" Message=\"DepthMm is 55. GainDb is 6.\""));
  EXPECT_EQ(model_->imaging.settings().depth_mm, 55);
  EXPECT_EQ(model_->imaging.settings().gain_dB, 6);
  EXPECT_THAT(reply(client, "\"SetUsParameter\"><Parameter Name=\"Freeze\" Value=\"TRUE\"/>"), HasSubstr("SUCCESS"));
  EXPECT_TRUE(model_->live.isFrozen());
  EXPECT_THAT(reply(client, "\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"5000\"/>"), HasSubstr("FAIL"));
  EXPECT_EQ(model_->imaging.settings().depth_mm, 55);
}

TEST_F(TrainLink, SendsNothingAndObeysNothingDuringATest) {
  openCase();
  action().trigger();
  Disclosure none;
  none.anatomy = false;
  model_->disclosure.set(none);
  const PlainSocket client = PlainSocket::connectedTo(link().port());
  ASSERT_TRUE(client.readMessage("IMAGE"));  // the image before the test
  const double depth_mm = model_->imaging.settings().depth_mm;
  EXPECT_THAT(reply(client, "\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"55\"/>"),
              HasSubstr("FAIL\" Message=\"A test is in progress.\""));
  EXPECT_EQ(model_->imaging.settings().depth_mm, depth_mm);
}

/// A tracker that is added in the window is a device, which is there again after a restart.
TEST_F(TrainLink, ToolsOfTrackersAreDevices) {
  openCase();
  const PlainSocket listening = PlainSocket::listening();
  workspace_->commands().action("train.link.trackers")->trigger();
  auto* dialog = workspace_->findChild<TrackerDialog*>();
  ASSERT_TRUE(dialog);
  dialog->findChild<QSpinBox*>("trackerPort")->setValue(listening.port());
  dialog->findChild<QLineEdit*>("trackerTool")->setText("StylusToTracker");
  dialog->findChild<QPushButton*>("addTracker")->click();
  const PlainSocket tracker = listening.accepted();
  ASSERT_TRUE(tracker.isOpen());
  const auto* table = dialog->findChild<QTableWidget*>("trackerTable");
  ASSERT_EQ(table->rowCount(), 1);
  const QString id = QString("tracker:localhost:%1/StylusToTracker").arg(listening.port());
  const auto device = model_->hands.deviceOf(id);
  ASSERT_TRUE(device);
  ASSERT_TRUE(tracker.write(
      insonate::test::message(1, "TRANSFORM", "StylusToTracker", insonate::test::transformBody(10, 20, 30))));
  EXPECT_TRUE(waitFor([&] { return device->counters().reports == 1; }));
  dialog->findChild<QPushButton*>("addTracker")->click();
  EXPECT_EQ(table->rowCount(), 1) << "the same tool again";
  dialog->findChild<QPushButton*>("trackerTip")->click();
  EXPECT_FALSE(dialog->findChild<QLabel*>("trackerSaid")->text().isEmpty()) << "too few poses";

  const QTemporaryDir folder;
  QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
  link().save(settings);
  const TrainWorkspace later;
  later.findChild<LinkFeature*>()->restore(settings);
  EXPECT_TRUE(later.findChild<TrainModel*>()->hands.deviceOf(id));
  dialog->findChild<QPushButton*>("removeTracker")->click();
  EXPECT_EQ(table->rowCount(), 0);
  EXPECT_EQ(device->phase(), DevicePhase::kAbsent);
}

}  // namespace
}  // namespace insonate::train

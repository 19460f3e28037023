#include "LinkFeature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "TrackerDialog.h"

#include <insonate/igtlink/ImageLink.h>
#include <insonate/ui/Workspace.h>

#include <QAction>
#include <utility>

namespace insonate::train {
namespace {

constexpr const char* kSendImages = "train.link.send";
constexpr int kClients_ms = 500;

}  // namespace

LinkFeature::LinkFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout), trackers_(model.hands) {
  addCommand({.id = kSendImages,
              .text = tr("Send Images by OpenIGTLink"),
              .does = tr("sends the image and the poses of probe and needle to programs such as 3D Slicer on this "
                         "computer, and takes their commands"),
              .listed = {},
              .keys = {},
              .perform = once([this] { setOn(!isOn()); })});
  action_ = addSwitch(kSendImages, [this] { return isOn(); });
  addCommand({.id = "train.link.trackers",
              .text = tr("Trackers ..."),
              .does = tr("adds and calibrates the tools of tracking programs, which can then move probe and needle"),
              .listed = {},
              .keys = {},
              .perform = [this](ui::KeyPress) { showTrackers(); },
              .isAvailable = [] { return true; }});
  layout.addToViewMenu(*commands().action("train.link.trackers"));
  connect(&model_.live, &LiveModel::pictureShown, this, [this] { post(); });
  connect(&timer_, &QTimer::timeout, this, [this] { showClients(); });
}

LinkFeature::~LinkFeature() {
  delete dialog_;
}

void LinkFeature::save(QSettings& settings) const {
  trackers_.save(settings);
}

void LinkFeature::restore(QSettings& settings) {
  trackers_.restore(settings);
}

void LinkFeature::showTrackers() {
  if (!dialog_) dialog_ = new TrackerDialog(trackers_, &layout_.workspace());
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void LinkFeature::setOn(bool isOn) {
  server_ = nullptr;
  clients_ = 0;
  timer_.stop();
  if (isOn) {
    // The handler runs on the server's thread, which ends before this object.
    const auto handler = [this](const LinkCommand& command, const LinkServer::Answer& answer) {
      QMetaObject::invokeMethod(
          this, [this, command, answer] { obey(command, answer); }, Qt::QueuedConnection);
    };
    auto server = LinkServer::start({}, handler);
    if (!server) server = LinkServer::start({.port = 0}, handler);
    if (!server) return model_.status.showMessage(QString::fromStdString(server.error().message));
    server_ = std::move(*server);
    timer_.start(kClients_ms);
    post();
  }
  model_.status.showMessage(isOn ? tr("The image is sent at %1. In 3D Slicer, add a client with this address in the "
                                      "module OpenIGTLinkIF.")
                                       .arg(address())
                                 : tr("The image is no longer sent."));
  showClients();
}

void LinkFeature::post() {
  if (server_ && model_.live.shown() && model_.disclosure.current().anatomy)
    server_->post(linkFrameOf(model_.live.shown()));
}

void LinkFeature::obey(const LinkCommand& command, const LinkServer::Answer& answer) {
  if (!model_.disclosure.current().anatomy) return answer({false, "A test is in progress.", {}});
  if (!model_.live.shown()) return answer({false, "There is no image.", {}});
  const LinkedSettings present{model_.imaging.settings(), model_.live.isFrozen()};
  LinkedSettings changed = present;
  const LinkReply reply = performCommand(command, model_.imaging.probe(), changed);
  if (command.name == "SetUsParameter") model_.imaging.setSettings(changed.settings);
  model_.live.setFrozen(changed.frozen);
  answer(reply);
}

QString LinkFeature::address() const {
  return QString("127.0.0.1:%1").arg(port());
}

/// Shows address and number of clients in the menu, and says when a program has connected or disconnected.
void LinkFeature::showClients() {
  const int now = server_ ? server_->status().clients : 0;
  const int before = std::exchange(clients_, now);
  const QString programs = now == 1 ? tr("1 program") : tr("%1 programs").arg(now);
  action_->setText(tr("Send Images by OpenIGTLink") +
                   (server_ ? QString(" (%1, %2)").arg(address(), programs) : QString()));
  action_->setChecked(isOn());
  if (now > before) model_.status.showMessage(tr("A program has connected to %1.").arg(address()));
  if (server_ && now < before) model_.status.showMessage(tr("A program has disconnected from %1.").arg(address()));
}

}  // namespace insonate::train

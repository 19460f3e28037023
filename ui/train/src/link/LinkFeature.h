#pragma once

#include "../feature/Feature.h"
#include "TrackerList.h"

#include <insonate/igtlink/LinkServer.h>

#include <QPointer>
#include <QString>
#include <QTimer>
#include <memory>

class QAction;

namespace insonate::train {

class TrackerDialog;

/// The feature that sends the image on display, with the poses of probe and needle, to other programs on this computer
/// by OpenIGTLink, and performs their commands. Off at every start of the program. During a test in which anatomy is
/// not disclosed, nothing is sent, since another program could show the image in the CT. The feature also has the
/// window for the tools of trackers.
class LinkFeature final : public Feature {
  Q_OBJECT

 public:
  LinkFeature(TrainModel& model, TrainLayout& layout);
  ~LinkFeature() override;

  bool isOn() const { return server_ != nullptr; }
  /// Port of the server; 0 while the feature is off.
  int port() const { return server_ ? server_->port() : 0; }
  bool needsImages() const override { return isOn(); }
  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void setOn(bool isOn);
  void post();
  void obey(const LinkCommand& command, const LinkServer::Answer& answer);
  void showClients();
  void showTrackers();
  QString address() const;

  QAction* action_ = nullptr;
  int clients_ = 0;
  QTimer timer_;
  TrackerList trackers_;
  QPointer<TrackerDialog> dialog_;      ///< window for trackers; null until it is first shown
  std::unique_ptr<LinkServer> server_;  ///< null while the feature is off
};

}  // namespace insonate::train

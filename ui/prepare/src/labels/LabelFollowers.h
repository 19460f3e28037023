#pragma once

#include "../check/CaseMeasuring.h"
#include "../live/LivePatient.h"
#include "LabelSession.h"

#include <QObject>
#include <QTimer>
#include <functional>

namespace insonate::prepare {

/// Updates the results that depend on the labels after every edit, once the author pauses: the surfaces of changed
/// labels and the live image soon, volumes and the check later.
class LabelFollowers : public QObject {
  Q_OBJECT

 public:
  /// `wishes` says which of these labels have a surface to be made.
  using Wishes = std::function<std::vector<ui::SurfaceWish>(const LabelSet& labels)>;

  LabelFollowers(LabelSession& labels, LivePatient& live, CaseMeasuring& measuring, Wishes wishes, QObject* parent);

  /// Tells whether no update is due.
  bool isAtRest() const { return !soon_.isActive() && !later_.isActive(); }

 Q_SIGNALS:
  void restChanged();

 private:
  void followSoon();

  LabelSession& labels_;
  LivePatient& live_;
  CaseMeasuring& measuring_;
  Wishes wishes_;
  LabelSet changed_;
  QTimer soon_, later_;
};

}  // namespace insonate::prepare

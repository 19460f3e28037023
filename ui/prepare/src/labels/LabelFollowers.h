#pragma once

#include "../model/CaseMeasuring.h"
#include "../model/LivePatient.h"
#include "LabelSession.h"

#include <QObject>
#include <QTimer>
#include <functional>

namespace insonate::prepare {

/// Updates results that depend on the labels after edits, as soon as the author pauses: first the surfaces of changed
/// labels and the live image, later volumes and the check.
class LabelFollowers : public QObject {
  Q_OBJECT

 public:
  /// Function that returns the surfaces to compute for the labels that have changed.
  using Wishes = std::function<std::vector<ui::SurfaceRequest>(const LabelSet& labels)>;

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

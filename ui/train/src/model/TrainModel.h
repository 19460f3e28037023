#pragma once

#include "CaseModel.h"
#include "Disclosure.h"
#include "EngineText.h"
#include "HapticControl.h"
#include "History.h"
#include "ImagingModel.h"
#include "LiveModel.h"
#include "NeedleMotion.h"
#include "NeedleTray.h"
#include "ProbeMotion.h"
#include "StatusLine.h"

#include <QObject>

namespace insonate::train {

/// The state that the workspace's features share. This structure only contains the parts; a class uses the parts that
/// it needs. Uses no widgets. Each part receives the signals of earlier parts before any widget does.
struct TrainModel : public QObject {
  Q_OBJECT

 public:
  explicit TrainModel(QObject* parent) : QObject(parent) {}

  StatusLine status;
  History history;
  DisclosureModel disclosure{status};
  HapticControl hands;  ///< needle, devices and pedal
  NeedleTray tray;
  CaseModel patientCase{status};
  ImagingModel imaging{disclosure, history, status};
  LiveModel live{patientCase, imaging, hands, status};
  ProbeMotion motion{{patientCase, imaging, live, disclosure, hands, history, status}};
  NeedleMotion needle{hands, live};
  EngineText engine{patientCase, live, motion};
};

}  // namespace insonate::train

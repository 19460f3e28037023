#pragma once

#include <insonate/procedure/AttemptMetrics.h>

#include <QObject>

namespace insonate::train {

/// Manages the disclosed state of the needle during an attempt, and the tray with a new needle beside the patient.
class NeedleTray : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Tells whether the tray is beside the patient, as it is during an attempt.
  bool isOut() const { return isOut_; }
  /// The disclosed part of the needle's place; NeedlePlace::Clean outside attempts.
  NeedlePlace needle() const { return needle_; }
  void set(bool isOut, NeedlePlace needle);
  /// Reports that the pointer or the needle touches the tray.
  void touch() { Q_EMIT touched(); }

 Q_SIGNALS:
  void changed();
  void touched();

 private:
  bool isOut_ = false;
  NeedlePlace needle_ = NeedlePlace::Clean;
};

}  // namespace insonate::train

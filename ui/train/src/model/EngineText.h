#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace insonate::train {

class CaseModel;
class LiveModel;
class ProbeMotion;

/// Text about the engine and the frame rate of live images, updated a few times per second.
class EngineText : public QObject {
  Q_OBJECT

 public:
  EngineText(CaseModel& patientCase, LiveModel& live, ProbeMotion& motion, QObject* parent = nullptr);

  /// The text: "processor   62 fps   14.1 ms"; empty without a case.
  const QString& text() const { return text_; }

 Q_SIGNALS:
  void changed();

 private:
  void refresh();

  LiveModel& live_;
  ProbeMotion& motion_;
  QString text_;
  QTimer timer_;
};

}  // namespace insonate::train

#pragma once

#include <insonate/core/Vec3.h>

#include <QObject>
#include <QString>
#include <optional>

namespace insonate::prepare {

class Crosshair;
class LabelSession;
class LivePatient;
class Notice;
class OpenCase;
class TermsEditor;

/// Text of the status bar: the notice about the last event, else a description of the voxel under the tool or the
/// crosshair.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  /// Parts of the model that the sentence describes.
  struct Sources {
    OpenCase& openCase;
    Notice& notice;
    const Crosshair& crosshair;
    const TermsEditor& terms;
    const LabelSession& labeling;
    const LivePatient& live;
  };

  StatusLine(const Sources& sources, QObject* parent);

  QString text() const;
  /// Sets the point under a tool, which text() describes instead of the crosshair; empty: no point.
  void pointAt(std::optional<Vec3> patient_mm);

 Q_SIGNALS:
  void changed();

 private:
  QString placeText() const;

  Sources from_;
  std::optional<Vec3> pointer_mm_;
};

}  // namespace insonate::prepare

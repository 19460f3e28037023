#pragma once

#include <QObject>
#include <QTimer>

namespace insonate::prepare {

class CaseMeasuring;
class OpenCase;
class PlacesEditor;
class TermsEditor;

/// Passes the open case to CaseMeasuring, and has the case checked again after edits of places and tissues.
class MeasuringUpdates : public QObject {
 public:
  MeasuringUpdates(OpenCase& openCase, const PlacesEditor& places, const TermsEditor& terms, CaseMeasuring& measuring,
                   QObject* parent);

 private:
  QTimer recheck_;
};

}  // namespace insonate::prepare

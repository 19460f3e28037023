#pragma once

#include <insonate/cases/PlaceProposal.h>

#include <QObject>

namespace insonate::prepare {

class Crosshair;
class LabelSession;
class Notice;
class OpenCase;
class PlacesEditor;
class TermsEditor;

/// Proposes the targets, start poses and landmarks that the open case lacks, as one undoable step.
class PlaceProposing : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    OpenCase& openCase;
    LabelSession& labeling;
    const TermsEditor& terms;
    PlacesEditor& places;
    Crosshair& crosshair;
    Notice& notice;
  };

  PlaceProposing(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {}

  bool isRunning() const { return isRunning_; }
  /// Tells whether the case has a target and a start pose.
  bool isDone() const;
  /// Starts the search on another thread, since measuring along the vessels and trying poses of the probe take seconds.
  /// A notice states the result.
  void start();

 Q_SIGNALS:
  void runningChanged();

 private:
  void finished(const Result<PlaceProposal>& proposal);
  void add(const PlaceProposal& proposal);

  Parts parts_;
  bool isRunning_ = false;
};

}  // namespace insonate::prepare

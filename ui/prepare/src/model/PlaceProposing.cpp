#include "PlaceProposing.h"

#include "../labels/LabelSession.h"
#include "Crosshair.h"
#include "Notice.h"
#include "OpenCase.h"
#include "PlacesEditor.h"
#include "TermsEditor.h"

#include <insonate/simulator/TouchingPose.h>
#include <insonate/ui/Text.h>

#include <QCoreApplication>
#include <QPointer>
#include <QStringList>
#include <QtConcurrent/QtConcurrentRun>
#include <utility>

namespace insonate::prepare {

bool PlaceProposing::isDone() const {
  const CasePlaces& places = parts_.places.value();
  return !places.targets.empty() && !places.startPoses.empty();
}

void PlaceProposing::start() {
  const auto patient = parts_.openCase.patient();
  if (!patient || std::exchange(isRunning_, true)) return;
  CaseManifest manifest = patient->manifest;
  putPlaces(parts_.places.value(), manifest);
  manifest.ownLabels = parts_.terms.value().own;
  QtConcurrent::run(
      [self = QPointer(this), patient, labels = parts_.labeling.snapshot(), manifest = std::move(manifest)] {
        auto proposal = proposeTouchingPlaces(CaseView(manifest, patient->ct, *labels));
        QMetaObject::invokeMethod(qApp, [self, patient, proposal = std::move(proposal)] {
          if (!self) return;
          self->isRunning_ = false;
          if (self->parts_.openCase.patient() == patient) self->finished(proposal);
          Q_EMIT self->runningChanged();
        });
      });
  Q_EMIT runningChanged();
}

void PlaceProposing::finished(const Result<PlaceProposal>& proposal) {
  if (!proposal) return parts_.notice.showMessage(ui::qt(proposal.error().message));
  add(*proposal);
}

void PlaceProposing::add(const PlaceProposal& proposal) {
  const std::size_t count = proposal.targets.size() + proposal.startPoses.size() + proposal.landmarks.size();
  if (count == 0)
    return parts_.notice.showMessage(
        !proposal.notes.empty() ? ui::qt(proposal.notes.front())
        : parts_.places.value().targets.empty()
            ? tr("No vein has a name into which a procedure leads. Name the vein first: click into it, choose its "
                 "name, and click Mark.")
            : tr("Nothing is missing: there is a target, a start pose over each target, and the puncture site."));
  CaseManifest manifest;
  putPlaces(parts_.places.value(), manifest);
  addPlaces(proposal, manifest);
  parts_.places.set(placesOf(manifest), tr("propose places"));
  if (!proposal.targets.empty()) parts_.crosshair.moveTo(proposal.targets.front().position_mm);
  QStringList sentences{tr("%1 places were proposed. Check each place with Show; Ctrl+Z removes them.").arg(count)};
  for (const std::string& note : proposal.notes) sentences << ui::qt(note);
  parts_.notice.showMessage(sentences.join(QLatin1Char(' ')));
}

}  // namespace insonate::prepare

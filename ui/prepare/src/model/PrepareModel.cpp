#include "PrepareModel.h"

#include "../labels/LabelFollowers.h"
#include "../labels/LabelSession.h"
#include "CaseChanges.h"
#include "CaseMeasuring.h"
#include "Crosshair.h"
#include "LivePatient.h"
#include "LiveUpdates.h"
#include "Notice.h"
#include "OpenCase.h"
#include "PlaceProposing.h"
#include "PlacesEditor.h"
#include "SliceSettings.h"
#include "StatusLine.h"
#include "StructureAppearance.h"
#include "StructureList.h"
#include "TermsEditor.h"

#include <QTimer>

namespace insonate::prepare {
namespace {

/// Passes the open case to the check, and has it checked again after edits of places and tissues.
void keepChecked(CaseMeasuring& measuring, OpenCase& openCase, const PlacesEditor& places, const TermsEditor& terms) {
  constexpr int kRecheck_ms = 700;  // after the last of several edits
  auto* recheck = new QTimer(&measuring);
  recheck->setSingleShot(true);
  recheck->setInterval(kRecheck_ms);
  QObject::connect(&openCase, &OpenCase::opened, &measuring, [recheck, &openCase, &measuring] {
    recheck->stop();
    measuring.setCase(openCase.patient());
  });
  QObject::connect(&places, &PlacesEditor::edited, recheck, qOverload<>(&QTimer::start));
  QObject::connect(&terms, &TermsEditor::ownLabelsEdited, recheck, qOverload<>(&QTimer::start));
  QObject::connect(recheck, &QTimer::timeout, &measuring, [&openCase, &places, &terms, &measuring] {
    if (openCase.patient()) measuring.setWords(places.value(), terms.value());
  });
}

}  // namespace

/// Parts receive another case in the order of their construction, and all parts before the panels.
PrepareModel makePrepareModel(ui::TaskBar& tasks, QObject& parent) {
  auto& openCase = *new OpenCase(&parent);
  auto& notice = *new Notice(&parent);
  auto& measuring = *new CaseMeasuring(tasks, &parent);
  auto& live = *new LivePatient(&parent);
  auto& labeling = *new LabelSession(tasks, openCase.undoStack(), &parent);
  auto& terms = *new TermsEditor(openCase, measuring, notice, &parent);
  auto& structures = *new StructureList(openCase, measuring, labeling, terms, notice, &parent);
  auto& appearance = *new StructureAppearance(openCase, structures, terms, labeling, &parent);
  auto& places = *new PlacesEditor(openCase, live, notice, &parent);
  auto& crosshair = *new Crosshair(openCase, live, notice, &parent);
  auto& proposing = *new PlaceProposing({openCase, labeling, terms, places, crosshair, notice}, &parent);
  auto& slices = *new SliceSettings(&parent);
  auto& statusLine = *new StatusLine({openCase, notice, crosshair, terms, labeling, live}, &parent);
  auto& updates = *new LiveUpdates(openCase, appearance, terms, labeling, live, &parent);
  auto& followers = *new LabelFollowers(
      labeling, live, measuring, [&updates](const LabelSet& labels) { return updates.changedSurfaces(labels); },
      &parent);
  labeling.setNames([&terms](std::uint8_t label) { return terms.nameOf(label); });
  QObject::connect(&labeling, &LabelSession::failed, &notice, &Notice::showMessage);
  QObject::connect(&openCase, &OpenCase::opened, &labeling, [&openCase, &labeling, &appearance] {
    labeling.setCase(openCase.patient());
    appearance.protectHidden();
  });
  QObject::connect(&openCase, &OpenCase::saved, &labeling,
                   [&openCase, &labeling] { labeling.replaceCase(openCase.patient()); });
  keepChecked(measuring, openCase, places, terms);
  auto& changes = *new CaseChanges({openCase, structures, appearance, terms, places, labeling}, &parent);
  return {openCase,   notice, measuring, live,      labeling, followers,  terms,  structures,
          appearance, places, proposing, crosshair, slices,   statusLine, changes};
}

}  // namespace insonate::prepare

#include "StatusLine.h"

#include "../labels/LabelSession.h"
#include "Crosshair.h"
#include "LivePatient.h"
#include "Notice.h"
#include "OpenCase.h"
#include "TermsEditor.h"

#include <insonate/tissue/Labels.h>

#include <cmath>
#include <utility>

namespace insonate::prepare {

StatusLine::StatusLine(const Sources& sources, QObject* parent) : QObject(parent), from_(sources) {
  connect(&from_.openCase, &OpenCase::opened, this, [this] {
    from_.notice.clear();
    pointer_mm_.reset();
  });
  connect(&from_.openCase, &OpenCase::shown, this, &StatusLine::changed);
  connect(&from_.notice, &Notice::changed, this, &StatusLine::changed);
  connect(&from_.crosshair, &Crosshair::moved, this, &StatusLine::changed);
  connect(&from_.terms, &TermsEditor::changed, this, &StatusLine::changed);
  connect(&from_.labeling, &LabelSession::changed, this, &StatusLine::changed);
  connect(&from_.live, &LivePatient::started, this, &StatusLine::changed);
}

void StatusLine::pointAt(std::optional<Vec3> patient_mm) {
  if (patient_mm == std::exchange(pointer_mm_, patient_mm) || !from_.notice.text().isEmpty()) return;
  Q_EMIT changed();
}

QString StatusLine::placeText() const {
  const PatientCase& patient = *from_.openCase.patient();
  const Vec3 at_mm = pointer_mm_.value_or(from_.crosshair.position_mm());
  const Vec3 index = patient.ct.geometry.indexFromPatient() * at_mm;
  const std::uint8_t label = sampleNearest(from_.labeling.labels(), index);
  return tr("(%1, %2, %3) mm   %4 HU   %5")
      .arg(at_mm.x, 0, 'f', 1)
      .arg(at_mm.y, 0, 'f', 1)
      .arg(at_mm.z, 0, 'f', 1)
      .arg(std::lround(sampleLinear(patient.ct, index)))
      .arg(label == kBackground ? tr("not labeled") : from_.terms.nameOf(label));
}

QString StatusLine::text() const {
  if (!from_.notice.text().isEmpty()) return from_.notice.text();
  return from_.openCase.patient() ? placeText() : tr("Drop a case or a CT on the window.");
}

}  // namespace insonate::prepare

#include "VesselNaming.h"

#include "../labels/LabelSession.h"
#include "Notice.h"
#include "OpenCase.h"
#include "PlacesEditor.h"
#include "PrepareModel.h"
#include "TermsEditor.h"

#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/Text.h>

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>

namespace insonate::prepare {

Result<NamedVessel> vesselAt(const LabelMap& labels, const OwnLabels& own, const std::vector<Vec3>& places_mm,
                             const std::string& name) {
  const auto isVessel = [&](Vec3 place_mm) {
    const auto tissue = tissueOf(own, sampleNearest(labels, labels.geometry.indexFromPatient() * place_mm));
    return tissue == kVein || tissue == kArtery;
  };
  const auto inside = std::ranges::find_if(places_mm, isVessel);
  auto vessel = nameVessel(labels, own, inside == places_mm.end() ? places_mm.front() : *inside, name);
  if (vessel) vessel->clicks_mm = places_mm;
  return vessel;
}

void nameVesselAt(PrepareModel& shared, std::vector<Vec3> places_mm, const QString& name) {
  if (places_mm.empty() || !shared.openCase.patient()) return;
  QtConcurrent::run([self = QPointer(&shared.openCase), shared, patient = shared.openCase.patient(),
                     labels = shared.labeling.snapshot(), own = shared.terms.value().own,
                     places_mm = std::move(places_mm), name] {
    auto vessel = vesselAt(*labels, own, places_mm, name.toStdString());
    QMetaObject::invokeMethod(qApp, [self, shared, patient, name, vessel = std::move(vessel)] {
      if (!self || self->patient() != patient) return;
      if (!vessel) return shared.notice.showMessage(ui::qt(vessel.error().message));
      CasePlaces places = shared.places.value();
      addOrReplaceVessel(*vessel, places.vessels);
      shared.places.set(std::move(places), PlacesEditor::tr("name a vessel"));
      shared.notice.showMessage(PlacesEditor::tr("The vessel is now named %1; Ctrl+Z removes the name.").arg(name));
    });
  });
}

}  // namespace insonate::prepare

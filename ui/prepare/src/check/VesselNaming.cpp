#include "VesselNaming.h"

#include "../PrepareSession.h"

#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/Text.h>

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>

namespace insonate::prepare {
namespace {

Result<NamedVessel> namedAt(const LabelMap& labels, const OwnLabels& own, const std::vector<Vec3>& places_mm,
                            const std::string& name) {
  const auto isVessel = [&](Vec3 place_mm) {
    const auto tissue = tissueOf(own, sampleNearest(labels, labels.geometry.indexFromPatient() * place_mm));
    return tissue == kVein || tissue == kArtery;
  };
  const auto inside = std::ranges::find_if(places_mm, isVessel);
  return nameVessel(labels, own, inside == places_mm.end() ? places_mm.front() : *inside, name);
}

}  // namespace

void nameVesselAt(PrepareSession& session, std::vector<Vec3> places_mm, const QString& name) {
  if (places_mm.empty() || !session.patient()) return;
  QtConcurrent::run([self = QPointer(&session), patient = session.patient(), labels = session.labelling().snapshot(),
                     own = session.terms().own, places_mm = std::move(places_mm), name] {
    auto vessel = namedAt(*labels, own, places_mm, name.toStdString());
    QMetaObject::invokeMethod(qApp, [self, patient, name, vessel = std::move(vessel)] {
      if (!self || self->patient() != patient) return;
      if (!vessel) return self->say(ui::qt(vessel.error().message));
      CasePlaces places = self->places();
      putVessel(*vessel, places.vessels);
      self->setPlaces(std::move(places), PrepareSession::tr("name of a vessel"));
      self->say(PrepareSession::tr("The %1 has its name; Ctrl+Z removes it.").arg(name));
    });
  });
}

}  // namespace insonate::prepare

#include "TissueChoice.h"

#include <insonate/simulator/TissueMechanics.h>

#include <QSettings>
#include <QString>
#include <cmath>

namespace insonate::train {
namespace {

struct StoredValue {
  double Physiology::*field;
  const char* key;
};
constexpr StoredValue kStoredValues[] = {{&Physiology::centralVenous_mmHg, "centralVenous_mmHg"},
                                         {&Physiology::systolic_mmHg, "systolic_mmHg"},
                                         {&Physiology::diastolic_mmHg, "diastolic_mmHg"},
                                         {&Physiology::tilt_deg, "tilt_deg"}};

}  // namespace

Physiology physiologyOf(const TissueChoice& choice) {
  Physiology all = choice.body;
  if (!choice.pulse) all.heartRate_perMin = 0;
  if (!choice.breathing) all.breathing_perMin = 0;
  return all;
}

void saveTissue(const TissueChoice& choice, QSettings& settings) {
  settings.setValue("model", QString::fromStdString(choice.model));
  settings.setValue("pulse", choice.pulse);
  settings.setValue("breathing", choice.breathing);
  for (const StoredValue& row : kStoredValues) settings.setValue(row.key, choice.body.*row.field);
}

TissueChoice restoredTissue(QSettings& settings) {
  const TissueChoice usual;
  TissueChoice choice;
  choice.model = settings.value("model", QString::fromStdString(usual.model)).toString().toStdString();
  TissueMechanics mechanics;
  mechanics.model = choice.model;
  if (!validate(mechanics)) choice.model = usual.model;
  choice.pulse = settings.value("pulse", usual.pulse).toBool();
  choice.breathing = settings.value("breathing", usual.breathing).toBool();
  for (const StoredValue& row : kStoredValues) {
    bool ok = false;
    const double value = settings.value(row.key).toDouble(&ok);
    if (ok && std::isfinite(value)) choice.body.*row.field = value;
  }
  if (!checkPhysiology(choice.body)) choice.body = usual.body;
  return choice;
}

}  // namespace insonate::train

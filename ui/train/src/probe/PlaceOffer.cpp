#include "PlaceOffer.h"

#include "../model/CaseModel.h"
#include "../model/ProbeMotion.h"

#include <insonate/ui/Theme.h>

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::train {

PlaceOffer::PlaceOffer(CaseModel& patientCase, ProbeMotion& motion, QWidget* parent)
    : QWidget(parent), patientCase_(patientCase), motion_(motion) {
  setObjectName("placeOffer");
  auto* words =
      new QLabel(tr("This case has no start pose, and none was found automatically.\n\nClick \"Place probe on skin\", "
                    "or click on the skin in the 3D view. Prepare can save a start pose with the case."));
  words->setWordWrap(true);
  words->setAlignment(Qt::AlignCenter);
  auto* place = new QPushButton(tr("Place probe on skin"));
  place->setObjectName("placeOnSkin");
  place->setToolTip(
      tr("Moves the probe to the skin on the front of the patient, as near to the middle of the CT as possible"));
  ui::setRole(place, "primary");
  connect(place, &QPushButton::clicked, this, [this] { motion_.placeOnSkin(); });
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  box->setSpacing(ui::kLargeGap);
  box->addStretch();
  box->addWidget(words);
  box->addWidget(place, 0, Qt::AlignHCenter);
  box->addStretch();
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { refresh(); });
  connect(&motion_, &ProbeMotion::placingChanged, this, [this] { refresh(); });
  refresh();
}

void PlaceOffer::refresh() {
  setVisible(patientCase_.patient() && motion_.isUnplaced());
}

}  // namespace insonate::train

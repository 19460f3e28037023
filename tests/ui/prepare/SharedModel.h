#pragma once

#include "labels/LabelFollowers.h"
#include "labels/LabelSession.h"
#include "model/CaseChanges.h"
#include "model/CaseMeasuring.h"
#include "model/Crosshair.h"
#include "model/LivePatient.h"
#include "model/Notice.h"
#include "model/OpenCase.h"
#include "model/PlaceProposing.h"
#include "model/PlacesEditor.h"
#include "model/PrepareModel.h"
#include "model/SliceSettings.h"
#include "model/StatusLine.h"
#include "model/StructureAppearance.h"
#include "model/StructureList.h"
#include "model/TermsEditor.h"

namespace insonate::prepare {

/// The model of a workspace.
inline PrepareModel modelOf(const QObject& workspace) {
  return {*workspace.findChild<OpenCase*>(),
          *workspace.findChild<Notice*>(),
          *workspace.findChild<CaseMeasuring*>(),
          *workspace.findChild<LivePatient*>(),
          *workspace.findChild<LabelSession*>(),
          *workspace.findChild<LabelFollowers*>(),
          *workspace.findChild<TermsEditor*>(),
          *workspace.findChild<StructureList*>(),
          *workspace.findChild<StructureAppearance*>(),
          *workspace.findChild<PlacesEditor*>(),
          *workspace.findChild<PlaceProposing*>(),
          *workspace.findChild<Crosshair*>(),
          *workspace.findChild<SliceSettings*>(),
          *workspace.findChild<StatusLine*>(),
          *workspace.findChild<CaseChanges*>()};
}

}  // namespace insonate::prepare

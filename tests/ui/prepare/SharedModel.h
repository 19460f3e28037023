#pragma once

#include "check/CaseMeasuring.h"
#include "labels/LabelFollowers.h"
#include "labels/LabelSession.h"
#include "live/LivePatient.h"
#include "model/Notice.h"
#include "model/OpenCase.h"
#include "model/PrepareModel.h"
#include "places/PlacesEditor.h"
#include "publish/CaseChanges.h"
#include "structures/StructureAppearance.h"
#include "structures/StructureList.h"
#include "structures/TermsEditor.h"
#include "viewing/Crosshair.h"
#include "viewing/SliceSettings.h"
#include "viewing/StatusLine.h"

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
          *workspace.findChild<Crosshair*>(),
          *workspace.findChild<SliceSettings*>(),
          *workspace.findChild<StatusLine*>(),
          *workspace.findChild<CaseChanges*>()};
}

}  // namespace insonate::prepare

#include "PlacesFeature.h"

#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../layout/Section.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "PlacesBox.h"

namespace insonate::prepare {

PlacesFeature::PlacesFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  auto* places = new PlacesBox(model_);
  Section& section = layout_.right().addSection(RightColumn::Place::Check, QStringLiteral("places"),
                                                tr("Targets and landmarks"), places);
  connect(&model_.places, &PlacesEditor::markRequested, places, [this, places, &section](const QString& kind) {
    section.setOpen(true);
    places->offer(kind);
    layout_.right().scrollTo(*places);
  });
}

}  // namespace insonate::prepare

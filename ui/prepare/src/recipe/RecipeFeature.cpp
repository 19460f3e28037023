#include "RecipeFeature.h"

#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "RecipeBox.h"

namespace insonate::prepare {

RecipeFeature::RecipeFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  layout_.right().addSection(RightColumn::Place::Case, QStringLiteral("recipe"), tr("Steps"), new RecipeBox(model_));
}

}  // namespace insonate::prepare

#include "PublishFeature.h"

#include "../layout/PathColumn.h"
#include "../layout/PrepareLayout.h"
#include "PublishStep.h"

#include <insonate/ui/Workspace.h>

namespace insonate::prepare {

PublishFeature::PublishFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  PathStep& step = layout_.path().publish();
  step.add(new PublishStep(model_, layout_.workspace().tasks(), step));
}

}  // namespace insonate::prepare

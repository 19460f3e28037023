#include "GuideFeature.h"

#include "../layout/CaseViews.h"
#include "../layout/LabelPages.h"
#include "../layout/PathColumn.h"
#include "../layout/PrepareLayout.h"
#include "../layout/Section.h"
#include "../model/CaseMeasuring.h"
#include "../model/OpenCase.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "GuidePage.h"
#include "GuidePointer.h"
#include "GuideSession.h"

#include <insonate/tissue/Labels.h>

#include <utility>

namespace insonate::prepare {

GuideFeature::GuideFeature(PrepareModel& model, PrepareLayout& layout, Section& tool)
    : Feature(model, layout), guide_(new GuideSession(model, this)), page_(new GuidePage(*guide_)) {
  commands().beginSection(tr("Guide"));
  commands().addListed(tr("Click, drag on a slice"),
                       tr("adds a point for the current step, or moves an existing point"));
  commands().addListed(tr("Right click, Delete, Backspace"),
                       tr("removes the point under the pointer; if there is none, removes the last point"));
  commands().addListed(tr("Enter"), tr("runs the current step of the guide, or accepts its result"));
  LabelPages& pages = layout_.path().labelPages();
  pages.add(page_, tr("Guide"), tr("Guides you step by step through labeling a neck"),
            [this](std::uint8_t label) { return guide_->goToStepFor(label); });
  CaseViews& views = layout_.views();
  auto* pointer = new GuidePointer(*guide_, model_, &views);
  for (int n = 0; n < CaseViews::kSlices; ++n) pointer->watch(*views.widgets()[std::size_t(n)], views.slice(n));
  connect(guide_, &GuideSession::clicksChanged, &views,
          [this] { layout_.views().setClicks(guide_->shownClicks_mm()); });
  connect(guide_, &GuideSession::clicksChanged, &tool,
          [this, &tool] { tool.setRemark(guide_->isShown() ? tr("this tool pauses the labeling guide") : QString()); });
  // The guide would otherwise receive the clicks that set a place.
  connect(&model_.places, &PlacesEditor::markingBegun, page_, [this, &pages] { pages.leavePage(page_); });
  connect(&pages, &LabelPages::chosen, this, [this] { isChosen_ = true; });
  connect(&model_.openCase, &OpenCase::caseChanged, this, [this] { isChosen_ = false; });
  connect(&model_.measuring, &CaseMeasuring::changed, page_, [this] { choosePage(); });
}

/// A neck without a vein must be labeled first; an author who has started with the guide continues with it.
void GuideFeature::choosePage() {
  if (!model_.measuring.measures() || std::exchange(isChosen_, true)) return;
  LabelPages& pages = layout_.path().labelPages();
  const bool isNeeded = !model_.measuring.hasVoxels(kVein) || guide_->continues();
  isNeeded ? pages.showPage(page_) : pages.leavePage(page_);
}

}  // namespace insonate::prepare

#include "StructuresFeature.h"

#include "../labels/LabelSession.h"
#include "../layout/LabelPages.h"
#include "../layout/PathColumn.h"
#include "../layout/PrepareLayout.h"
#include "../model/CaseMeasuring.h"
#include "../model/PrepareModel.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "StructureTable.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace insonate::prepare {
namespace {

/// Tells whether the case has the structures and places that training needs; the guide has a step for each.
bool isLabeled(const std::vector<Finding>& findings) {
  static const std::set<std::string> kMissing{"no_skin", "no_vein", "no_artery", "no_target", "no_start_pose"};
  return std::ranges::none_of(findings, [](const Finding& finding) { return kMissing.contains(finding.code); });
}

}  // namespace

StructuresFeature::StructuresFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  addCommands();
  auto* table = new StructureTable(model_, commands());
  LabelPages& pages = layout_.path().labelPages();
  pages.add(table, tr("Structures"), tr("All structures of the case, with color and visibility"),
            [this](std::uint8_t label) {
              model_.structures.add(label);
              return true;
            });
  pages.showPage(table);
  connect(&model_.measuring, &CaseMeasuring::changed, this, [this] { refreshMark(); });
  refreshMark();
}

void StructuresFeature::addCommands() {
  StructureList& structures = model_.structures;
  commands().beginSection(tr("Structures"));
  add("prepare.structures.select", QStringLiteral("Q, W"), tr("selects the previous or next structure in the table"),
      {{Qt::Key_Q, [&structures] { structures.selectNext(-1); }},
       {Qt::Key_W, [&structures] { structures.selectNext(1); }}});
  add("prepare.structures.visibility", tr("H; Space in the structure table"),
      tr("hides or shows the selected structure"), {{Qt::Key_H, [this] { toggleVisible(); }}});
  commands().addListed(tr("Enter in the structure table"),
                       tr("chooses the color of the selected structure, while no tool is selected"));
  add("prepare.structures.lock", QStringLiteral("L"),
      tr("locks the selected structure, so that tools cannot change it, or unlocks it"),
      {{Qt::Key_L, [this] { toggleLocked(); }}});
  add("prepare.structures.state", QStringLiteral("S"),
      tr("sets the next labeling state of the selected structure, e.g. completed"),
      {{Qt::Key_S, [&structures] { structures.toNextState(structures.selected()); }}});
  commands().addListed(tr("F2 in the structure table"), tr("renames a structure that you added"));
}

void StructuresFeature::toggleVisible() {
  const std::uint8_t label = model_.structures.selected();
  model_.appearance.setVisible(label, !model_.appearance.look(label).visible);
}

void StructuresFeature::toggleLocked() {
  const std::uint8_t label = model_.structures.selected();
  model_.labeling.setLocked(label, !model_.labeling.rules().locked.test(label));
}

void StructuresFeature::refreshMark() {
  PathStep& step = layout_.path().label();
  if (!model_.measuring.measures()) {
    const bool isStopped = model_.measuring.state() == CaseMeasuring::State::Stopped;
    return step.setMark(isStopped ? tr("not measured") : tr("measuring ..."), PathStep::State::Unknown);
  }
  const int count = int(model_.structures.labels().size());
  step.setMark(count == 0   ? tr("no structures")
               : count == 1 ? tr("1 structure")
                            : tr("%1 structures").arg(count),
               isLabeled(model_.measuring.measures()->findings) ? PathStep::State::Done : PathStep::State::Open);
}

void StructuresFeature::save(QSettings& settings) const {
  model_.appearance.saveHabits(settings);
}

void StructuresFeature::restore(QSettings& settings) {
  model_.appearance.restoreHabits(settings);
}

}  // namespace insonate::prepare

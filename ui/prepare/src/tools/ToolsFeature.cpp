#include "ToolsFeature.h"

#include "../layout/CaseViews.h"
#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../layout/Section.h"
#include "SceneTools.h"
#include "SliceTools.h"
#include "ToolBar.h"
#include "ToolPanel.h"
#include "ToolSession.h"

#include <insonate/ui/HistogramEditor.h>

#include <set>

namespace insonate::prepare {

ToolsFeature::ToolsFeature(PrepareModel& model, PrepareLayout& layout, ui::HistogramEditor& histogram)
    : Feature(model, layout), tools_(new ToolSession(model, this)) {
  commands().beginSection(tr("Tools"));
  addChoosing();
  addActing();
  addBrush();
  commands().addListed(tr("Left drag in 3D with scissors"),
                       tr("draws the outline to cut along the view direction; with Ctrl, rotates the view"));
  layout_.addBar(new ToolBar(*tools_, commands()));
  auto* panel = new ToolPanel(model_, *tools_, commands());
  section_ = &layout_.right().addSection(RightColumn::Place::Top, QStringLiteral("tool"), tr("Tool"), panel);
  connect(&histogram, &ui::HistogramEditor::counted, panel,
          [panel, &histogram] { panel->setHistogram(histogram.histogram()); });
  new SliceTools(layout_.views(), *tools_, model_, commands());
  new SceneTools(layout_.views(), *tools_);
  connect(tools_, &ToolSession::toolChanged, section_,
          [this] { layout_.right().setShown(*section_, tools_->tool() != nullptr); });
}

void ToolsFeature::addChoosing() {
  std::set<int> used;
  for (const Tool& tool : toolTable())
    if (tool.key != 0) used.insert(tool.key);
  Keys keys;
  for (const int key : used)
    keys.emplace_back(key,
                      [this, key] { tools_->choose(toolOfKey(key, tools_->tool() ? tools_->tool()->id : QString())); });
  add("prepare.tools.choose", tr("1 to 9, 0"),
      tr("selects a tool of the palette; another press selects the next tool of its group"), keys);
  add("prepare.tools.last", tr("Space"), tr("selects the tool that was selected before"),
      {{Qt::Key_Space, [this] { tools_->chooseLast(); }}});
}

/// Without a tool, these keys are the window's.
void ToolsFeature::addActing() {
  const auto isInHand = [this] { return tools_->tool() != nullptr; };
  const auto apply = [this] { tools_->apply(); };
  add("prepare.tools.apply", tr("Enter"), tr("writes the tool's result to the labels"),
      {{Qt::Key_Return, apply}, {Qt::Key_Enter, apply}}, isInHand);
  add("prepare.tools.leave", tr("Esc"), tr("stops the tool, clears its clicks, or deselects the tool"),
      {{Qt::Key_Escape, [this] { tools_->leave(); }}}, isInHand);
  const auto removeLast = [this] { tools_->removeNearest(tools_->points().back()); };
  add("prepare.tools.removeLast", tr("Delete, Backspace"), tr("removes the tool's last click"),
      {{Qt::Key_Delete, removeLast}, {Qt::Key_Backspace, removeLast}}, [this] { return !tools_->points().empty(); });
}

void ToolsFeature::addBrush() {
  const auto larger = [this] { tools_->scaleBrush(ToolSession::kBrushStep); };
  const auto smaller = [this] { tools_->scaleBrush(1 / ToolSession::kBrushStep); };
  add("prepare.tools.brush", tr("+, -, [, ], Shift + wheel"), tr("makes the brush larger or smaller"),
      {{Qt::Key_Plus, larger},
       {Qt::Key_Minus, smaller},
       {Qt::Key_BracketRight, larger},
       {Qt::Key_BracketLeft, smaller}});
}

}  // namespace insonate::prepare

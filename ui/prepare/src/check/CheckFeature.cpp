#include "CheckFeature.h"

#include "../layout/LabelPages.h"
#include "../layout/PathColumn.h"
#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../layout/Section.h"
#include "../model/CaseMeasuring.h"
#include "../model/PrepareModel.h"
#include "DifficultyBox.h"
#include "FindingsList.h"

#include <QPushButton>

namespace insonate::prepare {

CheckFeature::CheckFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  constexpr const char* kPage = "prepare.check.page";
  commands().beginSection(tr("Case"));
  add(kPage, QStringLiteral("C"), tr("switches the panel beside the slices between the tabs Check and Case"),
      {{Qt::Key_C, [this] { showCheck(!layout_.right().showsCheck()); }}});
  const QString tip = commands().toolTip(tr("Errors, warnings, notes and difficulty of the case"), kPage);
  layout_.right().setTips(commands().toolTip(tr("Data of the case, and display settings of slices and 3D"), kPage),
                          tip);
  auto* button = new QPushButton(tr("Findings"));
  button->setToolTip(tip);
  button->setObjectName(QStringLiteral("toFindings"));
  layout_.path().check().add(button);
  auto* list = new FindingsList(model_);
  findings_ = &layout_.right().addSection(RightColumn::Place::Check, QStringLiteral("check"), tr("Findings"), list);
  layout_.right().addSection(RightColumn::Place::Check, QStringLiteral("difficulty"), tr("Difficulty"),
                             new DifficultyBox(model_));
  connect(button, &QPushButton::clicked, this, [this] { showCheck(true); });
  connect(list, &FindingsList::labelRequested, this,
          [this](int label) { layout_.path().labelPages().makeStructure(std::uint8_t(label)); });
  connect(&model_.measuring, &CaseMeasuring::changed, findings_, [this] { refresh(); });
  refresh();
}

void CheckFeature::showCheck(bool isShown) {
  layout_.right().showCheck(isShown);
  if (isShown) findings_->setOpen(true);
}

void CheckFeature::refresh() {
  const auto& measures = model_.measuring.measures();
  const bool isStopped = model_.measuring.state() == CaseMeasuring::State::Stopped;
  const QString count = measures ? findingCount(measures->findings) : QString();
  findings_->setRemark(count);
  layout_.path().check().setMark(measures    ? count
                                 : isStopped ? tr("not checked")
                                             : tr("checking ..."),
                                 !measures                              ? PathStep::State::Unknown
                                 : isFitForTraining(measures->findings) ? PathStep::State::Done
                                                                        : PathStep::State::Open);
}

}  // namespace insonate::prepare

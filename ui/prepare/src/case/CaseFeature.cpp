#include "CaseFeature.h"

#include "../layout/PathColumn.h"
#include "../layout/PrepareLayout.h"
#include "../layout/RightColumn.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "CaseFacts.h"
#include "VersionBanner.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>
#include <utility>

namespace insonate::prepare {

CaseFeature::CaseFeature(PrepareModel& model, PrepareLayout& layout) : Feature(model, layout) {
  auto* row = new QWidget;
  actions_ = new QHBoxLayout(row);
  actions_->setContentsMargins(0, 0, 0, 0);
  actions_->setSpacing(ui::kSmallGap);
  layout_.path().import().add(row);
  layout_.right().addSection(RightColumn::Place::Case, QStringLiteral("case"), tr("Case"), new CaseFacts(model_));
  auto* banner = new VersionBanner(model_.openCase);
  layout_.addBanner(banner);
  connect(banner, &VersionBanner::currentCaseRequested, this,
          [this](const QString& folder) { Q_EMIT layout_.workspace().caseRequested(folder); });
  connect(&model_.openCase, &OpenCase::originChanged, this, [this] { showOrigin(); });
  connect(&model_.openCase, &OpenCase::caseChanged, this, [this] { showOrigin(); });
  showOrigin();
}

void CaseFeature::setCaseActions(QAction* open, QAction* import, QAction* reload) {
  // Texts of the menu are long; the tooltips have the details.
  const std::pair<QAction*, QString> all[] = {{open, tr("Open")}, {import, tr("Import")}, {reload, tr("Reload")}};
  for (const auto& [action, word] : all) {
    QToolButton* button = actionButton(action, Qt::ToolButtonTextOnly);
    button->setText(word);
    connect(action, &QAction::changed, button, [button, text = word] { button->setText(text); });
    actions_->addWidget(button);
  }
  actions_->addStretch(1);
}

void CaseFeature::showOrigin() {
  const ui::CaseOrigin& origin = model_.openCase.origin();
  const bool isKept = origin.builtIn || origin.isDownloaded() || !origin.versionOf.isEmpty();
  const bool isOnDisk = model_.openCase.patient() && (isKept || !origin.folder.isEmpty());
  layout_.path().import().setMark(origin.builtIn                ? tr("built in")
                                  : origin.isDownloaded()       ? tr("downloaded")
                                  : !origin.versionOf.isEmpty() ? tr("kept version")
                                  : origin.folder.isEmpty()     ? tr("not saved")
                                                                : tr("done"),
                                  isOnDisk ? PathStep::State::Done : PathStep::State::Open);
}

}  // namespace insonate::prepare

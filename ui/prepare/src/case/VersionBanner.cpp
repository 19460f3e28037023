#include "VersionBanner.h"

#include "../model/OpenCase.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace insonate::prepare {

VersionBanner::VersionBanner(OpenCase& openCase)
    : openCase_(openCase), text_(new QLabel), open_(new QPushButton(tr("Open the current case"))) {
  setObjectName(QStringLiteral("versionBanner"));
  text_->setObjectName(QStringLiteral("versionText"));
  text_->setWordWrap(true);
  ui::setRole(open_, "primary");
  open_->setObjectName(QStringLiteral("openCurrent"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(ui::kGap, ui::kSmallGap, ui::kGap, ui::kSmallGap);
  row->setSpacing(ui::kGap);
  row->addWidget(text_, 1);
  row->addWidget(open_);
  connect(open_, &QPushButton::clicked, this, [this] { Q_EMIT currentCaseRequested(openCase_.origin().versionOf); });
  connect(&openCase_, &OpenCase::originChanged, this, [this] { refresh(); });
  connect(&openCase_, &OpenCase::caseChanged, this, [this] { refresh(); });
  refresh();
}

/// A downloaded case has no current state on this computer.
void VersionBanner::refresh() {
  const ui::CaseOrigin& origin = openCase_.origin();
  setVisible(openCase_.patient() && !origin.versionOf.isEmpty() && !origin.isDownloaded());
  const int number = openCase_.patient() ? openCase_.patient()->manifest.version.number : 0;
  text_->setText(
      tr("This is version %1 of the case, as it was saved then. Versions do not change: to edit or publish the "
         "case, open its current state.")
          .arg(number));
  open_->setToolTip(tr("Opens the case in %1, as it was saved last").arg(origin.versionOf));
}

}  // namespace insonate::prepare

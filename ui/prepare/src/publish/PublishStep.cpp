#include "PublishStep.h"

#include "../layout/PathColumn.h"
#include "../model/CaseChanges.h"
#include "../model/CaseMeasuring.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/ui/TaskBar.h>

#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

namespace insonate::prepare {

PublishStep::PublishStep(PrepareModel& shared, ui::TaskBar& tasks, PathStep& step)
    : shared_(shared), tasks_(tasks), step_(step), publish_(new QPushButton(tr("Publish"))) {
  publish_->setObjectName(QStringLiteral("publish"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(publish_);
  connect(publish_, &QPushButton::clicked, this, [this] { publish(); });
  for (const auto news : {&OpenCase::originChanged, &OpenCase::caseChanged})
    connect(&shared_.openCase, news, this, [this] { readVersions(); });
  // Reads the folder after a save, not after each edit.
  connect(&shared_.changes, &CaseChanges::changed, this, [this] {
    const bool saved = std::exchange(wasUnsaved_, shared_.changes.isUnsaved()) && !wasUnsaved_;
    saved ? readVersions() : refresh();
  });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { refresh(); });
  readVersions();
}

/// Reason why the case cannot be published now, with what to do; empty if it can.
QString PublishStep::obstacle() const {
  if (!shared_.openCase.patient()) return tr("There is no case.");
  const ui::CaseOrigin& origin = shared_.openCase.origin();
  if (origin.builtIn)
    return tr(
        "This case comes with Insonate: trainees have it already. To publish your own changes, save it to a folder of "
        "your own first (Ctrl+S).");
  if (origin.isDownloaded())
    return tr(
        "This case was downloaded from the server: to change it, save it to a folder of your own first (Ctrl+S).");
  if (!origin.versionOf.isEmpty())
    return tr("This is an earlier version: open the current case to publish a new version.");
  if (origin.folder.isEmpty() || shared_.changes.isUnsaved()) return tr("Save the case first (Ctrl+S).");
  const auto& measures = shared_.measuring.measures();
  if (!measures || shared_.measuring.state() != CaseMeasuring::State::Done) return tr("The case is not checked yet.");
  if (!isFitForTraining(measures->findings))
    return tr("The case is not fit for training: correct the errors that the check lists (C).");
  return {};
}

void PublishStep::refresh() {
  const QString why = obstacle();
  publish_->setEnabled(why.isEmpty());
  publish_->setToolTip(
      why.isEmpty() ? tr("Publishes the case as it is now; trainees get this version until you publish again") : why);
  using State = PathStep::State;
  const bool isBuiltIn = shared_.openCase.origin().builtIn;
  // Only the current case can be published.
  if (!shared_.openCase.origin().versionOf.isEmpty()) return step_.setMark(tr("open the current case"), State::Done);
  if (published_ == 0)
    return step_.setMark(isBuiltIn                     ? tr("built in")
                         : shared_.changes.isUnsaved() ? tr("save the case first")
                                                       : tr("not published"),
                         isBuiltIn ? State::Done : State::Open);
  if (isLatest_ && !shared_.changes.isUnsaved()) return step_.setMark(tr("version %1").arg(published_), State::Done);
  step_.setMark(tr("version %1; changed since").arg(published_), State::Open);
}

void PublishStep::readVersions() {
  const std::string folder = shared_.openCase.origin().folder.toStdString();
  published_ = folder.empty() ? 0 : publishedVersion(folder);
  const auto all = published_ == 0 ? std::vector<CaseVersion>() : versionsOf(folder);
  isLatest_ = !all.empty() && all.front().number == published_;
  refresh();
}

void PublishStep::publish() {
  using Published = CaseVersion;
  tasks_.run<Published>(
      tr("Publishing"),
      [folder = shared_.openCase.origin().folder.toStdString(), patient = shared_.openCase.patient()](
          const Progress& progress) { return publishCase(*patient, folder, today(), progress); },
      [self = QPointer(this)](Result<Published> version) {
        if (!self) return;
        // The versions that were saved before count, too: the first publication is hardly ever version 1.
        self->shared_.notice.showMessage(
            !version                ? QString::fromStdString(version.error().message)
            : self->published_ == 0 ? tr("The case is published: trainees use it as it is now from now on.")
                                    : tr("Trainees use version %1 of this case from now on.").arg(version->number));
        self->readVersions();
      },
      ui::TaskBar::WhenClosed::Ask);
}

}  // namespace insonate::prepare

#include "PublishStep.h"

#include "../PrepareSession.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/ui/TaskBar.h>

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

namespace insonate::prepare {

PublishStep::PublishStep(PrepareSession& session, ui::TaskBar& tasks, QLabel& mark, QWidget* parent)
    : QWidget(parent), session_(session), tasks_(tasks), mark_(mark), publish_(new QPushButton(tr("Publish"))) {
  publish_->setObjectName(QStringLiteral("publish"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->addWidget(publish_);
  connect(publish_, &QPushButton::clicked, this, [this] { publish(); });
  for (const auto news : {&PrepareSession::originChanged, &PrepareSession::caseChanged})
    connect(&session_, news, this, [this] { readVersions(); });
  // The folder is read where something was saved, not with each edit.
  connect(&session_, &PrepareSession::editsChanged, this, [this] {
    const bool saved = std::exchange(wasUnsaved_, session_.isUnsaved()) && !wasUnsaved_;
    saved ? readVersions() : refresh();
  });
  connect(&session_.measuring(), &CaseMeasuring::changed, this, [this] { refresh(); });
  readVersions();
}

/// Why the case cannot be published now, with what to do; empty where it can.
QString PublishStep::obstacle() const {
  if (!session_.patient()) return tr("There is no case.");
  const ui::CaseOrigin& origin = session_.origin();
  if (origin.builtIn) return tr("This neck comes with Insonate: trainees have it already.");
  if (!origin.versionOf.isEmpty()) return tr("This is an earlier version: open its case to publish another one.");
  if (origin.folder.isEmpty() || session_.isUnsaved()) return tr("Save the case first (Ctrl+S).");
  const auto& measures = session_.measuring().measures();
  if (!measures || session_.measuring().state() != CaseMeasuring::State::Done)
    return tr("The case is not checked yet.");
  if (!isFit(measures->findings)) return tr("The case is not fit for training: see the check (C).");
  return {};
}

void PublishStep::refresh() {
  const QString why = obstacle();
  publish_->setEnabled(why.isEmpty());
  publish_->setToolTip(why.isEmpty() ? tr("Trainees get the case as it is now, until you publish again") : why);
  if (published_ == 0) return mark_.setText(session_.origin().builtIn ? tr("built in") : tr("not yet"));
  const bool latest = isLatest_ && !session_.isUnsaved();
  mark_.setText(latest ? tr("version %1").arg(published_) : tr("version %1, not the latest").arg(published_));
}

void PublishStep::readVersions() {
  const std::string folder = session_.origin().folder.toStdString();
  published_ = folder.empty() ? 0 : publishedVersion(folder);
  const auto all = published_ == 0 ? std::vector<CaseVersion>() : versionsOf(folder);
  isLatest_ = !all.empty() && all.front().number == published_;
  refresh();
}

void PublishStep::publish() {
  using Published = CaseVersion;
  tasks_.run<Published>(
      tr("Publishing"),
      [folder = session_.origin().folder.toStdString(), patient = session_.patient()](const Progress& progress) {
        return publishCase(*patient, folder, today(), progress);
      },
      [self = QPointer(this)](Result<Published> version) {
        if (!self) return;
        self->session_.say(version ? tr("Trainees get version %1 from now on.").arg(version->number)
                                   : QString::fromStdString(version.error().message));
        self->readVersions();
      },
      ui::TaskBar::WhenClosed::Ask);
}

}  // namespace insonate::prepare

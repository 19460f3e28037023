#include "CaseFeature.h"

#include "../ReviewSession.h"
#include "../judge/JudgingController.h"
#include "../page/AttemptPage.h"

#include <insonate/ui/KnownCases.h>
#include <insonate/ui/Workspace.h>

#include <QStringList>
#include <optional>
#include <utility>

namespace insonate::review {
namespace {

/// Folder of the case's version on which an attempt was made; none if it was not kept.
std::optional<QString> keptVersion(const AttemptHeader& header) {
  return ui::placeOfVersion(QString::fromStdString(header.caseName), header.caseHash);
}

}  // namespace

CaseFeature::CaseFeature(const ReviewModel& model, AttemptPage& page) : Feature(model), page_(page) {
  connect(&model_.session, &ReviewSession::attemptChanged, this, [this] {
    keptRequested_ = false;
    // Called once the session knows whether the case in the window is that of the attempt.
    QMetaObject::invokeMethod(
        this, [this] { findCase(); }, Qt::QueuedConnection);
  });
  connect(&model_.session, &ReviewSession::caseChanged, this, [this] {
    QMetaObject::invokeMethod(
        this, [this] { openKeptVersion(); }, Qt::QueuedConnection);
    showNotice();
  });
  connect(&model_.judging, &JudgingController::changed, this, [this] { showNotice(); });
}

/// Asks once for each attempt: a user who keeps the open case is not asked again.
void CaseFeature::openKeptVersion() {
  if (model_.session.fit() != CaseFit::Changed || std::exchange(keptRequested_, true)) return;
  if (const auto kept = keptVersion(model_.session.attempt()->recording->header()))
    Q_EMIT model_.workspace.caseRequested(*kept);
}

/// Searches the built-in and the recent cases by title.
void CaseFeature::findCase() {
  const ReviewSession& session = model_.session;
  if (!session.attempt() || (session.fit() != CaseFit::Missing && session.fit() != CaseFit::Other)) return;
  const AttemptHeader& header = session.attempt()->recording->header();
  const QString title = QString::fromStdString(header.caseName);
  const auto kept = keptVersion(header);
  if (const auto place = kept ? kept : ui::findCaseLocation(title))
    return Q_EMIT model_.workspace.caseRequested(*place);
  Q_EMIT model_.workspace.failed(tr("The case '%1' of this attempt is not among the recent cases.").arg(title),
                                 tr("Open the case (Ctrl+O) to see hand movements and images; timeline and result are "
                                    "available without the case."),
                                 {});
}

void CaseFeature::showNotice() {
  const ReviewSession& session = model_.session;
  QStringList lines;
  if (session.attempt()) {
    if (model_.judging.isOther()) lines << model_.judging.words();
    if (session.fit() == CaseFit::Other || session.fit() == CaseFit::Changed) lines << session.message();
    for (const std::string& error : session.attempt()->errors) lines << QString::fromStdString(error);
    if (session.fit() == CaseFit::Changed)
      if (const auto kept = keptVersion(session.attempt()->recording->header()))
        lines << tr("The case version used in this attempt is still stored: open %1 (Ctrl+O) to see the images.")
                     .arg(*kept);
  }
  page_.setNotice(lines.join(QLatin1Char('\n')));
}

}  // namespace insonate::review

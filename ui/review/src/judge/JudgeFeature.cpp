#include "JudgeFeature.h"

#include "../ReviewSession.h"
#include "../page/AttemptPage.h"
#include "../replay/ReplayFeature.h"
#include "JudgePane.h"
#include "JudgingController.h"

#include <insonate/ui/Attempts.h>
#include <insonate/ui/Workspace.h>

#include <QToolButton>

namespace insonate::review {

JudgeFeature::JudgeFeature(const ReviewModel& model, AttemptPage& page, ReplayFeature& replay) : Feature(model) {
  model_.workspace.commands().beginSection(tr("Judge"));
  addForAttempt({.id = QStringLiteral("review.judge.show"),
                 .text = tr("Judge"),
                 .does = tr("shows checklists and ratings of this attempt in place of the 3D view, or hides them"),
                 .listed = tr("4"),
                 .keys = {{Qt::Key_4}},
                 .perform = [this](ui::KeyPress) { tab_->toggle(); }});
  tab_ = page.addToggle(QStringLiteral("review.judge.show"), "judgeTab", tr("Judge"));
  auto* pane = new JudgePane(model_.judging, ui::formDraftsFolder());
  page.setForms(pane);
  connect(tab_, &QToolButton::toggled, this, [&page, &replay](bool judges) {
    page.showForms(judges);
    // Judging refers to the replay.
    if (judges) replay.showImage();
  });
  connect(pane, &JudgePane::statusMessage, this, [this](const QString& sentence) {
    statusText_ = sentence;
    Q_EMIT model_.workspace.statusChanged();
  });
  connect(&model_.session, &ReviewSession::timeChanged, this, [this] {
    if (statusText_.isEmpty()) return;
    statusText_.clear();
    Q_EMIT model_.workspace.statusChanged();
  });
  connect(&model_.judging, &JudgingController::changed, this, [this, &page] {
    page.setTrainee(model_.judging.trainee());
    Q_EMIT readinessChanged();
  });
  connect(&model_.judging, &JudgingController::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT model_.workspace.failed(what, advice, {}); });
}

bool JudgeFeature::isReady() const {
  return !model_.judging.isReading();
}

}  // namespace insonate::review

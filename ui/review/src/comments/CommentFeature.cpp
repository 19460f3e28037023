#include "CommentFeature.h"

#include "../ReviewSession.h"
#include "../page/AttemptPage.h"
#include "../replay/ReplayFeature.h"
#include "../replay/Timeline.h"
#include "CommentList.h"
#include "CommentPane.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Workspace.h>

#include <utility>
#include <vector>

namespace insonate::review {

CommentFeature::CommentFeature(const ReviewModel& model, AttemptPage& page, ReplayFeature& replay)
    : Feature(model), controller_(model.session, model.judging) {
  addCommands();
  pane_ = new CommentPane(model_.session, controller_, model_.workspace.commands());
  page.addLeft(pane_);
  passKeysOf(pane_->list());
  connect(&controller_, &CommentController::changed, this, [this, &replay] {
    showOn(replay);
    Q_EMIT readinessChanged();
  });
  connect(&controller_, &CommentController::failed, this,
          [this](const QString& what, const QString& advice) { Q_EMIT model_.workspace.failed(what, advice, {}); });
}

void CommentFeature::addCommands() {
  ui::Commands& commands = model_.workspace.commands();
  commands.beginSection(tr("Comments"));
  commands.add({.id = QStringLiteral("review.comment.write"),
                .text = tr("Comment ..."),
                .does = tr("writes a comment for the trainee at the time shown"),
                .listed = tr("C"),
                .keys = {{Qt::Key_C}},
                .perform = [this](ui::KeyPress) { pane_->startWriting(); },
                .isAvailable = [this] { return controller_.mayWrite(); }});
  commands.add({.id = QStringLiteral("review.comment.remove"),
                .text = tr("Remove comment ..."),
                .does = tr("removes the selected comment after you confirm"),
                .listed = tr("Ctrl+Delete"),
                .keys = {{Qt::Key_Delete, Qt::ControlModifier}},
                .perform = [this](ui::KeyPress) { pane_->askRemoval(); },
                .isAvailable = [this] { return pane_->canRemove(); }});
  addStep(-1, Qt::Key_PageUp, tr("Previous comment"), tr("goes to the previous comment"));
  addStep(1, Qt::Key_PageDown, tr("Next comment"), tr("goes to the next comment"));
}

void CommentFeature::addStep(int by, int key, const QString& text, const QString& does) {
  model_.workspace.commands().add(
      {.id = by > 0 ? QStringLiteral("review.comment.next") : QStringLiteral("review.comment.previous"),
       .text = text,
       .does = does,
       .listed = by > 0 ? tr("Ctrl+Page Down") : tr("Ctrl+Page Up"),
       .keys = {{key, Qt::ControlModifier}},
       .perform = [this, by](ui::KeyPress) { pane_->list().step(by); },
       .isAvailable = [this] { return !controller_.comments().empty(); }});
}

void CommentFeature::showOn(ReplayFeature& replay) const {
  std::vector<TimelineComment> marks;
  for (const AttemptComment& one : controller_.comments())
    marks.push_back({one.at_us, tr("%1: %2").arg(ui::qt(one.author), ui::qt(one.text)), !one.isRead});
  replay.timeline().setComments(std::move(marks));
}

}  // namespace insonate::review

#include "CommentPane.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "CommentController.h"
#include "CommentList.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kText_px = 66, kList_px = 104;

}  // namespace

CommentPane::CommentPane(ReviewSession& session, CommentController& controller, const ui::Commands& commands,
                         QWidget* parent)
    : QWidget(parent),
      session_(session),
      controller_(controller),
      head_(ui::paragraph("commentWords", "heading")),
      time_(ui::paragraph("commentTime", "quiet")),
      list_(new CommentList(session)),
      field_(buildField()),
      question_(buildQuestion()),
      buttons_(buildButtons(commands)) {
  list_->setMinimumHeight(kList_px);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kSmallGap, ui::kSmallGap, ui::kSmallGap, ui::kSmallGap);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(head_);
  box->addWidget(list_, 1);
  box->addWidget(field_);
  box->addWidget(question_);
  box->addWidget(buttons_);
  connect(&controller_, &CommentController::changed, this, [this] { showController(); });
  connect(&controller_, &CommentController::written, this, [this](const std::string& attempt) {
    drafts_.erase(attempt);
    if (attempt != attempt_) return;
    text_->clear();
    closeField();
  });
  connect(&controller_, &CommentController::failed, this, [this] { save_->setEnabled(true); });
  connect(list_, &QListWidget::currentRowChanged, this, [this] { showChosen(); });
  showController();
}

QWidget* CommentPane::buildField() {
  auto* part = new QWidget;
  text_ = ui::named(
      new QPlainTextEdit, "commentText", tr("Text of the comment"),
      tr("Text of the comment, which the trainee can read. Enter saves the comment, Shift+Enter begins a new line"));
  text_->setTabChangesFocus(true);
  text_->setMaximumHeight(kText_px);
  text_->installEventFilter(this);
  save_ = ui::pushButton("saveComment", tr("Save"),
                         tr("Saves the comment at this time; the trainee can then read it (Enter)"));
  ui::setRole(save_, "primary");
  auto* cancel = ui::pushButton("cancelComment", tr("Cancel"),
                                tr("Closes the field without saving; the text stays in the field (Esc)"));
  auto* row = new QHBoxLayout;
  row->addWidget(save_);
  row->addWidget(cancel);
  row->addStretch(1);
  auto* box = new QVBoxLayout(part);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(time_);
  box->addWidget(text_);
  box->addLayout(row);
  connect(save_, &QPushButton::clicked, this, [this] { save(); });
  connect(cancel, &QPushButton::clicked, this, [this] { closeField(); });
  connect(text_, &QPlainTextEdit::textChanged, this,
          [this] { save_->setEnabled(!text_->toPlainText().trimmed().isEmpty()); });
  save_->setEnabled(false);
  part->hide();
  return part;
}

QWidget* CommentPane::buildQuestion() {
  auto* part = new QWidget;
  auto* remove =
      ui::pushButton("removeCommentNow", tr("Remove"), tr("Removes the text of the comment; this cannot be undone"));
  auto* keep = ui::pushButton("keepComment", tr("Cancel"), tr("Leaves the comment unchanged"));
  auto* row = new QHBoxLayout;
  row->addWidget(remove);
  row->addWidget(keep);
  row->addStretch(1);
  auto* box = new QVBoxLayout(part);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(ui::paragraph("commentQuestion", "", tr("Remove the selected comment?")));
  box->addLayout(row);
  connect(remove, &QPushButton::clicked, this, [this] { removeChosen(); });
  connect(keep, &QPushButton::clicked, this, [this] { closeQuestion(); });
  part->setFocusProxy(keep);
  part->hide();
  return part;
}

QWidget* CommentPane::buildButtons(const ui::Commands& commands) {
  auto* part = new QWidget;
  write_ = ui::pushButton("writeComment", tr("Comment ..."), commands.toolTip(QStringLiteral("review.comment.write")),
                          Qt::TabFocus);
  remove_ = ui::pushButton("removeComment", tr("Remove ..."), commands.toolTip(QStringLiteral("review.comment.remove")),
                           Qt::TabFocus);
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(write_);
  row->addWidget(remove_);
  row->addStretch(1);
  connect(write_, &QPushButton::clicked, this, [this] { startWriting(); });
  connect(remove_, &QPushButton::clicked, this, [this] { askRemoval(); });
  return part;
}

void CommentPane::showController() {
  if (attempt_ != controller_.attempt()) {
    keepDraft();
    attempt_ = controller_.attempt();
    text_->clear();
    closeField();
  }
  const auto& comments = controller_.comments();
  const auto unread = std::ranges::count(comments, false, &AttemptComment::isRead);
  QString words = comments.empty() ? tr("No comments") : tr("Comments: %1").arg(comments.size());
  if (unread > 0) words += (controller_.mayWrite() ? tr(", %1 unread by the trainee") : tr(", %1 unread")).arg(unread);
  head_->setText(words);
  list_->show(comments);
  list_->setVisible(!comments.empty());
  setVisible(controller_.mayWrite() || !comments.empty());
  showChosen();
}

bool CommentPane::canRemove() const {
  return list_->chosen() && controller_.mayRemove(*list_->chosen());
}

void CommentPane::showChosen() {
  closeQuestion();
  remove_->setEnabled(canRemove());
}

/// The buttons make room for the field and the question, which have their own.
void CommentPane::showButtons() {
  buttons_->setVisible(controller_.mayWrite() && field_->isHidden() && question_->isHidden());
}

void CommentPane::closeQuestion() {
  question_->hide();
  showButtons();
}

void CommentPane::startWriting() {
  if (!controller_.mayWrite()) return;
  session_.setPlaying(false);
  if (!field_->isVisible() || text_->toPlainText().trimmed().isEmpty()) at_us_ = session_.time_us();
  if (const auto draft = drafts_.find(attempt_); draft != drafts_.end() && !field_->isVisible()) {
    at_us_ = draft->second.at_us;
    text_->setPlainText(draft->second.text);
    text_->moveCursor(QTextCursor::End);
  }
  time_->setText(tr("Comment at %1").arg(clockOf(at_us_)));
  field_->show();
  closeQuestion();
  text_->setFocus();
}

void CommentPane::keepDraft() {
  if (field_->isHidden()) return;
  drafts_.erase(attempt_);
  if (!text_->toPlainText().trimmed().isEmpty()) drafts_[attempt_] = {at_us_, text_->toPlainText()};
}

void CommentPane::closeField() {
  keepDraft();
  const bool hadFocus = field_->isAncestorOf(window()->focusWidget());
  field_->hide();
  showButtons();
  if (hadFocus) list_->isVisible() ? list_->setFocus() : write_->setFocus();
}

void CommentPane::save() {
  if (!save_->isEnabled()) return;
  save_->setEnabled(false);  // until the store has answered
  controller_.write(at_us_, text_->toPlainText().trimmed());
}

void CommentPane::askRemoval() {
  if (!canRemove()) return;
  closeField();
  question_->show();
  showButtons();
  question_->setFocus();
}

void CommentPane::removeChosen() {
  closeQuestion();
  if (canRemove()) controller_.remove(*list_->chosen());
}

bool CommentPane::eventFilter(QObject* field, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (field != text_ || !isKey) return QWidget::eventFilter(field, event);
  const auto& press = *static_cast<QKeyEvent*>(event);
  const bool saves =
      (press.key() == Qt::Key_Return || press.key() == Qt::Key_Enter) && press.modifiers() != Qt::ShiftModifier;
  if (!saves && press.key() != Qt::Key_Escape) return false;
  event->accept();
  if (event->type() == QEvent::KeyPress) saves ? save() : closeField();
  return true;
}

}  // namespace insonate::review

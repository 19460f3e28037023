#pragma once

#include <QWidget>
#include <cstdint>
#include <map>
#include <string>

class QLabel;
class QListWidgetItem;
class QPlainTextEdit;
class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::review {

class CommentController;
class CommentList;
class ReviewSession;

/// The comments on the open attempt, below the moments. A click moves the time to a comment. An instructor can write a
/// comment at the present time. The author of a comment or an administrator can remove the comment after a
/// confirmation. The pane is hidden if the user can neither read nor write comments.
class CommentPane final : public QWidget {
  Q_OBJECT

 public:
  CommentPane(ReviewSession& session, CommentController& controller, const ui::Commands& commands,
              QWidget* parent = nullptr);

  CommentList& list() { return *list_; }
  /// Opens the field for a comment at the present time, with the text that was left unsaved.
  void startWriting();
  /// Asks the user whether to remove the selected comment.
  void askRemoval();
  bool canRemove() const;

 protected:
  /// Handles keys in the field: Enter saves, Shift+Enter begins a line, Esc closes the field. Backspace in the field
  /// never leaves the attempt.
  bool eventFilter(QObject* field, QEvent* event) override;

 private:
  /// A comment that is not saved yet.
  struct Draft {
    std::int64_t at_us = 0;
    QString text{};
  };

  QWidget* buildField();
  QWidget* buildQuestion();
  QWidget* buildButtons(const ui::Commands& commands);
  void showController();
  void showChosen();
  void showButtons();
  void closeQuestion();
  void closeField();
  void keepDraft();
  void save();
  void removeChosen();

  ReviewSession& session_;
  CommentController& controller_;
  QLabel *head_, *time_;
  CommentList* list_;
  QWidget *field_, *question_, *buttons_;
  QPlainTextEdit* text_;
  QPushButton *save_, *write_, *remove_;
  std::string attempt_;                  ///< attempt to which the text in the field belongs
  std::map<std::string, Draft> drafts_;  ///< unsaved comments, by id of the attempt
  std::int64_t at_us_ = 0;               ///< time of the comment in the field
};

}  // namespace insonate::review

#pragma once

#include <insonate/curriculum/CurriculumDraft.h>

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace insonate::ui {

/// Shows a curriculum's title and description, and its levels in order; levels can be added, copied, removed and moved.
class LevelList final : public QWidget {
  Q_OBJECT

 public:
  explicit LevelList(QWidget* parent = nullptr);

  void show(const Curriculum& curriculum, const std::vector<DraftError>& errors, bool editable);
  using QWidget::show;
  /// Level::name of the selected level; "": none.
  std::string chosen() const;

 Q_SIGNALS:
  void edited(const QString& field, const std::function<void(insonate::Curriculum&)>& change);
  void chosenChanged();

 private:
  QPushButton* button(const char* object, const QString& words, const QString& tip, void (LevelList::*act)());
  void add();
  void copy();
  void remove();
  void move(int by);
  void moveUp() { move(-1); }
  void moveDown() { move(1); }
  void choose(int row);
  void refresh();

  QLineEdit* title_;
  QPlainTextEdit* about_;
  QListWidget* list_;
  QPushButton *add_, *copy_, *remove_, *up_, *down_;
  bool editable_ = false;
};

}  // namespace insonate::ui

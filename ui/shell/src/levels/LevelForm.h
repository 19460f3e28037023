#pragma once

#include "LevelControls.h"

#include <QWidget>
#include <string>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;

namespace insonate::ui {

class MasteryEditor;
class StandardsEditor;

/// Editor of a level: names, case and procedure, prerequisites and rules.
class LevelForm final : public QWidget {
  Q_OBJECT

 public:
  explicit LevelForm(const TeachingNames& known, QWidget* parent = nullptr);

  void show(const Curriculum& curriculum, const Level& level, bool editable);
  using QWidget::show;

 Q_SIGNALS:
  void edited(const QString& field, const insonate::ui::LevelEdit& change);

 private:
  void buildNames(QFormLayout& form);
  void buildSetting(QFormLayout& form);
  void showPlace(const Level& level);
  void showPrerequisites(const Curriculum& curriculum, const Level& level);
  /// Stores the data of the selected entry in `member`.
  void addChoice(QComboBox* box, std::string Level::*member);

  const TeachingNames& known_;
  QLineEdit* title_;
  QPlainTextEdit* about_;
  QComboBox *case_, *procedure_, *position_, *assistance_;
  QListWidget* prerequisites_;
  StandardsEditor* standards_;
  MasteryEditor* mastery_;
};

}  // namespace insonate::ui

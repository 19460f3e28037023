#pragma once

#include <insonate/ui/FormDraft.h>
#include <insonate/ui/FormSending.h>

#include <QTimer>
#include <QWidget>
#include <memory>
#include <string>

class QLabel;
class QPushButton;
class QScrollArea;

namespace insonate::ui {
class Account;
class FormSheet;
}  // namespace insonate::ui

namespace insonate::train {

/// The built-in questionnaire about the simulator, answered by the signed-in user. Unsent answers are kept as a draft.
class QuestionnairePage final : public QWidget {
  Q_OBJECT

 public:
  QuestionnairePage(ui::Account* account, QString draftFolder, QWidget* parent = nullptr);
  ~QuestionnairePage() override;

 Q_SIGNALS:
  void messageReported(const QString& sentence);

 private:
  void changePerson();
  void keepDraft();
  void send();
  void clear();
  void sent(const QString& error);

  ui::Account* account_;
  const std::shared_ptr<ui::FormDraft> draft_;
  ui::FormSending sending_;
  QTimer keeping_;
  std::string person_;  ///< id of the user whose answers are shown; "": no user
  QLabel* words_;
  ui::FormSheet* sheet_;
  QScrollArea* scroll_;
  QPushButton *send_, *clear_;
};

}  // namespace insonate::train

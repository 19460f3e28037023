#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QScrollArea;
class QTreeWidget;

namespace insonate::prepare {

class GuideSession;

/// Lists the steps of the guide with their states. For the current step, the page also shows what to do, the result,
/// and how problems can be solved.
class GuidePage : public QWidget {
  Q_OBJECT

 public:
  explicit GuidePage(GuideSession& guide, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildWords();
  QWidget* buildButtons();
  void refresh();
  void refreshList();
  void refreshButtons();

  GuideSession& guide_;
  QTreeWidget* list_;
  QLabel *title_, *say_, *clicks_, *result_, *told_;
  QPushButton *run_, *accept_, *correct_, *skip_;
  QWidget* brush_;
  QScrollArea* words_;
};

}  // namespace insonate::prepare

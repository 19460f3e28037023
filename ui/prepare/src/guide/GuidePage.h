#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QScrollArea;
class QTreeWidget;

namespace insonate::prepare {

class GuideSession;

/// The steps of the guide with their states, and of the current one what to do, what came of it, and what can be done
/// about it.
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

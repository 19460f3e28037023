#pragma once

#include <QDialog>

namespace insonate::prepare {

struct KeptWork;

/// Asks whether unsaved work that was found is to be restored or discarded. Escape and "Later" leave the work as it is.
class RestoreQuestion : public QDialog {
  Q_OBJECT

 public:
  RestoreQuestion(const KeptWork& kept, QWidget* parent);

 Q_SIGNALS:
  void restoreChosen();
  void discardChosen();
  void laterChosen();
};

}  // namespace insonate::prepare

#pragma once

#include <insonate/ui/HandsChoice.h>

#include <QDialog>

namespace insonate::ui {

/// Asks at the first start with which devices the user moves probe and needle. Each answer has a drawn image.
class HandsDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit HandsDialog(QWidget* parent);

 Q_SIGNALS:
  void chosen(insonate::ui::HandsChoice choice);
};

}  // namespace insonate::ui

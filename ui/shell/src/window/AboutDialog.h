#pragma once

#include <QDialog>

namespace insonate::ui {

/// Shows name, version, license, libraries, and the limits of the program's intended use.
class AboutDialog : public QDialog {
 public:
  explicit AboutDialog(QWidget* parent);
};

}  // namespace insonate::ui

#pragma once

#include <QDialog>

namespace insonate::ui {

/// Name, version, license, libraries, and what the program is not.
class AboutDialog : public QDialog {
 public:
  explicit AboutDialog(QWidget* parent);
};

}  // namespace insonate::ui

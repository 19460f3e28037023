#pragma once

#include <insonate/ui/Commands.h>

#include <QDialog>
#include <vector>

class QListWidget;
class QTextBrowser;

namespace insonate::ui {

/// Non-modal window with the pages of resources/help and the list of keys.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent);

  void setShortcuts(const std::vector<ShortcutGroup>& groups);
  /// Shows the page with this file name; the first page if there is no such file.
  void showPage(const QString& name);
  void showKeys();
  QString shownText() const;

 private:
  void showRow(int row);
  /// Scrolls to the heading of the shown page to which a link with this anchor leads ("back-up" for "Back up").
  void showHeading(const QString& anchor);

  QListWidget* list_;
  QTextBrowser* page_;
  QString keys_;
};

}  // namespace insonate::ui

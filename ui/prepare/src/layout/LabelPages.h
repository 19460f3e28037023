#pragma once

#include <QWidget>
#include <functional>
#include <vector>

class QStackedWidget;
class QTabBar;

namespace insonate::prepare {

/// The pages of the label step. Only one page is shown at a time, since each page needs the column's height.
class LabelPages : public QWidget {
  Q_OBJECT

 public:
  /// Function that prepares a page to make a structure. Returns false if the page cannot make this label.
  using Make = std::function<bool(std::uint8_t label)>;

  LabelPages();

  void add(QWidget* page, const QString& title, const QString& tip, Make make);
  void showPage(QWidget* page);
  /// Shows another page in place of this one.
  void leavePage(QWidget* page);
  /// Shows the first page that can make a structure, and prepares the page for this structure.
  void makeStructure(std::uint8_t label);

 Q_SIGNALS:
  /// Emitted when the user has selected a page.
  void chosen();

 private:
  QTabBar* tabs_;
  QStackedWidget* stack_;
  std::vector<Make> makes_;
};

}  // namespace insonate::prepare

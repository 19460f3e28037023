#pragma once

#include <QWidget>
#include <vector>

class QToolButton;

namespace insonate::prepare {

class ToolSession;

/// The palette: one button for each tool, or for a group of them, which unfolds. The tool in hand is marked. Where
/// there is no room for all names, icons stand alone.
class ToolBar : public QWidget {
 public:
  explicit ToolBar(ToolSession& tools, QWidget* parent = nullptr);
  /// Names give way, so that the views beside it need not.
  QSize minimumSizeHint() const override { return {0, QWidget::minimumSizeHint().height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QToolButton* add(const QString& id, const QString& name, const QString& tip);
  void refresh();

  ToolSession& tools_;
  struct Entry {
    QToolButton* button;
    QStringList ids;  ///< of its tools; empty for the crosshair
  };
  std::vector<Entry> entries_;
};

/// The next tool of a key: the first, or where one of the group is in hand, the one after it. Empty for a key of none.
QString toolOfKey(int key, const QString& inHand);

}  // namespace insonate::prepare
